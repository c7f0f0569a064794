#pragma once

#include <Eigen/Geometry>
#include <Eigen/StdVector>
#include <array>
#include <cstdint>
#include <vector>

#include "polygonal_perception/export.hpp"

namespace polygonal_perception::simulation {

/// What a ray hit.
enum class Surface : std::uint8_t
{
  kNone = 0,        ///< nothing
  kFloor = 1,       ///< the floor that the robot stands on, z = 0 in the world frame
  kLowerFloor = 2,  ///< what lies below it: steps, a lower storey
  kObstacle = 3,    ///< everything else, walls included
  kGround = 4       ///< what a robot can drive up to from the floor: ramps and what they lead to
};

/// A convex polygon on the floor [m], counter-clockwise seen from above.
using Outline = std::vector<Eigen::Vector2d>;

/// A convex body (or a flat convex polygon) made of triangles, in the world frame [m].
struct Solid
{
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  Surface surface = Surface::kObstacle;
  float reflectance = 0.6F;  ///< of infra-red light, 0..1; dark surfaces are seen only from close by
  bool curved = false;       ///< its triangles stand for a curved surface
};

/// A box of the given edge lengths, centred at the origin of `pose`.
POLYGONAL_PERCEPTION_EXPORT Solid makeBox(const Eigen::Isometry3d& pose, const Eigen::Vector3d& size);
/// A cone frustum (a cylinder for equal radii) between two points.
POLYGONAL_PERCEPTION_EXPORT Solid makeFrustum(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                              double radius_from, double radius_to);
/// An ellipsoid with semi-axes `radii` along the axes of `pose`.
POLYGONAL_PERCEPTION_EXPORT Solid makeEllipsoid(const Eigen::Isometry3d& pose, const Eigen::Vector3d& radii);
/// A level rectangle at height z, facing up.
POLYGONAL_PERCEPTION_EXPORT Solid makeLevelRectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                                                     double z);

/// The exact footprint of the part of a solid between two heights [m], fewer than 3 vertices where it is a
/// line; empty where it has none.
POLYGONAL_PERCEPTION_EXPORT Outline footprint(const Solid& solid, double min_height, double max_height);
/// The distance of a point from a convex polygon [m], 0 inside.
POLYGONAL_PERCEPTION_EXPORT double distanceTo(const Outline& outline, const Eigen::Vector2d& point);

}  // namespace polygonal_perception::simulation
