#pragma once

#include <polygonal_perception/FloorPlane.h>
#include <polygonal_perception/Plane.h>

#include <Eigen/Core>
#include <vector>

/// What a FloorPlane or a Plane says, as geometry to draw. A display draws what any node publishes: nothing is taken on
/// trust here.
namespace polygonal_perception::displays {

/// Whether the normal is a unit vector and the distance and the hull are finite.
bool isDrawable(const FloorPlane& floor);

/// The point of the plane under the frame's origin. @pre isDrawable
Eigen::Vector3d footOf(const FloorPlane& floor);

/// @pre isDrawable
std::vector<Eigen::Vector3d> hullOf(const FloorPlane& floor);

/// A square on the plane, around the middle of the hull or, without a hull, under the frame's origin; one
/// pair of its sides runs as the camera looks. Counter-clockwise from above. @pre isDrawable
///
/// @param size  [m] length of a side
std::vector<Eigen::Vector3d> patchOf(const FloorPlane& floor, double size);

/// Whether the normal is a unit vector and distance and boundary are finite, with at least three points.
bool isDrawable(const Plane& plane);

/// The points of the boundary. @pre isDrawable
std::vector<Eigen::Vector3d> boundaryOf(const Plane& plane);

/// The area inside of the boundary, three corners a triangle. @pre isDrawable
std::vector<Eigen::Vector3d> trianglesOf(const Plane& plane);

}  // namespace polygonal_perception::displays
