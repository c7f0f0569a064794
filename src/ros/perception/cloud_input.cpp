#include "ros/perception/cloud_input.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "ros/perception/image_size.hpp"

namespace polygonal_perception::ros_perception {

namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

/// Fills in the offset of a coordinate; returns what is wrong with it, or nothing.
std::string findCoordinate(const PointCloud2& cloud, const char* name, std::size_t& offset)
{
  const std::string quoted = "field '" + std::string(name) + "'";
  for (const PointField& field : cloud.fields) {
    if (field.name != name) continue;
    if (field.datatype != PointField::FLOAT32) {
      return quoted + " has datatype " + std::to_string(field.datatype) + ", accepted is FLOAT32 (7)";
    }
    // Some publishers leave the count at 0 and mean 1.
    if (field.count > 1) return quoted + " has count " + std::to_string(field.count) + ", accepted is 1";
    if (std::uint64_t{field.offset} + sizeof(float) > cloud.point_step) {
      return quoted + " at offset " + std::to_string(field.offset) + " does not fit a point_step of " +
             std::to_string(cloud.point_step);
    }
    offset = field.offset;
    return {};
  }
  return quoted + " is missing, needed are x, y and z";
}

/// What is wrong where two coordinates share bytes, as those of publishers that leave all offsets at 0 do.
std::string findOverlap(const perception::PointView::CloudStrides& strides)
{
  std::array coordinates = {std::pair{strides.x_offset, 'x'}, std::pair{strides.y_offset, 'y'},
                            std::pair{strides.z_offset, 'z'}};
  std::sort(coordinates.begin(), coordinates.end());
  for (std::size_t k = 1; k < coordinates.size(); ++k) {
    const auto [low, before] = coordinates[k - 1];
    const auto [high, after] = coordinates[k];
    if (high - low >= sizeof(float)) continue;
    return std::string("fields '") + before + "' and '" + after + "' overlap at offsets " +
           std::to_string(low) + " and " + std::to_string(high) + ", accepted are 4 bytes each";
  }
  return {};
}

}  // namespace

ros_common::Expected<perception::PointView> viewCloud(const PointCloud2& cloud)
{
  using Result = ros_common::Expected<perception::PointView>;
  if (cloud.height <= 1) {
    return Result::failure("height is " + std::to_string(cloud.height) +
                           ", accepted is an organised cloud (height > 1, a point a pixel)");
  }
  if (const std::string error = imageSizeError(cloud.width, cloud.height); !error.empty()) {
    return Result::failure(error);
  }
  if (cloud.is_bigendian != 0) return Result::failure("is_bigendian is true, accepted is false");

  perception::PointView::CloudStrides strides;
  strides.point_step = cloud.point_step;
  strides.row_step = cloud.row_step;
  for (const auto& [name, offset] : {std::pair{"x", &strides.x_offset}, std::pair{"y", &strides.y_offset},
                                     std::pair{"z", &strides.z_offset}}) {
    if (const std::string error = findCoordinate(cloud, name, *offset); !error.empty()) {
      return Result::failure(error);
    }
  }
  if (const std::string error = findOverlap(strides); !error.empty()) return Result::failure(error);
  const std::uint64_t row = std::uint64_t{cloud.width} * cloud.point_step;
  if (cloud.row_step < row) {
    return Result::failure("row_step is " + std::to_string(cloud.row_step) +
                           ", accepted is at least width x point_step = " + std::to_string(row));
  }
  const std::uint64_t size = std::uint64_t{cloud.height} * cloud.row_step;
  if (cloud.data.size() < size) {
    return Result::failure("data has " + std::to_string(cloud.data.size()) +
                           " bytes, accepted is height x row_step = " + std::to_string(size));
  }
  return perception::PointView::cloud(cloud.data.data(), cloud.width, cloud.height, strides);
}

}  // namespace polygonal_perception::ros_perception
