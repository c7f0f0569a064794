#include "ros/perception/outputs.hpp"

#include <boost/make_shared.hpp>

#include "polygonal_perception/perception/floor/floor_frame.hpp"
#include "polygonal_perception/perception/floor/floor_hull.hpp"
#include "polygonal_perception/ros/common/polygon_messages.hpp"
#include "ros/perception/markers.hpp"
#include "ros/perception/message_conversions.hpp"
#include "ros/perception/obstacle_points.hpp"
#include "ros/perception/samples_image.hpp"
#include "ros/perception/topics.hpp"

namespace polygonal_perception::ros_perception {

namespace {

template <class Publisher>
bool isRead(const Publisher& publisher)
{
  return publisher.getNumSubscribers() > 0;
}

std_msgs::Header outputHeader(const Answer& answer)
{
  std_msgs::Header header;
  header.seq = answer.input.seq;
  header.stamp = answer.input.stamp;
  header.frame_id = answer.place->frame;
  return header;
}

}  // namespace

Outputs::Outputs(const ros::NodeHandle& private_handle, const std::function<void()>& readers_changed)
{
  ros::NodeHandle handle(private_handle);
  const auto changed = [readers_changed](const auto& /*reader*/) { readers_changed(); };
  const ros::SubscriberStatusCallback status = changed;
  const auto advertise = [&](auto message, const char* topic) {
    return handle.advertise<decltype(message)>(topic, topics::kOutputQueueSize, status, status);
  };
  floor_ = advertise(FloorPlane(), topics::kFloor);
  floor_coefficients_ = advertise(pcl_msgs::ModelCoefficients(), topics::kFloorCoefficients);
  occupancy_grid_ = advertise(nav_msgs::OccupancyGrid(), topics::kOccupancyGrid);
  inflated_grid_ = advertise(nav_msgs::OccupancyGrid(), topics::kInflatedGrid);
  polygons_ = advertise(PolygonArray(), topics::kPolygons);
  markers_ = advertise(visualization_msgs::MarkerArray(), topics::kMarkers);
  obstacle_points_ = advertise(sensor_msgs::PointCloud2(), topics::kObstaclePoints);
  const image_transport::SubscriberStatusCallback image_status = changed;
  samples_ = image_transport::ImageTransport(handle).advertise(topics::kSamples, topics::kOutputQueueSize,
                                                               image_status, image_status);
}

Outputs::~Outputs()
{
  shutdown();
}

void Outputs::shutdown()
{
  for (ros::Publisher* publisher : {&floor_, &floor_coefficients_, &occupancy_grid_, &inflated_grid_,
                                    &polygons_, &markers_, &obstacle_points_}) {
    publisher->shutdown();
  }
  samples_.shutdown();
}

bool Outputs::hasReaders() const
{
  return isRead(floor_) || isRead(floor_coefficients_) || isRead(samples_) || isRead(obstacle_points_) ||
         goal() != perception::Pipeline::Goal::kFloor;
}

perception::Pipeline::Goal Outputs::goal() const
{
  if (isRead(polygons_) || isRead(markers_)) return perception::Pipeline::Goal::kPolygons;
  if (isRead(inflated_grid_)) return perception::Pipeline::Goal::kInflation;
  if (isRead(occupancy_grid_)) return perception::Pipeline::Goal::kOccupancy;
  return perception::Pipeline::Goal::kFloor;
}

void Outputs::publish(const Answer& answer, perception::Pipeline& pipeline)
{
  // That of a held floor stays, and is none where nobody read it when the floor was found.
  if (answer.floor.status != perception::FloorStatus::kHeld) hull_.clear();
  if (answer.floor.status == perception::FloorStatus::kFound && (isRead(floor_) || isRead(markers_))) {
    hull_ = perception::floorHull(pipeline.samples(), pipeline.tracker().detector().labels(),
                                  answer.floor.floor.plane);
  }
  publishInInputFrame(answer, pipeline);
  if (answer.place) publishInOutputFrame(answer, pipeline);
  if (isRead(markers_)) publishMarkers(answer, pipeline);
}

void Outputs::publishInInputFrame(const Answer& answer, const perception::Pipeline& pipeline)
{
  if (isRead(floor_)) floor_.publish(toFloorPlane(answer.input, answer.floor, hull_));
  if (isRead(floor_coefficients_))
    floor_coefficients_.publish(toModelCoefficients(answer.input, answer.floor));
  if (isRead(samples_) && answer.goal) {
    const perception::SampleGrid& samples = pipeline.samples();
    const auto forward = perception::forwardAxis(samples, pipeline.parameters().tracker.initial_up);
    samples_.publish(toSamplesImage(answer.input, answer.points, samples,
                                    pipeline.tracker().detector().labels(),
                                    forward.value_or(Eigen::Vector3d::UnitZ())));
  }
}

void Outputs::publishInOutputFrame(const Answer& answer, perception::Pipeline& pipeline)
{
  const perception::Pipeline::Result& result = pipeline.result();
  const perception::FloorStatus status = answer.floor.status;
  const Eigen::Isometry2d& pose = answer.place->pose;
  const std_msgs::Header header = outputHeader(answer);
  // Without a floor there is an answer to everything, whether or not the pipeline has looked at the frame.
  const bool known = status != perception::FloorStatus::kNotFound;
  const auto has = [&](perception::Pipeline::Goal goal) {
    return !known || (answer.goal && *answer.goal >= goal);
  };
  const perception::GridGeometry geometry(pipeline.parameters().grid);

  if (isRead(occupancy_grid_) && has(perception::Pipeline::Goal::kOccupancy)) {
    occupancy_grid_.publish(known ? toOccupancyGrid(header, result.occupancy, pose)
                                  : toUnknownGrid(header, geometry, pose));
  }
  if (isRead(inflated_grid_) && has(perception::Pipeline::Goal::kInflation)) {
    inflated_grid_.publish(known ? toOccupancyGrid(header, result.inflated, pose)
                                 : toUnknownGrid(header, geometry, pose));
  }
  if (isRead(polygons_) && has(perception::Pipeline::Goal::kPolygons)) {
    polygons_.publish(
        ros_common::toPolygonArray({header, static_cast<std::uint8_t>(status),
                                    pipeline.parameters().inflation.robot_radius, geometry.bounds()},
                                   result.polygons, pose));
  }
  if (isRead(obstacle_points_)) {
    standing_.clear();
    if (known) pipeline.projection().collect(answer.points, result.to_floor_frame, geometry, standing_);
    obstacle_points_.publish(toObstaclePoints(header, standing_, pose));
  }
}

void Outputs::publishMarkers(const Answer& answer, const perception::Pipeline& pipeline)
{
  auto markers = boost::make_shared<visualization_msgs::MarkerArray>();
  static const geometry::PolygonSet kNoPolygons;  // delete those of the last frame
  const bool has_polygons = answer.place && answer.floor.status != perception::FloorStatus::kNotFound &&
                            answer.goal == perception::Pipeline::Goal::kPolygons;
  if (has_polygons) {
    appendPolygonMarkers(outputHeader(answer), pipeline.result().polygons, answer.place->pose, *markers);
  } else {
    appendPolygonMarkers(answer.input, kNoPolygons, Eigen::Isometry2d::Identity(), *markers);
  }
  appendFloorMarkers(answer.input, answer.floor, hull_, *markers);
  markers_.publish(markers);
}

}  // namespace polygonal_perception::ros_perception
