#pragma once

#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::test {

/// A frame of random points, some of them such that no sensor should give them.
class RandomFrame
{
public:
  explicit RandomFrame(std::mt19937& random) : random_(&random)
  {
    width_ = pick(1U, 140U);
    height_ = pick(1U, 9U);
    rays_ = perception::PinholeRays::make(width_, height_, 40.0, 41.0, 0.5 * width_, 0.4 * height_);
    layout_ = static_cast<perception::PointLayout>(pick(0, 2));
    if (pick(0, 1) == 0) unit_ = 0.00025;
    if (pick(0, 2) == 0) limits_ = {coordinate(0.0F, 1.0F), coordinate(1.0F, 5.0F)};
    if (layout_ == perception::PointLayout::kCloud) {
      fillCloud();
    } else if (layout_ == perception::PointLayout::kDepthMetres) {
      fillDepth<float>([this] { return coordinate(0.0F, 4.0F); });
    } else {
      fillDepth<std::uint16_t>([this] {
        return static_cast<std::uint16_t>(pick(0, 9) == 0 ? 65535 * pick(0, 1) : pick(1, 4000));
      });
    }
  }

  perception::PointView view() const { return everything().within(limits_); }

private:
  perception::PointView everything() const
  {
    const std::uint8_t* const first = bytes_.data() + misalignment_;
    if (layout_ == perception::PointLayout::kCloud)
      return perception::PointView::cloud(first, width_, height_, strides_);
    if (layout_ == perception::PointLayout::kDepthMetres) {
      return perception::PointView::depth(reinterpret_cast<const float*>(first), strides_.row_step, rays_);
    }
    return perception::PointView::depth(reinterpret_cast<const std::uint16_t*>(first), strides_.row_step,
                                        rays_, unit_);
  }

  template <class Integer>
  Integer pick(Integer low, Integer high)
  {
    return std::uniform_int_distribution<Integer>(low, high)(*random_);
  }

  float coordinate(float low, float high)
  {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    constexpr float kOdd[] = {0.0F,
                              -0.0F,
                              1e-40F,
                              -1e-40F,
                              3e38F,
                              -3e38F,
                              1e10F,
                              -1e10F,
                              2147483648.0F,
                              -2147483904.0F,
                              kInfinity,
                              -kInfinity,
                              std::numeric_limits<float>::quiet_NaN()};
    if (pick(0, 19) == 0) return kOdd[pick(std::size_t{0}, std::size(kOdd) - 1)];
    return std::uniform_real_distribution<float>(low, high)(*random_);
  }

  template <class T>
  void put(std::size_t at, T value)
  {
    std::memcpy(bytes_.data() + misalignment_ + at, &value, sizeof value);
  }

  /// Makes room for rows that may have a gap between them; the last one ends with the memory.
  void makeRoom(std::size_t row_bytes)
  {
    const auto gap = 5 * pick(std::size_t{0}, std::size_t{2});
    strides_.row_step = row_bytes + gap;
    bytes_.assign(misalignment_ + strides_.row_step * height_ - gap, 0xFF);
  }

  void fillCloud()
  {
    constexpr perception::PointView::CloudStrides kKinds[] = {{0, 16, 0, 4, 8}, {0, 32, 0, 4, 8},
                                                              {0, 12, 0, 4, 8}, {0, 16, 4, 8, 12},
                                                              {0, 20, 8, 0, 4}, {0, 27, 13, 3, 20}};
    strides_ = kKinds[pick(std::size_t{0}, std::size(kKinds) - 1)];
    misalignment_ = pick(std::size_t{0}, std::size_t{3});
    makeRoom(width_ * strides_.point_step);
    for (std::uint32_t v = 0; v < height_; ++v) {
      for (std::uint32_t u = 0; u < width_; ++u) {
        const std::size_t at = v * strides_.row_step + u * strides_.point_step;
        put(at + strides_.x_offset, coordinate(-2.0F, 2.0F));
        put(at + strides_.y_offset, coordinate(-0.5F, 1.0F));
        put(at + strides_.z_offset, coordinate(0.0F, 4.0F));
      }
    }
  }

  template <class T, class Value>
  void fillDepth(Value value)
  {
    makeRoom(width_ * sizeof(T));
    for (std::uint32_t v = 0; v < height_; ++v) {
      for (std::uint32_t u = 0; u < width_; ++u) put<T>(v * strides_.row_step + u * sizeof(T), value());
    }
  }

  std::mt19937* random_;
  std::uint32_t width_, height_;
  perception::PinholeRays rays_;
  perception::PointLayout layout_;
  perception::RangeLimits limits_;
  double unit_ = 0.001;  // [m]
  perception::PointView::CloudStrides strides_;
  std::size_t misalignment_ = 0;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace polygonal_perception::test
