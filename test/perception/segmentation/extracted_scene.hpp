#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>

#include "perception/planes/plane_extraction.hpp"
#include "perception/segmentation/pixel_fit.hpp"
#include "perception/segmentation/plane_lookup.hpp"
#include "perception/segmentation/plane_pieces.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::test {

constexpr float kNoReturn = std::numeric_limits<float>::quiet_NaN();
constexpr double kFocalLength = 142.5;  // [px] of a PlaneScene, if nobody says otherwise

/// A wall that is seen straight on, so that each of its points has this depth.
inline geometry::Plane wallAt(double distance)
{
  return {-Eigen::Vector3d::UnitZ(), distance};
}

/// A rectangle of an image of 160 x 120 pixels, the last ones included.
struct Pixels
{
  int left, right, top, bottom;

  bool has(int u, int v) const { return u >= left && u <= right && v >= top && v <= bottom; }
};

inline void PrintTo(const Pixels& pixels, std::ostream* out)
{
  *out << "pixels " << pixels.left << " to " << pixels.right << ", " << pixels.top << " to " << pixels.bottom;
}

/// Gives a rectangle of the image a depth [m].
inline void paint(PlaneScene& scene, const Pixels& pixels, float depth)
{
  for (int v = pixels.top; v <= pixels.bottom; ++v) {
    for (int u = pixels.left; u <= pixels.right; ++u)
      scene.depth()[static_cast<std::size_t>(160 * v + u)] = depth;
  }
}

/// The pixel of a sample of 32 x 32 in an image of 160 x 120.
inline int columnOf(int i)
{
  return (2 * i * 159 + 31) / 62;
}

inline int rowOf(int j)
{
  return (2 * j * 119 + 31) / 62;
}

/// Around the samples of a rectangle of the grid, to halfway between them and the next.
inline Pixels around(int left, int right, int top, int bottom)
{
  return {columnOf(left) - 2, columnOf(right) + 2, rowOf(top) - 1, rowOf(bottom) + 1};
}

/// A round upright pole straight ahead.
/// @param distance  [m] of its front
inline PlaneScene poleAt(double distance, double radius)
{
  PlaneScene scene;
  const double middle = distance + radius;
  for (std::size_t k = 0; k < scene.depth().size(); ++k) {
    const double slope = (static_cast<double>(k % 160) - 79.5) / kFocalLength;
    const double length = 1.0 + slope * slope;
    const double square = radius * radius * length - middle * middle * slope * slope;
    if (square > 0.0) scene.depth()[k] = static_cast<float>((middle - std::sqrt(square)) / length);
  }
  return scene;
}

/// What the stages before the one that is tested make of a frame.
struct ExtractedScene
{
  /// @param least  samples that make a piece
  explicit ExtractedScene(const PlaneScene& scene, std::uint32_t least = 11, double normal_margin = 0.01)
      : least_(least), normal_margin_(normal_margin)
  {
    update(scene.view());
  }

  /// Looks at another frame.
  void update(const perception::PointView& points)
  {
    grid.update(points);
    extraction.extract(grid, parameters, {});
    pieces.find(extraction, parameters, least_, normal_margin_);
    lookup.take(extraction, pieces.planeOf(), parameters);
  }

  /// The sample in a row and a column of the grid.
  std::size_t sampleAt(int i, int j) const { return static_cast<std::size_t>(j * grid.samplesX() + i); }

  perception::PlaneExtractionParameters parameters;
  perception::SampleGrid grid{perception::SampleGrid::Parameters{}};
  perception::PlaneExtraction extraction;
  perception::PlanePieces pieces;
  perception::PlaneLookup lookup;

private:
  std::uint32_t least_;
  double normal_margin_;
};

}  // namespace polygonal_perception::test
