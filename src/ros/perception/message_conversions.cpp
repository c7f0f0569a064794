#include "ros/perception/message_conversions.hpp"

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cmath>

#include "polygonal_perception/ros/common/grid_messages.hpp"

namespace polygonal_perception::ros_perception {

static_assert(static_cast<int>(perception::FloorStatus::kNotFound) == FloorPlane::NOT_FOUND &&
                  static_cast<int>(perception::FloorStatus::kFound) == FloorPlane::FOUND &&
                  static_cast<int>(perception::FloorStatus::kHeld) == FloorPlane::HELD &&
                  static_cast<int>(perception::FloorStatus::kAssumed) == FloorPlane::ASSUMED,
              "the status goes into the message as it is");
static_assert(static_cast<int>(perception::PlaneKind::kUnknown) == Plane::UNKNOWN &&
                  static_cast<int>(perception::PlaneKind::kFloor) == Plane::FLOOR &&
                  static_cast<int>(perception::PlaneKind::kHorizontal) == Plane::HORIZONTAL &&
                  static_cast<int>(perception::PlaneKind::kVertical) == Plane::VERTICAL &&
                  static_cast<int>(perception::PlaneKind::kSloped) == Plane::SLOPED,
              "the kind goes into the message as it is");

namespace {

geometry_msgs::Vector3 toVector(const Eigen::Vector3d& v)
{
  geometry_msgs::Vector3 message;
  message.x = v.x();
  message.y = v.y();
  message.z = v.z();
  return message;
}

/// @param to  takes on as many points
void copyPoints(const Eigen::Vector3f* points, std::size_t count, std::vector<geometry_msgs::Point32>& to)
{
  to.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    to[i].x = points[i].x();
    to[i].y = points[i].y();
    to[i].z = points[i].z();
  }
}

}  // namespace

FloorPlanePtr toFloorPlane(const std_msgs::Header& header, const perception::FloorState& floor,
                           const Eigen::Isometry3d& to_floor_frame, const std::vector<Eigen::Vector3f>& hull)
{
  auto message = boost::make_shared<FloorPlane>();
  message->header = header;
  message->status = static_cast<std::uint8_t>(floor.status);
  if (floor.status == perception::FloorStatus::kNotFound) return message;

  const geometry::Plane& plane = floor.floor.plane;
  message->normal = toVector(plane.normal);
  message->distance = plane.distance;
  message->age = floor.age;
  message->sample_count = floor.floor.sample_count;
  message->rms_error = floor.floor.rms_error;
  const Eigen::Matrix3d covariance = perception::tiltCovariance(floor.floor.covariance, to_floor_frame);
  std::size_t k = 0;
  for (int row = 0; row < 3; ++row) {
    for (int column = row; column < 3; ++column) message->covariance[k++] = covariance(row, column);
  }
  copyPoints(hull.data(), hull.size(), message->hull);
  return message;
}

pcl_msgs::ModelCoefficientsPtr toModelCoefficients(const std_msgs::Header& header,
                                                   const perception::FloorState& floor)
{
  auto message = boost::make_shared<pcl_msgs::ModelCoefficients>();
  message->header = header;
  if (floor.status == perception::FloorStatus::kNotFound) return message;
  const Eigen::Vector4f plane =
      (Eigen::Vector4d() << floor.floor.plane.normal, floor.floor.plane.distance).finished().cast<float>();
  message->values.assign(plane.data(), plane.data() + plane.size());
  return message;
}

PlaneArrayPtr toPlaneArray(const std_msgs::Header& header, const perception::SegmentedPlanes& planes)
{
  auto message = boost::make_shared<PlaneArray>();
  message->header = header;
  message->planes.resize(planes.planes.size());
  for (std::size_t i = 0; i < planes.planes.size(); ++i) {
    const perception::SegmentedPlane& plane = planes.planes[i];
    Plane& to = message->planes[i];
    to.id = plane.id;
    to.normal = toVector(plane.plane.normal);
    to.distance = plane.plane.distance;
    to.rms_error = plane.rms_error;
    to.sample_count = plane.sample_count;
    copyPoints(planes.vertices.data() + plane.first_vertex, plane.vertex_count, to.boundary);
    to.kind = static_cast<std::uint8_t>(plane.kind);
  }
  return message;
}

ObservedCellsPtr toObservedCells(const std_msgs::Header& header, const perception::FloorState& floor,
                                 const occupancy::BinaryGrid& occupancy,
                                 const occupancy::ObservedCells& observed, double slab_height,
                                 const Eigen::Isometry2d& output_pose)
{
  auto message = boost::make_shared<ObservedCells>();
  message->header = header;
  message->floor_status = static_cast<std::uint8_t>(floor.status);
  message->info = ros_common::toMetaData(header.stamp, occupancy.geometry(), output_pose);
  message->slab_height = static_cast<float>(slab_height);
  message->hit = observed.hit;
  message->free = observed.free;
  // What was not seen itself clears nothing.
  message->floor.resize(observed.floor.size());
  std::transform(observed.floor.begin(), observed.floor.end(), message->floor.begin(),
                 [](std::uint8_t floor) {
                   return static_cast<std::uint8_t>(floor == occupancy::ObservedCells::kSeen ? 1 : 0);
                 });
  for (auto* cells : {&message->hit, &message->free, &message->floor})
    cells->resize(occupancy.geometry().size(), 0);
  for (std::size_t cell = 0; cell < message->hit.size(); ++cell) {
    // A drop has no points that stand: a map that did not know of it would lead into it.
    if (occupancy.cells()[cell] != 0 && message->hit[cell] == 0) message->hit[cell] = 1;
  }
  return message;
}

sensor_msgs::LaserScanPtr toLaserScan(const std_msgs::Header& header, const perception::LevelScan& scan)
{
  auto message = boost::make_shared<sensor_msgs::LaserScan>();
  message->header = header;
  const perception::BearingBins& bins = scan.bins;
  message->angle_min = static_cast<float>(bins.first);
  message->angle_max = static_cast<float>(bins.bearing(bins.count - 1));
  message->angle_increment = static_cast<float>(bins.increment);
  // What stands under the camera is a range, too.
  message->range_min = 0.0F;
  message->range_max = static_cast<float>(scan.range_max);
  message->ranges = scan.ranges;
  return message;
}

}  // namespace polygonal_perception::ros_perception
