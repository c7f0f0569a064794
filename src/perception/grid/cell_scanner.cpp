#include "perception/grid/cell_scanner.hpp"

#include <cmath>
#include <cstring>
#include <limits>

namespace polygonal_perception::perception {

namespace {

constexpr std::size_t kPackedPoint = 16;

std::uint32_t wholeBlocks(std::uint32_t pixels)
{
  return pixels / kBlock * kBlock;
}
std::uint32_t roundedUp(std::uint32_t pixels)
{
  return wholeBlocks(pixels + kBlock - 1);
}

/// Whether a kernel can take the points from where they lie.
bool isPacked(const PointView::CloudStrides& strides)
{
  return strides.point_step == kPackedPoint && strides.x_offset == 0 && strides.y_offset == 4 &&
         strides.z_offset == 8;
}

/// Copies `count` points to 16 bytes each and fills up a block with points that are none.
void pack(const std::uint8_t* from, std::uint32_t count, const PointView::CloudStrides& strides,
          std::uint8_t* to)
{
  const bool adjacent = strides.y_offset == strides.x_offset + 4 && strides.z_offset == strides.x_offset + 8;
  std::uint32_t u = 0;
  for (; u < count; ++u, from += strides.point_step, to += kPackedPoint) {
    if (adjacent) {
      std::memcpy(to, from + strides.x_offset, 12);
    } else {
      std::memcpy(to, from + strides.x_offset, 4);
      std::memcpy(to + 4, from + strides.y_offset, 4);
      std::memcpy(to + 8, from + strides.z_offset, 4);
    }
  }
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  constexpr float kNothing[3] = {kNaN, kNaN, kNaN};
  for (; u < roundedUp(count); ++u, to += kPackedPoint) std::memcpy(to, kNothing, sizeof kNothing);
}

}  // namespace

void CellScanner::begin(const PointView& points, const CellTransform& transform, const StandingRule* rule,
                        const NearestLanes& nearest)
{
  points_ = points;
  rule_ = rule;
  transform_ = transform;
  transform_.nearest_squared = points.nearestSquared();
  transform_.farthest_squared = points.farthestSquared();
  const std::uint32_t width = roundedUp(points.width());
  blocks_.resize(width / kBlock);
  nearest_ = nearest;
  transform_.beside = rule != nullptr && nearest.squared != nullptr ? -1 : 0;
  packed_.resize(kPackedPoint * width);
  if (points.layout() == PointLayout::kCloud) {
    pixel_ = kernel_->cloud_pixel;
    return;
  }
  const bool metres = points.layout() == PointLayout::kDepthMetres;
  pixel_ = metres ? kernel_->metres_pixel : kernel_->units_pixel;
  unit_ = points.unit();
  column_shares_.assign(std::size_t{4} * width, 0.0F);
  for (std::uint32_t k = 0; k < width; ++k) {
    const std::uint32_t u = k / kBlock * kBlock + pixel_[k % kBlock];
    if (u >= points.width()) continue;
    const float slope = unit_ * points.rays()->column_slope[u];
    column_shares_[k] = transform.height.x * slope;
    column_shares_[width + k] = transform.column.x * slope;
    column_shares_[2 * width + k] = transform.row.x * slope;
    column_shares_[3 * width + k] = slope * slope;
  }
}

CellScanner::Row CellScanner::row(std::uint32_t v)
{
  const std::uint32_t count = points_.layout() == PointLayout::kCloud ? cloudRow(v) : depthRow(v);
  if (points_.leavesOut() || rule_ != nullptr) applyRule(v, count);
  return {blocks_.data(), blocks_.data() + count};
}

CellScanner::Row CellScanner::rowAboveFloor(std::uint32_t v)
{
  const float lowest = transform_.lowest;
  transform_.lowest = transform_.standing;
  const Row above = row(v);
  transform_.lowest = lowest;
  return above;
}

/// Takes out the points in ignored boxes, and moves the others to the layer that they have by the rule. The kernel leaves
/// few points of a frame over, but for those of the floor where they are asked for.
void CellScanner::applyRule(std::uint32_t v, std::uint32_t count)
{
  for (std::uint32_t k = 0; k < count; ++k) {
    CellBlock& block = blocks_[k];
    for (std::uint32_t lane = 0; lane < kBlock; ++lane) {
      std::uint32_t& cell = block.cell[lane];
      if (cell == 0) continue;
      const Eigen::Vector3f point = points_.point(column(block, lane), v);
      if (!point.allFinite()) {
        cell = 0;  // in an ignored box
      } else if (rule_ != nullptr) {
        cell = cellByRule(point, cell, block.first + lane);
      }
    }
  }
}

std::uint32_t CellScanner::cellByRule(const Eigen::Vector3f& point, std::uint32_t cell, std::size_t lane)
{
  const StandingRule::Standing standing = rule_->standing(point);
  if (standing.layer > 0 && nearest_.squared != nullptr) {
    const float squared = standing.on_floor.head<2>().squaredNorm();
    if (squared < nearest_.squared[lane]) {
      nearest_.squared[lane] = squared;
      nearest_.changed[lane / kBlock] = 1;
      nearest_.x[lane] = standing.on_floor.x();
      nearest_.y[lane] = standing.on_floor.y();
      nearest_.height[lane] = standing.height - rule_->to_floor_frame.translation().z();
    }
  }
  const auto size = static_cast<std::uint32_t>(transform_.layer_size);
  if (cell == kBeside || standing.layer < 0 || (standing.layer == 0 && size == 0)) return 0;
  const std::uint32_t in_layer = size > 0 ? (cell - 1) % size : cell - 1;
  return 1 + static_cast<std::uint32_t>(standing.layer) * size + in_layer;
}

std::uint32_t CellScanner::cloudRow(std::uint32_t v)
{
  const PointView::CloudStrides& strides = points_.strides();
  const std::uint8_t* const points = points_.row(v);
  const std::uint32_t whole = isPacked(strides) ? wholeBlocks(points_.width()) : 0;
  std::uint32_t count = kernel_->cloud(points, whole, transform_, blocks_.data(), nearestOfKernel());
  const std::uint32_t rest = points_.width() - whole;
  if (rest == 0) return count;

  pack(points + whole * strides.point_step, rest, strides, packed_.data());
  CellBlock* block = blocks_.data() + count;
  count += kernel_->cloud(packed_.data(), roundedUp(rest), transform_, block, nearestOfKernel(whole));
  for (; block != blocks_.data() + count; ++block) block->first += whole;
  return count;
}

std::uint32_t CellScanner::depthRow(std::uint32_t v)
{
  const bool metres = points_.layout() == PointLayout::kDepthMetres;
  const auto run = metres ? kernel_->metres : kernel_->units;
  const std::size_t pixel_size = metres ? sizeof(float) : sizeof(std::uint16_t);
  const std::size_t width = roundedUp(points_.width());
  const float slope = points_.rays()->row_slope[v];
  const auto share = [&](const CellTransform::Coefficients& of) { return unit_ * (of.y * slope + of.z); };

  DepthRow row = {points_.row(v),
                  column_shares_.data(),
                  column_shares_.data() + width,
                  column_shares_.data() + 2 * width,
                  column_shares_.data() + 3 * width,
                  share(transform_.height),
                  share(transform_.column),
                  share(transform_.row),
                  unit_ * unit_ * (slope * slope + 1.0F)};
  const std::uint32_t whole = wholeBlocks(points_.width());
  std::uint32_t count = run(row, whole, transform_, blocks_.data(), nearestOfKernel());
  const std::uint32_t rest = points_.width() - whole;
  if (rest == 0) return count;

  std::memcpy(packed_.data(), row.depth + whole * pixel_size, rest * pixel_size);
  std::memset(packed_.data() + rest * pixel_size, 0, (kBlock - rest) * pixel_size);
  row.depth = packed_.data();
  row.heights += whole;
  row.columns += whole;
  row.rows += whole;
  row.squares += whole;
  CellBlock* const block = blocks_.data() + count;
  count += run(row, kBlock, transform_, block, nearestOfKernel(whole));
  if (block != blocks_.data() + count) block->first += whole;
  return count;
}

}  // namespace polygonal_perception::perception
