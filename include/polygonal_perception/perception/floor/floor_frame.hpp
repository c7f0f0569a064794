#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"
#include "polygonal_perception/perception/planes/sample_grid.hpp"

namespace polygonal_perception::perception {

/// The transform M of section IV: from the input's frame into the floor frame, whose origin lies on the floor
/// under the input frame's origin, whose x axis is the camera's forward direction along the floor and whose z
/// axis is up.
///
/// The rotation is built from cross products of vectors that cannot be parallel, so that it exists for every
/// floor, an exactly level one included (the paper's axis-angle form divides by zero there).
///
/// @param floor    unit normal, up
/// @param forward  the camera's viewing direction in the input's frame, any length. Where it is within about
///                 1 degree of the floor's normal (a camera that looks straight down or up), the input axis
///                 that is nearest to the floor plane stands in for it.
POLYGONAL_PERCEPTION_EXPORT Eigen::Isometry3d floorFrame(const geometry::Plane& floor,
                                                         const Eigen::Vector3d& forward);

/// How uncertain a floor is about the axes of its frame.
/// @param covariance      of the normal's three components [1] in the input's frame and the distance [m]
/// @param to_floor_frame  from the input's frame
/// @return of the tilt about the floor frame's x axis [rad], about its y axis [rad], and of the distance [m]
POLYGONAL_PERCEPTION_EXPORT Eigen::Matrix3d tiltCovariance(const Eigen::Matrix4d& covariance,
                                                           const Eigen::Isometry3d& to_floor_frame);

/// The camera's forward direction in the input's frame: z for a depth image, whose frame is an optical one.
/// For a cloud the frame's axis that has all returns ahead of it, for a camera looks at nothing that is behind
/// it: z in an optical frame (REP 103), x in a body frame, and nobody has to say which. z comes first and then
/// x, so that a wide view with returns on one side only does not turn it. Other axes stand in only where they
/// are not vertical: a camera that looks steeply down sees everything along "down" in a frame that is kept
/// level. Where no axis has all of them ahead, it is the one along which they lie in the mean.
///
/// @param up  the floor's normal, or what is known of up without a floor; any length
/// @return a unit axis, or nothing where no sample has a point
POLYGONAL_PERCEPTION_EXPORT std::optional<Eigen::Vector3d> forwardAxis(const PointView& points,
                                                                       const SampleGrid& samples,
                                                                       const Eigen::Vector3d& up);

}  // namespace polygonal_perception::perception
