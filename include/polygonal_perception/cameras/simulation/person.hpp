#pragma once

#include <Eigen/Core>
#include <vector>

#include "polygonal_perception/cameras/simulation/solid.hpp"
#include "polygonal_perception/export.hpp"

namespace polygonal_perception::simulation {

/// A standing or striding person.
struct PersonPose
{
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  double yaw = 0.0;                                    ///< [rad]
  double stature = 1.75;                               ///< [m]
  double stride = 0.0;                                 ///< [rad] phase of the gait, 2 pi for two steps
  double stride_amplitude = 0.0;                       ///< [rad] swing of the thigh, 0 = standing
};

/// Appends the solids of a person.
POLYGONAL_PERCEPTION_EXPORT void addPerson(std::vector<Solid>& solids, const PersonPose& pose);

/// A person who walks to and fro between two points.
struct POLYGONAL_PERCEPTION_EXPORT Walker
{
  Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d to = Eigen::Vector2d::Zero();    ///< [m]
  double speed = 1.1;                              ///< [m/s]
  double start = 0.0;                              ///< [m] the way already gone at time 0
  double stature = 1.75;                           ///< [m]

  PersonPose at(double time) const;
};

}  // namespace polygonal_perception::simulation
