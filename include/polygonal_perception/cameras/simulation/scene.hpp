#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "polygonal_perception/cameras/simulation/person.hpp"
#include "polygonal_perception/cameras/simulation/solid.hpp"
#include "polygonal_perception/export.hpp"

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

/// A world to look at: x and y along the robot's floor, z = 0 on it, z up.
struct POLYGONAL_PERCEPTION_EXPORT Scene
{
  std::string name;
  std::vector<Solid> solids;         ///< what stands still
  std::vector<Walker> walkers;       ///< people who walk
  std::vector<Outline> floor;        ///< where the robot's floor is; convex pieces
  std::vector<ViewArea> view_areas;  ///< at least one

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

/// Lays a scene out. Another seed moves, swaps and resizes everything in it.
/// @throws std::invalid_argument when there is no scene of that name
POLYGONAL_PERCEPTION_EXPORT Scene makeScene(const std::string& name, std::uint64_t seed);

}  // namespace polygonal_perception::simulation
