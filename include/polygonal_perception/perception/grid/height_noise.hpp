#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/perception/input/sensor_noise.hpp"

namespace polygonal_perception::perception {

/// How uncertain the heights of the floor's own points are, by where they lie in the floor frame.
class FloorPointNoise
{
public:
  /// @param sensor_height  [m] above the floor
  /// @param covariance     of the height, as a quadratic form in (x, y, 1)
  FloorPointNoise(const SensorNoise& sensor, float sensor_height, const Eigen::Matrix3f& covariance)
      : sensor_(sensor), sensor_height_(sensor_height), covariance_(covariance)
  {
  }

  const SensorNoise& sensor() const { return sensor_; }
  float sensorHeight() const { return sensor_height_; }
  const Eigen::Matrix3f& covariance() const { return covariance_; }

private:
  SensorNoise sensor_;
  float sensor_height_;
  Eigen::Matrix3f covariance_;
};

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

  /// The same for points on the floor, by where they lie.
  FloorPointNoise onFloor(const Eigen::Isometry3d& to_floor_frame) const
  {
    const Eigen::Isometry3f back = to_floor_frame.inverse().cast<float>();
    // (x, y, 0) of the floor frame as a point of the input's frame with a one after it.
    Eigen::Matrix<float, 4, 3> point;
    point << back.linear().leftCols<2>(), back.translation(), 0.0F, 0.0F, 1.0F;
    return {sensor_, static_cast<float>(to_floor_frame.translation().z()),
            point.transpose() * floor_covariance_ * point};
  }

private:
  SensorNoise sensor_;
  Eigen::Vector3f normal_;
  Eigen::Matrix4f floor_covariance_;
};

}  // namespace polygonal_perception::perception
