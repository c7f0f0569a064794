#pragma once

#include <Eigen/Geometry>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/perception/floor/view_axes.hpp"

namespace polygonal_perception::perception {

/// The transform M of section IV: from the input's frame into the floor frame, whose origin lies on the floor
/// under the input frame's origin, whose x axis is the camera's forward direction along the floor and whose z
/// axis is up.
///
/// The rotation is built from cross products of vectors that cannot be parallel, so that it exists for every
/// floor, an exactly level one included (the paper's axis-angle form divides by zero there).
///
/// @param floor  unit normal, up
/// @param view   where the camera looks. For one that looks straight down, to about 3 degrees, the image's upward
///               direction is ahead.
POLYGONAL_PERCEPTION_EXPORT Eigen::Isometry3d floorFrame(const geometry::Plane& floor, const ViewAxes& view);

/// How uncertain a floor is about the axes of its frame.
/// @param covariance      of the normal's three components [1] in the input's frame and the distance [m]
/// @param to_floor_frame  from the input's frame
/// @return of the tilt about the floor frame's x axis [rad], about its y axis [rad], and of the distance [m]
POLYGONAL_PERCEPTION_EXPORT Eigen::Matrix3d tiltCovariance(const Eigen::Matrix4d& covariance,
                                                           const Eigen::Isometry3d& to_floor_frame);

}  // namespace polygonal_perception::perception
