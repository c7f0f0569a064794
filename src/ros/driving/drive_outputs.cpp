#include "ros/driving/drive_outputs.hpp"

#include <visualization_msgs/MarkerArray.h>

#include <boost/make_shared.hpp>

#include "polygonal_perception/ros/common/marker_parts.hpp"

namespace polygonal_perception::ros_driving {

namespace {

constexpr double kTriedWidth = 0.005;  // [m]
constexpr double kChosenWidth = 0.04;  // [m]
constexpr double kHeight = 0.02;       // [m] over the floor, to be seen
constexpr int kChords = 8;             // that an arc is drawn with

DriveStatusPtr status(const DriveResult& result)
{
  auto message = boost::make_shared<DriveStatus>();
  message->header = result.report.header;
  message->status = result.report.status;
  message->message = result.report.message;
  message->time_to_collision = result.report.time_to_collision;
  return message;
}

void appendArc(const planning::DynamicWindow::Tried& tried, std::vector<geometry_msgs::Point>& points)
{
  Eigen::Vector2d last = tried.arc.start().position;
  for (int i = 1; i <= kChords; ++i) {
    const Eigen::Vector2d next = tried.arc.position(tried.duration * i / kChords);
    points.push_back(ros_common::point(last.x(), last.y(), kHeight));
    points.push_back(ros_common::point(next.x(), next.y(), kHeight));
    last = next;
  }
}

visualization_msgs::MarkerArrayPtr markers(const DriveResult& result)
{
  using visualization_msgs::Marker;
  auto array = boost::make_shared<visualization_msgs::MarkerArray>();
  array->markers.reserve(2);  // references stay
  const bool drives = result.report.status == DriveStatus::DRIVING;
  Marker& tried = ros_common::append(*array, result.report.header, "tried", Marker::LINE_LIST);
  tried.scale.x = kTriedWidth;
  tried.color = ros_common::color(0.2F, 0.4F, 1.0F, 0.5F);
  Marker& chosen = ros_common::append(*array, result.report.header, "chosen", Marker::LINE_LIST);
  chosen.scale.x = kChosenWidth;
  chosen.color = ros_common::color(0.1F, 0.2F, 0.9F, 1.0F);
  if (drives) {
    for (const auto& one : result.window.tried()) appendArc(one, tried.points);
    if (result.window.chosen()) appendArc(*result.window.chosen(), chosen.points);
  }
  for (Marker& marker : array->markers) ros_common::deleteIfEmpty(marker);
  return array;
}

}  // namespace

void addOutputs(DriveOutputs& outputs)
{
  outputs.add<DriveStatus>("status", {}, status);
  outputs.add<visualization_msgs::MarkerArray>("markers", {}, markers);
}

}  // namespace polygonal_perception::ros_driving
