#pragma once

#include <cstdint>
#include <vector>

#include "perception/grid/projection_kernel.hpp"
#include "polygonal_perception/perception/grid/ground_map.hpp"
#include "polygonal_perception/perception/grid/height_noise.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::perception {

/// Which of the points that the kernel leaves over stand on the ground.
struct StandingRule
{
  Eigen::Isometry3f to_floor_frame = Eigen::Isometry3f::Identity();
  const GroundMap* ground = nullptr;  // null: the kernel's bounds have decided on the height
  float min_height = 0.0F;            // [m] above the ground
  float max_height = 0.0F;
  const HeightNoise* noise = nullptr;
  float sigmas = 0.0F;

  /// @param point  in the input's frame
  bool holds(const Eigen::Vector3f& point) const
  {
    const Eigen::Vector3f on_floor = to_floor_frame * point;
    float height = on_floor.z();
    if (ground != nullptr) {
      const GroundMap::Span span = ground->at(on_floor.x(), on_floor.y());
      if (!(height - span.lower >= min_height && height - span.higher <= max_height)) return false;
      height -= span.lower;
    }
    return noise == nullptr || height > sigmas * noise->sigma(point);
  }
};

/// Runs a frame through a projection kernel, row by row: brings any layout, any width and any alignment into
/// the shape that the kernel takes.
class CellScanner
{
public:
  /// The cells of a row of the image.
  struct Row
  {
    const CellBlock* first;
    const CellBlock* last;  ///< one past the end

    const CellBlock* begin() const { return first; }
    const CellBlock* end() const { return last; }
  };

  explicit CellScanner(const ProjectionKernel& kernel) : kernel_(&kernel) {}

  /// Turns to a frame, which must stay where it is until its rows are done, as must the rule; null: there is none.
  void begin(const PointView& points, const CellTransform& transform, const StandingRule* rule = nullptr);

  /// The cells of row v; they stand until the next call.
  Row row(std::uint32_t v);

  /// The column of the pixel that a lane of a block holds.
  std::uint32_t column(const CellBlock& block, std::uint32_t lane) const
  {
    return block.first + pixel_[lane];
  }

private:
  void dropOthers(std::uint32_t v, std::uint32_t count);
  std::uint32_t cloudRow(std::uint32_t v);
  std::uint32_t depthRow(std::uint32_t v);

  const ProjectionKernel* kernel_;
  const std::uint8_t* pixel_ = nullptr;
  PointView points_;
  CellTransform transform_{};
  const StandingRule* rule_ = nullptr;
  float unit_ = 1.0F;                 // [m] of the numbers in a depth image
  std::vector<float> column_shares_;  // of the height, the column and the row, one after the other
  std::vector<std::uint8_t> packed_;  // pixels that the kernel cannot take from where they lie
  std::vector<CellBlock> blocks_;
};

}  // namespace polygonal_perception::perception
