// Messages of all sorts of nonsense: each is either refused or looked at, and nothing else.
#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <cstring>
#include <limits>
#include <random>

#include "polygonal_perception/perception/pipeline.hpp"
#include "ros/perception/cloud_input.hpp"
#include "ros/perception/depth_input.hpp"

namespace polygonal_perception::ros_perception {
namespace {

constexpr int kRounds = 4000;

/// Draws values that are mostly sensible, and otherwise of the kind that breaks things.
class Nonsense
{
public:
  bool rarely() { return std::uniform_int_distribution<int>(0, 9)(random_) == 0; }

  std::uint32_t size(std::uint32_t sensible)
  {
    if (!rarely()) return sensible;
    constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
    const std::uint32_t values[] = {0, 1, 2, sensible - 1, sensible + 1, 65536, kMost / 2 + 1, kMost};
    return values[std::uniform_int_distribution<std::size_t>(0, std::size(values) - 1)(random_)];
  }

  float number()
  {
    const float values[] = {0.0F,
                            -1.0F,
                            1e30F,
                            std::numeric_limits<float>::denorm_min(),
                            std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::quiet_NaN()};
    if (rarely())
      return values[std::uniform_int_distribution<std::size_t>(0, std::size(values) - 1)(random_)];
    return std::uniform_real_distribution<float>(0.3F, 4.0F)(random_);
  }

  void fill(std::vector<std::uint8_t>& data)
  {
    for (std::size_t at = 0; at + sizeof(float) <= data.size(); at += sizeof(float)) {
      const float value = number();
      std::memcpy(data.data() + at, &value, sizeof value);
    }
  }

private:
  std::mt19937 random_{5};
};

TEST(Fuzz, Clouds)
{
  Nonsense nonsense;
  perception::Pipeline pipeline{perception::Pipeline::Parameters{}};
  int accepted = 0;
  for (int round = 0; round < kRounds; ++round) {
    sensor_msgs::PointCloud2 cloud;
    cloud.width = nonsense.size(24);
    cloud.height = nonsense.size(18);
    cloud.point_step = nonsense.size(16);
    cloud.row_step = nonsense.size(24 * 16);
    cloud.is_bigendian = nonsense.rarely() && nonsense.rarely() ? 1 : 0;
    for (const char* name : {"x", "y", "z"}) {
      sensor_msgs::PointField field;
      field.name = nonsense.rarely() && nonsense.rarely() ? "" : name;
      field.offset = nonsense.size(4 * static_cast<std::uint32_t>(cloud.fields.size()));
      field.datatype = nonsense.rarely() && nonsense.rarely() ? 8 : 7;
      field.count = 1;
      cloud.fields.push_back(field);
    }
    cloud.data.resize(nonsense.rarely() ? 1000 : 18 * 24 * 16);
    nonsense.fill(cloud.data);
    const ros_common::Expected<perception::PointView> view = viewCloud(cloud);
    if (!view) {
      EXPECT_FALSE(view.error().empty());
      continue;
    }
    ++accepted;
    pipeline.process({*view, 0.03 * round, {}});
  }
  EXPECT_GT(accepted, kRounds / 10);
}

TEST(Fuzz, DepthImages)
{
  Nonsense nonsense;
  perception::Pipeline pipeline{perception::Pipeline::Parameters{}};
  DepthInput input("camera_info");
  int accepted = 0;
  for (int round = 0; round < kRounds; ++round) {
    auto info = boost::make_shared<sensor_msgs::CameraInfo>();
    info->width = nonsense.size(24);
    info->height = nonsense.size(18);
    info->binning_x = nonsense.rarely() ? nonsense.size(1) : 0;
    info->roi.height = nonsense.rarely() ? nonsense.size(18) : 0;
    info->P = {20.0, 0.0, 12.0, 0.0, 0.0, 20.0, 9.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    if (nonsense.rarely()) info->P[0] = nonsense.number();
    input.setCameraInfo(info);
    sensor_msgs::Image image;
    const bool metres = round % 2 == 0;
    image.encoding = nonsense.rarely() ? "rgb8" : metres ? "32FC1" : "16UC1";
    image.width = nonsense.size(24);
    image.height = nonsense.size(18);
    image.step = nonsense.size(metres ? 96 : 48);
    image.data.resize(nonsense.rarely() ? 100 : 18 * 96);
    nonsense.fill(image.data);
    const ros_common::Expected<perception::PointView> view = input.view(image);
    if (!view) {
      EXPECT_FALSE(view.error().empty());
      continue;
    }
    ++accepted;
    pipeline.process({*view, 0.03 * round, {}});
  }
  EXPECT_GT(accepted, kRounds / 10);
}

}  // namespace
}  // namespace polygonal_perception::ros_perception
