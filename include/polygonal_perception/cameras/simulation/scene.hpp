#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "polygonal_perception/cameras/simulation/person.hpp"
#include "polygonal_perception/cameras/simulation/solid.hpp"
#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/plane.hpp"

namespace polygonal_perception::simulation {

/// Where a camera may look from to see what a scene is about: a rectangle turned by `yaw`, and headings
/// around `yaw`.
struct ViewArea
{
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();     ///< [m]
  Eigen::Vector2d half_size = Eigen::Vector2d::Zero();  ///< [m] along and across yaw
  double yaw = 0.0;                                     ///< [rad]
  double yaw_spread = 0.0;                              ///< [rad] headings are yaw +- this
  double min_camera_height = 0.2;                       ///< [m]
  double max_camera_height = 1.5;                       ///< [m]
};

/// A place on a robot's way.
struct Waypoint
{
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  double yaw = 0.0;                                    ///< [rad]
};

/// A piece of ground that is no part of the floor: a ramp, or what it leads to.
struct Ground
{
  Outline outline;        ///< as seen from above
  geometry::Plane plane;  ///< in the world frame, its normal upwards
};

/// A world to look at: x and y along the robot's floor, z = 0 on it, z up.
struct POLYGONAL_PERCEPTION_EXPORT Scene
{
  std::string name;
  std::vector<Solid> solids;         ///< what stands still
  std::vector<Walker> walkers;       ///< people who walk
  std::vector<Outline> floor;        ///< where the robot's floor is; convex pieces
  std::vector<ViewArea> view_areas;  ///< at least one
  std::vector<Ground> grounds;       ///< on which a robot can drive beside the floor
  std::vector<Waypoint> way;         ///< of a robot that drives through a course; empty in the other scenes

  /// The height [m] of the ground at a place: 0 unless it is one of `grounds`.
  double groundHeight(const Eigen::Vector2d& place) const;

  /// The people as they are at a time [s]. Each call gives the same triangles with moved vertices.
  void walkersAt(double time, std::vector<Solid>& people) const;

  /// Ground truth: the outlines of everything that reaches into a band of heights [m] at a time [s]. They may
  /// overlap.
  std::vector<Outline> obstacles(double time, double min_height, double max_height) const;
};

/// The kinds of scenes: corridor, office, busy_office (somebody walks about in it), person, table_top, wall,
/// doorway; stairs, ledge (the robot's floor ends); dais, pallet, kerb, threshold, ramp, carpet (something level
/// is raised by 3 to 28 cm and fills much of the view).
POLYGONAL_PERCEPTION_EXPORT const std::vector<std::string>& sceneNames();

/// Scenes with a way that a robot drives, over more than the floor. ramps: along a wall, through a door, up a ramp,
/// down another, up a kerb ramp and up to a wall, and back.
POLYGONAL_PERCEPTION_EXPORT const std::vector<std::string>& courseNames();

/// Lays a scene or a course out. Another seed moves, swaps and resizes everything in it.
/// @throws std::invalid_argument when there is no scene of that name
POLYGONAL_PERCEPTION_EXPORT Scene makeScene(const std::string& name, std::uint64_t seed);

}  // namespace polygonal_perception::simulation
