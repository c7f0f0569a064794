#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "ros/perception/cloud_input.hpp"

namespace polygonal_perception::ros_perception {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

PointField field(const char* name, std::uint32_t offset)
{
  PointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = PointField::FLOAT32;
  field.count = 1;
  return field;
}

/// Three by two points of 20 bytes, z before x and y, rows padded by 4 bytes; the last one has no return.
PointCloud2 cloud()
{
  PointCloud2 cloud;
  cloud.width = 3;
  cloud.height = 2;
  cloud.point_step = 20;
  cloud.row_step = 64;
  cloud.fields = {field("z", 1), field("x", 8), field("y", 13)};
  cloud.data.resize(128);
  for (std::uint32_t v = 0; v < 2; ++v) {
    for (std::uint32_t u = 0; u < 3; ++u) {
      const auto number = static_cast<float>(10 * v + u);
      const float xyz[] = {number + 0.1F, number + 0.2F, v == 1 && u == 2 ? NAN : number + 0.3F};
      std::uint8_t* at = cloud.data.data() + v * 64 + u * 20;
      std::memcpy(at + 8, &xyz[0], 4);
      std::memcpy(at + 13, &xyz[1], 4);
      std::memcpy(at + 1, &xyz[2], 4);
    }
  }
  return cloud;
}

/// The error for a cloud that was spoilt.
template <class Spoil>
std::string errorOf(Spoil&& spoil)
{
  PointCloud2 bad = cloud();
  spoil(bad);
  const ros_common::Expected<perception::PointView> view = viewCloud(bad);
  EXPECT_FALSE(view);
  return view.error();
}

TEST(CloudInput, ReadsAnyOffsetsAndSteps)
{
  const PointCloud2 message = cloud();
  const ros_common::Expected<perception::PointView> view = viewCloud(message);
  ASSERT_TRUE(view) << view.error();
  EXPECT_EQ(view->width(), 3U);
  EXPECT_EQ(view->height(), 2U);
  EXPECT_EQ(view->point(0, 0), Eigen::Vector3f(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(view->point(1, 1), Eigen::Vector3f(11.1F, 11.2F, 11.3F));
  EXPECT_TRUE(std::isnan(view->point(2, 1).z()));
  EXPECT_EQ(view->row(0), message.data.data()) << "nothing may be copied";
}

TEST(CloudInput, SaysWhatIsWrongWithTheShape)
{
  EXPECT_EQ(errorOf([](PointCloud2& c) { c.height = 1; }),
            "height is 1, accepted is an organised cloud (height > 1, a point a pixel)");
  EXPECT_EQ(errorOf([](PointCloud2& c) { c.width = 0; }), "width is 0, accepted is 2 to 65535");
  EXPECT_EQ(errorOf([](PointCloud2& c) { c.height = 70000; }), "height is 70000, accepted is 2 to 65535");
}

TEST(CloudInput, SaysWhatIsWrongWithAField)
{
  EXPECT_EQ(errorOf([](PointCloud2& c) { c.fields.erase(c.fields.begin()); }),
            "field 'z' is missing, needed are x, y and z");
  EXPECT_EQ(errorOf([](PointCloud2& c) { c.fields[1].datatype = PointField::FLOAT64; }),
            "field 'x' has datatype 8, accepted is FLOAT32 (7)");
  EXPECT_EQ(errorOf([](PointCloud2& c) { c.fields[2].count = 3; }), "field 'y' has count 3, accepted is 1");
  EXPECT_EQ(errorOf([](PointCloud2& c) { c.fields[2].offset = 17; }),
            "field 'y' at offset 17 does not fit a point_step of 20");
  EXPECT_EQ(errorOf([](PointCloud2& c) { c.fields[2].offset = std::numeric_limits<std::uint32_t>::max(); }),
            "field 'y' at offset 4294967295 does not fit a point_step of 20");
}

TEST(CloudInput, CoordinatesShareNoBytes)
{
  EXPECT_EQ(errorOf([](PointCloud2& c) { c.fields[2].offset = 11; }),
            "fields 'x' and 'y' overlap at offsets 8 and 11, accepted are 4 bytes each");
  EXPECT_EQ(errorOf([](PointCloud2& c) { c.fields[0].offset = 8; }),
            "fields 'x' and 'z' overlap at offsets 8 and 8, accepted are 4 bytes each");
}

TEST(CloudInput, OfFieldsOfOneNameTheFirstCounts)
{
  PointCloud2 message = cloud();
  message.fields.push_back(field("x", 13));
  EXPECT_EQ(viewCloud(message)->point(0, 0).x(), 0.1F);
  message.fields[1].datatype = PointField::FLOAT64;
  EXPECT_EQ(viewCloud(message).error(), "field 'x' has datatype 8, accepted is FLOAT32 (7)");
}

TEST(CloudInput, SaysWhatIsWrongWithTheMemory)
{
  EXPECT_EQ(errorOf([](PointCloud2& c) { c.is_bigendian = 1; }), "is_bigendian is true, accepted is false");
  EXPECT_EQ(errorOf([](PointCloud2& c) { c.row_step = 59; }),
            "row_step is 59, accepted is at least width x point_step = 60");
  EXPECT_EQ(errorOf([](PointCloud2& c) { c.data.pop_back(); }),
            "data has 127 bytes, accepted is height x row_step = 128");
  // Sizes whose product does not fit 32 bits.
  EXPECT_EQ(errorOf([](PointCloud2& c) {
              c.height = 65535;
              c.row_step = 0x80000000U;
            }),
            "data has 128 bytes, accepted is height x row_step = 140735340871680");
}

}  // namespace
}  // namespace polygonal_perception::ros_perception
