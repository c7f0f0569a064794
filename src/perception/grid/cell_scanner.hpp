#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "perception/grid/projection_kernel.hpp"
#include "polygonal_perception/perception/grid/ground_map.hpp"
#include "polygonal_perception/perception/grid/height_noise.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::perception {

/// In which layer the points lie that the kernel leaves over: it has decided on their height above the floor, but does not
/// know of the ground and of noise.
struct StandingRule
{
  Eigen::Isometry3f to_floor_frame = Eigen::Isometry3f::Identity();
  const GroundMap* ground = nullptr;  // null: the floor
  float min_height = 0.0F;            // [m] above the ground
  float max_height = 0.0F;
  const HeightNoise* noise = nullptr;
  float sigmas = 0.0F;

  float slabs_per_metre = 0.0F;
  float last_slab = 0.0F;

  static constexpr int kNone = -1;

  struct Standing
  {
    int layer;                 // see CellTransform, or kNone
    Eigen::Vector3f on_floor;  // the point in the floor frame
    float height;              // [m] above the ground
  };

  /// @param point  in the input's frame
  Standing standing(const Eigen::Vector3f& point) const
  {
    const Eigen::Vector3f on_floor = to_floor_frame * point;
    GroundMap::Span span{0.0F, 0.0F};
    if (ground != nullptr) span = ground->at(on_floor.x(), on_floor.y());
    const float height = on_floor.z() - span.lower;
    if (height < min_height) {
      // Where nobody knows whether a ramp goes on, nobody has seen the ground either.
      const bool is_on_ground = height > -min_height && std::abs(on_floor.z() - span.higher) < min_height;
      return {is_on_ground ? 0 : kNone, on_floor, height};
    }
    const bool stands = on_floor.z() - span.higher <= max_height &&
                        (noise == nullptr || height > sigmas * noise->sigma(point));
    const int slab = static_cast<int>(std::min((height - min_height) * slabs_per_metre, last_slab));
    return {stands ? 1 + slab : kNone, on_floor, height};
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

  const ProjectionKernel& kernel() const { return *kernel_; }

  /// Turns to a frame, which must stay where it is until its rows are done, as must the rule; null: there is none.
  /// @param nearest  kept up to date as rows are taken, with entries for all pixels of a row and up to the end of its
  ///                 last block; its squared null: not wanted. Frames that leave points out want a rule for it.
  void begin(const PointView& points, const CellTransform& transform, const StandingRule* rule = nullptr,
             const NearestLanes& nearest = {});

  /// The cells of row v; they stand until the next call.
  Row row(std::uint32_t v);
  /// The same without the floor's.
  Row rowAboveFloor(std::uint32_t v);

  /// The column of the pixel that a lane of a block holds.
  std::uint32_t column(const CellBlock& block, std::uint32_t lane) const
  {
    return block.first + pixel_[lane];
  }

private:
  void applyRule(std::uint32_t v, std::uint32_t count);
  /// @return the cell of a point by the rule
  std::uint32_t cellByRule(const Eigen::Vector3f& point, std::uint32_t cell, std::size_t lane);
  /// What the kernel keeps: where there is a rule, it does not know what stands.
  NearestLanes nearestOfKernel(std::size_t first = 0) const
  {
    return rule_ != nullptr || nearest_.squared == nullptr ? NearestLanes{} : nearest_.from(first);
  }
  std::uint32_t cloudRow(std::uint32_t v);
  std::uint32_t depthRow(std::uint32_t v);

  const ProjectionKernel* kernel_;
  const std::uint8_t* pixel_ = nullptr;
  PointView points_;
  CellTransform transform_{};
  const StandingRule* rule_ = nullptr;
  NearestLanes nearest_{};
  float unit_ = 1.0F;                 // [m] of the numbers in a depth image
  std::vector<float> column_shares_;  // of the height, the column and the row, one after the other
  std::vector<std::uint8_t> packed_;  // pixels that the kernel cannot take from where they lie
  std::vector<CellBlock> blocks_;
};

}  // namespace polygonal_perception::perception
