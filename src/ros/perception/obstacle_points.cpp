#include "ros/perception/obstacle_points.hpp"

#include <boost/make_shared.hpp>
#include <cstddef>
#include <cstring>

namespace polygonal_perception::ros_perception {

sensor_msgs::PointCloud2Ptr toObstaclePoints(const std_msgs::Header& header,
                                             const std::vector<Eigen::Vector3f>& standing,
                                             const Eigen::Isometry2d& output_pose)
{
  auto cloud = boost::make_shared<sensor_msgs::PointCloud2>();
  cloud->header = header;
  cloud->height = 1;
  cloud->width = static_cast<std::uint32_t>(standing.size());
  cloud->is_dense = 1;
  for (const char* name : {"x", "y", "z"}) {
    sensor_msgs::PointField field;
    field.name = name;
    field.offset = static_cast<std::uint32_t>(cloud->fields.size() * sizeof(float));
    field.datatype = sensor_msgs::PointField::FLOAT32;
    field.count = 1;
    cloud->fields.push_back(field);
  }
  cloud->point_step = static_cast<std::uint32_t>(cloud->fields.size() * sizeof(float));
  cloud->row_step = cloud->width * cloud->point_step;
  cloud->data.resize(cloud->row_step);

  for (std::size_t i = 0; i < standing.size(); ++i) {
    const Eigen::Vector2d xy = output_pose * standing[i].head<2>().cast<double>();
    const Eigen::Vector3f point(static_cast<float>(xy.x()), static_cast<float>(xy.y()), standing[i].z());
    std::memcpy(cloud->data.data() + i * cloud->point_step, point.data(), sizeof point);
  }
  return cloud;
}

}  // namespace polygonal_perception::ros_perception
