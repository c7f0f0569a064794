// A PointCloud2 of any shape: refused with a reason, or looked at within its data.
#include "byte_reader.hpp"
#include "result_check.hpp"
#include "ros/perception/cloud_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace polygonal_perception;
  using namespace polygonal_perception::test;
  ByteReader bytes(data, size);
  sensor_msgs::PointCloud2 cloud;
  cloud.width = bytes.size();
  cloud.height = bytes.size();
  cloud.point_step = bytes.size();
  cloud.row_step = bytes.size();
  cloud.is_bigendian = bytes.byte() == 1 ? 1 : 0;
  const int field_count = bytes.byte() % 6;
  for (int i = 0; i < field_count; ++i) {
    sensor_msgs::PointField field;
    const std::uint8_t name = bytes.byte() % 4;
    field.name = name < 3 ? std::string(1, static_cast<char>('x' + name)) : bytes.text();
    field.offset = bytes.size();
    const std::uint8_t type = bytes.byte();
    field.datatype = type < 16 ? type : static_cast<std::uint8_t>(sensor_msgs::PointField::FLOAT32);
    field.count = bytes.byte() == 0 ? bytes.size() : 1;
    cloud.fields.push_back(field);
  }
  cloud.data = bytes.rest();
  cloud.data.shrink_to_fit();

  const ros_common::Expected<perception::PointView> view = ros_perception::viewCloud(cloud);
  require(view || !view.error().empty(), "what is refused has a reason");
  if (!view) return 0;
  perception::Pipeline pipeline{perception::Pipeline::Parameters{}};
  requireSound(pipeline.process({*view, 1.0, {}}, kAllProducts));
  return 0;
}
