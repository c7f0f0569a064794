// What height_sigmas costs and what it is worth, in tables in markdown. Run through scripts/evaluate_heights.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "polygonal_perception/perception/floor/floor_frame.hpp"
#include "polygonal_perception/perception/grid/projection.hpp"

namespace polygonal_perception::evaluation {
namespace {

using perception::SensorNoise;

constexpr double kCameraHeight = 0.8;  // [m]
constexpr double kPitch = 0.35;        // [rad]
constexpr double kFarthest = 6.0;      // [m] of depth

struct Sensor
{
  std::string name;
  SensorNoise noise;
};
const std::vector<Sensor> kSensors = {{"xtion", *SensorNoise::preset("xtion")},
                                      {"realsense_d435", *SensorNoise::preset("realsense_d435")},
                                      // What elevation_mapping has for a RealSense ZR300
                                      {"2.4 mm + 6.6 mm (z - 0.77)^2", {0.00631, -0.01016, 0.0066}},
                                      {"time_of_flight", *SensorNoise::preset("time_of_flight")}};
const std::vector<double> kSigmas = {0.0, 2.0, 3.0, 4.0, 5.0};

geometry::Plane cameraFloor()
{
  return {Eigen::Vector3d(0.0, -std::cos(kPitch), -std::sin(kPitch)), kCameraHeight};
}

/// [m] The lowest point that stands at a distance along the floor.
double leastHeight(const SensorNoise& sensor, double sigmas, double distance)
{
  const geometry::Plane floor = cameraFloor();
  const perception::HeightNoise noise(sensor, floor, Eigen::Matrix4d::Zero());
  const Eigen::Isometry3d from_floor = perception::floorFrame(floor, perception::ViewAxes{}).inverse();
  for (double height = perception::Projection::Parameters{}.min_height;; height += 0.001) {
    const Eigen::Vector3d point = from_floor * Eigen::Vector3d(distance, 0.0, height);
    if (height > sigmas * noise.sigma(point.cast<float>())) return height;
  }
}

/// A bare floor with noise whose neighbours within about `patch` pixels err alike; 1: each pixel on its own.
std::vector<float> noisyFloor(const perception::PinholeRays& rays, const SensorNoise& sensor, int patch,
                              std::uint64_t seed)
{
  const auto columns = static_cast<int>(rays.column_slope.size());
  const auto rows = static_cast<int>(rays.row_slope.size());
  cv::Mat_<float> noise(rows, columns);
  cv::RNG random(seed);
  random.fill(noise, cv::RNG::NORMAL, 0.0, 1.0);
  if (patch > 1) {
    constexpr double kWidthOfSigma = 2.35;  // full width at half of a Gaussian
    cv::GaussianBlur(noise, noise, cv::Size(), patch / kWidthOfSigma);
    cv::Scalar mean, deviation;
    cv::meanStdDev(noise, mean, deviation);
    noise /= deviation[0];
  }
  const geometry::Plane floor = cameraFloor();
  std::vector<float> depth;
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < columns; ++u) {
      const Eigen::Vector3d ray(rays.column_slope[static_cast<std::size_t>(u)],
                                rays.row_slope[static_cast<std::size_t>(v)], 1.0);
      const double z = -floor.distance / floor.normal.dot(ray);
      const bool is_seen = z > 0.0 && z < kFarthest;
      depth.push_back(is_seen ? static_cast<float>(z) +
                                    noise(v, u) * sensor.at(static_cast<float>(z * ray.norm()))
                              : 0.0F);
    }
  }
  return depth;
}

/// Cells that noise alone occupies, a frame in the mean.
double falseCells(const SensorNoise& sensor, double sigmas, int patch)
{
  constexpr int kFrames = 20;
  const perception::PinholeRays rays = perception::PinholeRays::make(640, 480, 570.3, 570.3, 319.5, 239.5);
  perception::Projection::Parameters parameters;
  parameters.height_sigmas = sigmas;
  perception::Projection projection(parameters);
  occupancy::BinaryGrid grid{occupancy::GridGeometry(occupancy::GridParameters{})};
  const geometry::Plane floor = cameraFloor();
  const perception::HeightNoise noise(sensor, floor, Eigen::Matrix4d::Zero());
  std::size_t cells = 0;
  for (std::uint64_t seed = 1; seed <= kFrames; ++seed) {
    const std::vector<float> depth = noisyFloor(rays, sensor, patch, seed);
    const perception::PointView view =
        perception::PointView::depth(depth.data(), rays.column_slope.size() * sizeof(float), rays);
    projection.project(view, perception::floorFrame(floor, perception::ViewAxes{}), grid, {&noise, nullptr});
    cells += grid.count();
  }
  return static_cast<double>(cells) / kFrames;
}

void printSigmas(const char* first)
{
  std::printf("| sensor | %s |", first);
  for (const double sigmas : kSigmas) std::printf(" %g |", sigmas);
  std::printf("\n| --- | --: |");
  for (std::size_t k = 0; k < kSigmas.size(); ++k) std::printf(" --: |");
  std::printf("\n");
}

void printLeastHeights()
{
  std::printf(
      "## The lowest point that is an obstacle [cm], by distance along the floor and height_sigmas\n\n");
  printSigmas("distance [m]");
  for (const Sensor& sensor : kSensors) {
    for (const double distance : {1.0, 2.0, 3.0, 4.0, 5.0}) {
      std::printf("| %s | %g |", sensor.name.c_str(), distance);
      for (const double sigmas : kSigmas)
        std::printf(" %.1f |", 100.0 * leastHeight(sensor.noise, sigmas, distance));
      std::printf("\n");
    }
  }
}

void printFalseCells()
{
  std::printf("\n## Cells that noise alone occupies on a bare floor, a frame, by height_sigmas\n\n");
  printSigmas("neighbours err alike within [px]");
  for (const Sensor& sensor : kSensors) {
    for (const int patch : {1, 7}) {
      std::printf("| %s | %d |", sensor.name.c_str(), patch);
      for (const double sigmas : kSigmas) std::printf(" %.1f |", falseCells(sensor.noise, sigmas, patch));
      std::printf("\n");
    }
  }
}

}  // namespace
}  // namespace polygonal_perception::evaluation

int main()
{
  polygonal_perception::evaluation::printLeastHeights();
  polygonal_perception::evaluation::printFalseCells();
  return EXIT_SUCCESS;
}
