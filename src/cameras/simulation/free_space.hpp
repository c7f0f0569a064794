#pragma once

#include <Eigen/Core>
#include <vector>

#include "polygonal_perception/cameras/simulation/scene.hpp"

namespace polygonal_perception::simulation {

/// Where a camera, or a robot under it, may be.
class FreeSpace
{
public:
  /// @param radius  of the robot or of the air around the camera [m]
  /// @param low,high  heights that must be free [m]
  FreeSpace(const Scene& scene, double radius, double low, double high);

  /// On the robot's floor, and nothing nearer than the radius, nor anybody who walks, ever.
  bool contains(const Eigen::Vector2d& point) const;
  bool containsSegment(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

private:
  /// What must stay at a distance, with a circle around it that rules most of it out at once.
  struct Hindrance
  {
    Outline outline;
    double distance;
    Eigen::Vector2d centre;
    double reach;
  };
  void add(Outline outline, double distance);

  const Scene* scene_;
  std::vector<Hindrance> hindrances_;
};

}  // namespace polygonal_perception::simulation
