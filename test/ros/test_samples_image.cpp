#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "ros/perception/samples_image.hpp"

namespace polygonal_perception::ros_perception {
namespace {

constexpr std::uint32_t kWidth = 64;
constexpr std::uint32_t kHeight = 64;

TEST(SamplesImage, DotsTellWhatBecameOfTheSamples)
{
  // A depth image: 1 m everywhere, no return in its right half.
  const perception::PinholeRays rays = perception::PinholeRays::make(kWidth, kHeight, 60.0, 60.0, 32.0, 32.0);
  std::vector<std::uint16_t> depth(kWidth * kHeight, 1000);
  for (std::uint32_t v = 0; v < kHeight; ++v) {
    std::fill(depth.begin() + v * kWidth + kWidth / 2, depth.begin() + (v + 1) * kWidth, 0);
  }
  const perception::PointView points =
      perception::PointView::depth(depth.data(), kWidth * sizeof(std::uint16_t), rays);
  perception::SampleGrid::Parameters four;
  four.samples_x = four.samples_y = 4;
  perception::SampleGrid samples(four);
  samples.update(points);
  // Columns at the pixels 0, 21, 42, 63.
  std::vector<perception::SampleLabel> labels(16, perception::SampleLabel::kNoPoint);
  for (std::size_t row = 0; row < 4; ++row) {
    labels[4 * row] = perception::SampleLabel::kFloor;
    labels[4 * row + 1] = row < 2 ? perception::SampleLabel::kPruned : perception::SampleLabel::kSegment;
  }

  const auto image = toSamplesImage(std_msgs::Header(), points, samples, labels, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(image->encoding, "bgr8");
  ASSERT_EQ(image->data.size(), 3U * kWidth * kHeight);
  using Pixel = std::array<int, 3>;
  const auto at = [&image](std::uint32_t u, std::uint32_t v) -> Pixel {
    const std::uint8_t* pixel = image->data.data() + v * image->step + 3 * u;
    return {pixel[0], pixel[1], pixel[2]};
  };
  const auto [floor_b, floor_g, floor_r] = at(0, 0);
  EXPECT_TRUE(floor_g > floor_b && floor_g > floor_r) << "floor is green";
  const auto [pruned_b, pruned_g, pruned_r] = at(21, 21);
  EXPECT_TRUE(pruned_r > pruned_b && pruned_r > pruned_g) << "pruned is red";
  const auto [segment_b, segment_g, segment_r] = at(21, 42);
  EXPECT_TRUE(segment_r > segment_b && segment_g > segment_b) << "a segment is yellow";
  EXPECT_EQ(at(63, 63)[0], at(63, 63)[2]) << "no depth is grey";
  EXPECT_NE(at(63, 63), at(55, 55)) << "and seen on the black of no return";
  EXPECT_EQ(at(55, 55), (Pixel{0, 0, 0}));
  EXPECT_EQ(at(10, 10), (Pixel{130, 130, 130})) << "1 m is grey";
}

}  // namespace
}  // namespace polygonal_perception::ros_perception
