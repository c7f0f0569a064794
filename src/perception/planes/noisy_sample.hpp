#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/perception/planes/plane_extraction_parameters.hpp"
#include "polygonal_perception/perception/planes/sample_grid.hpp"

namespace polygonal_perception::perception {

/// A sample with what is known of its error.
struct NoisySample
{
  Eigen::Vector3f point;
  Eigen::Vector3f normal;
  float range = 0.0F;               // [m]
  float relative_noise = 0.0F;      // standard deviation of its depth over its range
  float model_variance = 0.0F;      // [m^2] of what the noise does not hold
  float noise_along_normal = 0.0F;  // [m] standard deviation of its depth, along its own normal
  bool has_point = false;
  bool has_normal = false;
  bool begins_row = false;
  bool ends_row = false;

  /// Variance of its distance from a plane [m^2].
  /// @param along        [m] normal . point, for a unit normal
  /// @param model_share  of the model's error that comes into question
  float variance(float along, float model_share = 1.0F) const
  {
    const float noise = relative_noise * along;
    return noise * noise + model_share * model_share * model_variance;
  }
};

/// A plane that samples are held against.
struct ReferencePlane
{
  explicit ReferencePlane(const geometry::Plane& plane)
      : ReferencePlane(plane.normal.cast<float>(), static_cast<float>(plane.distance))
  {
  }
  ReferencePlane(const Eigen::Vector3f& unit_normal, float offset) : normal(unit_normal), distance(offset) {}

  float height(const Eigen::Vector3f& point) const { return normal.dot(point) + distance; }

  /// The square of a sample's distance in standard deviations.
  float deviation(const NoisySample& sample, float model_share = 1.0F) const
  {
    const float along = normal.dot(sample.point);
    const float height = along + distance;
    return height * height / sample.variance(along, model_share);
  }

  Eigen::Vector3f normal;
  float distance;
};

/// The samples of a grid, row by row.
struct NoisySamples
{
  std::vector<NoisySample> all;
  std::uint32_t columns = 0;

  const NoisySample& operator[](std::size_t k) const { return all[k]; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(all.size()); }

  void take(const SampleGrid& grid, const PlaneExtractionParameters& parameters)
  {
    constexpr float kNoLess = 1e-3F;  // [m] keeps a point in the camera's centre from a division by zero
    columns = static_cast<std::uint32_t>(grid.samplesX());
    all.resize(grid.samples().size());
    const auto error = static_cast<float>(parameters.model_error);
    const auto slope = static_cast<float>(parameters.model_error_slope);
    std::uint32_t column = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Sample& from = grid.samples()[k];
      NoisySample& sample = all[k];
      sample.has_point = from.has_point;
      sample.has_normal = from.has_normal;
      sample.begins_row = column == 0;
      column = column + 1 == columns ? 0 : column + 1;
      sample.ends_row = column == 0;
      if (!from.has_point) continue;
      sample.point = from.point;
      sample.normal = from.normal;
      sample.range = std::max(kNoLess, from.point.norm());
      sample.relative_noise = parameters.noise.at(sample.range) / sample.range;
      const float model = error + slope * sample.range;
      sample.model_variance = model * model;
      sample.noise_along_normal = sample.relative_noise * std::abs(from.normal.dot(from.point));
    }
  }

  /// Calls visit(k, neighbour) for each pair of neighbours in a row or a column, once.
  template <class Visit>
  void forEachPair(Visit&& visit) const
  {
    for (std::uint32_t k = 0; k < size(); ++k) {
      if (!all[k].ends_row) visit(k, k + 1);
      if (k + columns < size()) visit(k, k + columns);
    }
  }

  /// Calls visit(neighbour) for the neighbours of sample k in its row and its column.
  template <class Visit>
  void forEachNeighbour(std::uint32_t k, Visit&& visit) const
  {
    if (!all[k].ends_row) visit(k + 1);
    if (!all[k].begins_row) visit(k - 1);
    if (k + columns < size()) visit(k + columns);
    if (k >= columns) visit(k - columns);
  }

  /// Whether two neighbours lie on one surface, by the plane distance d (eq. 5). Both have normals.
  bool areOnOneSurface(std::uint32_t m, std::uint32_t n, const PlaneExtractionParameters& parameters) const
  {
    const NoisySample& a = all[m];
    const NoisySample& b = all[n];
    const Eigen::Vector3f step = b.point - a.point;
    const float distance = std::abs(a.normal.dot(step)) + std::abs(b.normal.dot(step));
    const float noise = a.noise_along_normal + b.noise_along_normal;
    return distance < std::max(static_cast<float>(parameters.cluster_distance),
                               static_cast<float>(parameters.cluster_sigmas) * noise);
  }
};

}  // namespace polygonal_perception::perception
