#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "polygonal_perception/cameras/simulation/pinhole_camera.hpp"
#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::benchmarks {

/// The shapes in which camera drivers publish a frame.
enum class Input
{
  kCloud16,           ///< 16 bytes a point, as depth_image_proc/point_cloud_xyz publishes them
  kCloud32,           ///< 32 bytes a point, as coloured clouds have
  kDepthMillimetres,  ///< 16UC1
  kDepthMetres        ///< 32FC1
};

const char* nameOf(Input input);

/// A simulated frame in each of these shapes.
class CameraFrame
{
public:
  /// @param depth  [m], NaN where there is no return
  CameraFrame(const simulation::PinholeCamera& camera, const std::vector<float>& depth,
              const geometry::Plane& floor);
  CameraFrame(const CameraFrame&) = delete;
  CameraFrame(CameraFrame&&) = delete;
  CameraFrame& operator=(const CameraFrame&) = delete;
  CameraFrame& operator=(CameraFrame&&) = delete;
  ~CameraFrame() = default;

  perception::PointView view(Input input) const;

  /// The memory of a cloud.
  const std::vector<float>& cloud16() const { return cloud16_; }
  const std::vector<float>& cloud32() const { return cloud32_; }
  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }
  /// The true floor, in the optical frame.
  const geometry::Plane& floor() const { return floor_; }

private:
  std::uint32_t width_;
  std::uint32_t height_;
  geometry::Plane floor_;
  perception::PinholeRays rays_;
  std::vector<std::uint16_t> millimetres_;
  std::vector<float> metres_;
  std::vector<float> cloud16_;
  std::vector<float> cloud32_;
};

/// What the camera looks at.
enum class Surroundings
{
  kOffice,  ///< desks, chairs, cupboards, things on the floor
  kEmpty    ///< nothing but a floor
};

/// Time between the frames of a drive [s].
constexpr double kFramePeriod = 1.0 / 3.0;

/// What a camera on a wheeled robot sees, `count` frames of a drive, with the noise of an Xtion.
std::vector<std::unique_ptr<CameraFrame>> drive(Surroundings surroundings, std::uint32_t width,
                                                std::uint32_t height, std::uint32_t count);

}  // namespace polygonal_perception::benchmarks
