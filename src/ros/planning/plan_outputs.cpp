#include "polygonal_perception/ros/planning/plan_outputs.hpp"

#include <polygonal_perception/PlanStatus.h>
#include <visualization_msgs/MarkerArray.h>

#include <boost/make_shared.hpp>
#include <cmath>

#include "polygonal_perception/ros/common/marker_parts.hpp"

namespace polygonal_perception::ros_planning {

namespace {

// As figure 7 of the paper has them. Heights keep them apart.
constexpr double kPathWidth = 0.05;            // [m]
constexpr double kGraphWidth = 0.01;           // [m]
constexpr double kPathHeight = 0.03;           // [m]
constexpr double kGraphHeight = 0.01;          // [m]
constexpr double kCross = 0.15;                // [m] half of the goal's cross
constexpr std::size_t kMostGraphEdges = 2000;  // a picture of more is a grey area

nav_msgs::PathPtr path(const PlanResult& result)
{
  return boost::make_shared<nav_msgs::Path>(toPath(result.header, result.plan.path, result.goal_yaw));
}

PlanStatusPtr status(const PlanResult& result)
{
  auto message = boost::make_shared<PlanStatus>();
  message->header = result.header;
  message->status = result.status;
  message->message = result.message;
  message->length = result.plan.length;
  message->start_shift = result.plan.start_shift;
  message->goal_shift = result.plan.goal_shift;
  return message;
}

geometry_msgs::Point at(const Eigen::Vector2d& p, double height)
{
  return ros_common::point(p.x(), p.y(), height);
}

visualization_msgs::MarkerArrayPtr markers(const PlanResult& result)
{
  using visualization_msgs::Marker;
  auto array = boost::make_shared<visualization_msgs::MarkerArray>();
  array->markers.reserve(3);  // references stay

  Marker& graph = ros_common::append(*array, result.header, "visibility_graph", Marker::LINE_LIST);
  graph.scale.x = kGraphWidth;
  graph.color = ros_common::color(0.5F, 0.5F, 0.5F, 0.6F);
  Marker& way = ros_common::append(*array, result.header, "path", Marker::LINE_STRIP);
  way.scale.x = kPathWidth;
  way.color = ros_common::color(0.1F, 0.7F, 0.2F, 1.0F);
  Marker& cross = ros_common::append(*array, result.header, "goal", Marker::LINE_LIST);
  cross.scale.x = kPathWidth;
  cross.color = ros_common::color(0.1F, 0.5F, 0.1F, 1.0F);

  if (!result.plan.path.empty()) {
    std::vector<planning::PathSearch::SeenEdge> edges;
    result.search.seenEdges(edges);
    if (edges.size() > kMostGraphEdges) edges.resize(kMostGraphEdges);
    for (const auto& edge : edges) {
      graph.points.push_back(at(edge.from, kGraphHeight));
      graph.points.push_back(at(edge.to, kGraphHeight));
    }
    for (const Eigen::Vector2d& corner : result.plan.path) way.points.push_back(at(corner, kPathHeight));
    const Eigen::Vector2d& goal = result.plan.path.back();
    for (const Eigen::Vector2d& arm : {Eigen::Vector2d(kCross, kCross), Eigen::Vector2d(kCross, -kCross)}) {
      cross.points.push_back(at(goal - arm, kPathHeight));
      cross.points.push_back(at(goal + arm, kPathHeight));
    }
  }
  for (Marker& marker : array->markers) ros_common::deleteIfEmpty(marker);
  return array;
}

}  // namespace

nav_msgs::Path toPath(const std_msgs::Header& header, const std::vector<Eigen::Vector2d>& corners,
                      const std::optional<double>& goal_yaw)
{
  nav_msgs::Path path;
  path.header = header;
  path.poses.resize(corners.size());
  const auto yawFrom = [&](std::size_t i) {
    // The next corner that lies elsewhere, or at the end the last one that did.
    std::size_t k = i;
    while (k + 1 < corners.size() && corners[k + 1] == corners[i]) ++k;
    std::size_t from = i;
    if (k + 1 == corners.size()) {
      while (from > 0 && corners[from] == corners[i]) --from;
    } else {
      ++k;
    }
    const Eigen::Vector2d along = corners[k] - corners[from];
    return std::atan2(along.y(), along.x());
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double yaw = i + 1 == corners.size() && goal_yaw ? *goal_yaw : yawFrom(i);
    geometry_msgs::PoseStamped& pose = path.poses[i];
    pose.header = header;
    pose.pose.position.x = corners[i].x();
    pose.pose.position.y = corners[i].y();
    pose.pose.orientation.z = std::sin(0.5 * yaw);
    pose.pose.orientation.w = std::cos(0.5 * yaw);
  }
  return path;
}

void addOutputs(PlanOutputs& outputs)
{
  outputs.add<nav_msgs::Path>("path", {}, path);
  outputs.add<PlanStatus>("status", {}, status);
  outputs.add<visualization_msgs::MarkerArray>("markers", {}, markers);
}

}  // namespace polygonal_perception::ros_planning
