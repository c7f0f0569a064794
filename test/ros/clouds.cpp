#include "clouds.hpp"

#include <boost/make_shared.hpp>
#include <cstdint>

namespace polygonal_perception::test {

namespace {

constexpr std::uint32_t kWidth = 64;
constexpr std::uint32_t kHeight = 48;

/// @param depth_of_row  depth [m] by the row's index
template <class DepthOfRow>
sensor_msgs::PointCloud2Ptr cloudOf(ros::Time stamp, const std::string& frame, DepthOfRow&& depth_of_row)
{
  auto cloud = boost::make_shared<sensor_msgs::PointCloud2>();
  cloud->header.stamp = stamp;
  cloud->header.frame_id = frame;
  cloud->width = kWidth;
  cloud->height = kHeight;
  cloud->point_step = 3 * sizeof(float);
  cloud->row_step = kWidth * cloud->point_step;
  for (const char* name : {"x", "y", "z"}) {
    sensor_msgs::PointField field;
    field.name = name;
    field.offset = static_cast<std::uint32_t>(cloud->fields.size() * sizeof(float));
    field.datatype = sensor_msgs::PointField::FLOAT32;
    field.count = 1;
    cloud->fields.push_back(field);
  }
  cloud->data.resize(std::size_t{cloud->height} * cloud->row_step);
  auto* point = reinterpret_cast<float*>(cloud->data.data());
  for (std::uint32_t v = 0; v < kHeight; ++v) {
    const float slope = 0.1F + 0.02F * static_cast<float>(v);
    for (std::uint32_t u = 0; u < kWidth; ++u, point += 3) {
      const float depth = depth_of_row(slope);
      point[0] = (static_cast<float>(u) - 31.5F) / 60.0F * depth;
      point[1] = slope * depth;
      point[2] = depth;
    }
  }
  return cloud;
}

}  // namespace

sensor_msgs::PointCloud2Ptr floorCloud(ros::Time stamp, const std::string& frame)
{
  return cloudOf(stamp, frame, [](float slope) { return 1.0F / slope; });
}

sensor_msgs::PointCloud2Ptr wallCloud(ros::Time stamp, const std::string& frame)
{
  return cloudOf(stamp, frame, [](float) { return 0.5F; });
}

}  // namespace polygonal_perception::test
