#include "ros/perception/outputs.hpp"

#include <boost/make_shared.hpp>

#include "polygonal_perception/ros/common/grid_messages.hpp"
#include "polygonal_perception/ros/common/polygon_markers.hpp"
#include "polygonal_perception/ros/common/polygon_messages.hpp"
#include "ros/perception/markers.hpp"
#include "ros/perception/message_conversions.hpp"
#include "ros/perception/obstacle_points.hpp"
#include "ros/perception/samples_image.hpp"

namespace polygonal_perception::ros_perception {

namespace {

using perception::Product;
using perception::Products;

/// Whether there is something to say about a product in the output frame. A reader who came while the frame
/// was looked at waits for the next one; but without a floor there is an answer to everything, whoever asked.
bool canTell(const FrameResult& frame, Product product)
{
  return frame.output && (!frame.hasFloor() || frame.result.products.has(product));
}

nav_msgs::OccupancyGridPtr toGrid(const FrameResult& frame, Product product,
                                  const occupancy::BinaryGrid& grid)
{
  if (!canTell(frame, product)) return nullptr;
  const Eigen::Isometry2d& pose = frame.output->pose;
  return frame.hasFloor() ? ros_common::toOccupancyGrid(frame.outputHeader(), grid, pose)
                          : ros_common::toUnknownGrid(frame.outputHeader(), grid.geometry(), pose);
}

/// The same in the input's frame, for the floor with its hull.
bool canTellHull(const FrameResult& frame)
{
  return !frame.hasFloor() || frame.result.products.has(Product::kFloorHull);
}

FloorPlanePtr floor(const FrameResult& frame)
{
  if (!canTellHull(frame)) return nullptr;
  return toFloorPlane(frame.input, frame.result.floor, frame.result.to_floor_frame, frame.result.floor_hull);
}

pcl_msgs::ModelCoefficientsPtr floorCoefficients(const FrameResult& frame)
{
  return toModelCoefficients(frame.input, frame.result.floor);
}

PlaneArrayPtr planes(const FrameResult& frame)
{
  if (frame.hasFloor() && !frame.result.products.has(Product::kPlanes)) return nullptr;
  return toPlaneArray(frame.input, frame.result.planes);
}

nav_msgs::OccupancyGridPtr occupancyGrid(const FrameResult& frame)
{
  return toGrid(frame, Product::kOccupancy, frame.result.occupancy);
}

nav_msgs::OccupancyGridPtr observedGrid(const FrameResult& frame)
{
  if (!canTell(frame, Product::kObserved)) return nullptr;
  const perception::Pipeline::Result& result = frame.result;
  const Eigen::Isometry2d& pose = frame.output->pose;
  return frame.hasFloor()
             ? ros_common::toObservedGrid(frame.outputHeader(), result.occupancy, result.observed.floor, pose)
             : ros_common::toUnknownGrid(frame.outputHeader(), result.occupancy.geometry(), pose);
}

ObservedCellsPtr observedCells(const FrameResult& frame)
{
  if (!canTell(frame, Product::kLookedThrough)) return nullptr;
  const perception::Pipeline::Result& result = frame.result;
  return toObservedCells(frame.outputHeader(), result.floor, result.occupancy, result.observed,
                         frame.parameters.projection.slabHeight(), frame.output->pose);
}

sensor_msgs::LaserScanPtr scan(const FrameResult& frame)
{
  if (frame.result.scan.ranges.empty()) return nullptr;
  return toLaserScan(frame.floorHeader(), frame.result.scan);
}

nav_msgs::OccupancyGridPtr inflatedGrid(const FrameResult& frame)
{
  return toGrid(frame, Product::kInflation, frame.result.inflated);
}

PolygonArrayPtr polygons(const FrameResult& frame)
{
  if (!canTell(frame, Product::kPolygons)) return nullptr;
  const ros_common::PolygonContext context{
      frame.outputHeader(), static_cast<std::uint8_t>(frame.result.floor.status),
      frame.parameters.inflation.robot_radius, frame.result.occupancy.geometry().bounds()};
  return ros_common::toPolygonArray(context, frame.result.polygons, frame.output->pose);
}

visualization_msgs::MarkerArrayPtr markers(const FrameResult& frame)
{
  if (!canTellHull(frame)) return nullptr;
  auto markers = boost::make_shared<visualization_msgs::MarkerArray>();
  static const geometry::PolygonSet kNoPolygons;  // delete those of the last frame
  if (frame.output && frame.hasFloor() && frame.result.products.has(Product::kPolygons)) {
    ros_common::appendPolygonMarkers(frame.outputHeader(), frame.result.polygons, frame.output->pose,
                                     ros_common::kFrameColor, *markers);
  } else {
    ros_common::appendPolygonMarkers(frame.input, kNoPolygons, Eigen::Isometry2d::Identity(),
                                     ros_common::kFrameColor, *markers);
  }
  appendFloorMarkers(frame.input, frame.result.floor, frame.result.floor_hull, *markers);
  return markers;
}

sensor_msgs::PointCloud2Ptr obstaclePoints(const FrameResult& frame)
{
  if (!canTell(frame, Product::kObstaclePoints)) return nullptr;
  return toObstaclePoints(frame.outputHeader(), frame.result.obstacle_points, frame.output->pose);
}

sensor_msgs::ImagePtr samples(const FrameResult& frame)
{
  if (!frame.result.products.has(Product::kSampleLabels)) return nullptr;
  return toSamplesImage(frame.input, frame.points, frame.result.samples, frame.result.labels,
                        frame.result.view.forward);
}

}  // namespace

void addOutputs(Outputs& outputs)
{
  // Topic, what it is made of, how it is built.
  outputs.add<FloorPlane>("floor", Product::kFloorHull, floor);
  outputs.add<pcl_msgs::ModelCoefficients>("floor_coefficients", Product::kFloor, floorCoefficients);
  outputs.add<PlaneArray>("planes", Product::kPlanes, planes);
  outputs.add<nav_msgs::OccupancyGrid>("occupancy_grid", Product::kOccupancy, occupancyGrid);
  outputs.add<nav_msgs::OccupancyGrid>("observed_grid", Product::kObserved, observedGrid);
  outputs.add<ObservedCells>("observed_cells", Product::kLookedThrough, observedCells);
  outputs.add<sensor_msgs::LaserScan>("scan", Product::kScan, scan);
  outputs.add<nav_msgs::OccupancyGrid>("inflated_grid", Product::kInflation, inflatedGrid);
  outputs.add<PolygonArray>("polygons", Product::kPolygons, polygons);
  outputs.add<visualization_msgs::MarkerArray>("markers", Products{Product::kPolygons, Product::kFloorHull},
                                               markers);
  outputs.add<sensor_msgs::PointCloud2>("obstacle_points", Product::kObstaclePoints, obstaclePoints);
  outputs.addImage("samples", Product::kSampleLabels, samples);
}

}  // namespace polygonal_perception::ros_perception
