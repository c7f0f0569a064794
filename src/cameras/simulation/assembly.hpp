#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "polygonal_perception/cameras/simulation/random.hpp"
#include "polygonal_perception/cameras/simulation/solid.hpp"

namespace polygonal_perception::simulation {

/// Builds a thing out of solids in its own frame, which stands somewhere in the world.
class Assembly
{
public:
  explicit Assembly(std::vector<Solid>& solids, const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity())
      : solids_(&solids), pose_(pose)
  {
  }

  /// The same with its origin at a point of this frame, turned about z.
  Assembly at(double x, double y, double yaw = 0.0, double z = 0.0) const
  {
    return Assembly(*this,
                    pose_ * Eigen::Translation3d(x, y, z) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
  }
  /// The same, tilted: turned about any axis of this frame.
  Assembly turned(double angle, const Eigen::Vector3d& axis) const
  {
    return Assembly(*this, pose_ * Eigen::AngleAxisd(angle, axis));
  }
  Assembly of(Surface surface) const
  {
    Assembly other = *this;
    other.surface_ = surface;
    return other;
  }
  Assembly reflecting(double reflectance) const
  {
    Assembly other = *this;
    other.reflectance_ = static_cast<float>(reflectance);
    return other;
  }

  /// A box between two corners.
  void box(const Eigen::Vector3d& low, const Eigen::Vector3d& high) const
  {
    add(makeBox(pose_ * Eigen::Translation3d(0.5 * (low + high)), high - low));
  }
  void cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) const
  {
    frustum(from, to, radius, radius);
  }
  void frustum(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_from,
               double radius_to) const
  {
    add(makeFrustum(pose_ * from, pose_ * to, radius_from, radius_to));
  }
  void ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& radii) const
  {
    add(makeEllipsoid(pose_ * Eigen::Translation3d(centre), radii));
  }

private:
  Assembly(const Assembly& other, const Eigen::Isometry3d& pose) : Assembly(other) { pose_ = pose; }

  void add(Solid solid) const
  {
    solid.surface = surface_;
    solid.reflectance = reflectance_;
    solids_->push_back(std::move(solid));
  }

  std::vector<Solid>* solids_;
  Eigen::Isometry3d pose_;
  Surface surface_ = Surface::kObstacle;
  float reflectance_ = 0.6F;
};

}  // namespace polygonal_perception::simulation
