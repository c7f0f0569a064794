#pragma once

#include <Eigen/Core>
#include <cmath>

#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/perception/input/sensor_noise.hpp"

namespace polygonal_perception::perception {

/// How uncertain heights above the floor are: by the noise of a point, which moves it along its viewing ray, and by where
/// the floor itself may be.
class HeightNoise
{
public:
  /// @param floor             in the input's frame, up
  /// @param floor_covariance  of its normal's three components [1] and its distance [m]
  HeightNoise(const SensorNoise& sensor, const geometry::Plane& floor,
              const Eigen::Matrix4d& floor_covariance)
      : sensor_(sensor),
        normal_(floor.normal.cast<float>()),
        floor_covariance_(floor_covariance.cast<float>())
  {
  }

  /// [m] Standard deviation of a point's height; the point is in the input's frame.
  float sigma(const Eigen::Vector3f& point) const
  {
    const float range = point.norm();
    const float of_point = normal_.dot(point) / range * sensor_.at(range);
    const Eigen::Vector4f with_one(point.x(), point.y(), point.z(), 1.0F);
    return std::sqrt(of_point * of_point + with_one.dot(floor_covariance_ * with_one));
  }

private:
  SensorNoise sensor_;
  Eigen::Vector3f normal_;
  Eigen::Matrix4f floor_covariance_;
};

}  // namespace polygonal_perception::perception
