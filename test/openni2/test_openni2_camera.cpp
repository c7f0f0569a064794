// End to end: virtual device -> OpenNI2 -> nodelet -> pipeline, compared with what was rendered.
#include <gtest/gtest.h>
#include <polygonal_perception/FloorPlane.h>
#include <polygonal_perception/PolygonArray.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <map>
#include <opencv2/imgproc.hpp>

#include "plug.hpp"
#include "polygonal_perception/perception/floor/floor_frame.hpp"
#include "rendered_frames.hpp"

namespace polygonal_perception::test {
namespace {

/// All messages of a topic by their stamps.
template <class Message>
class Collected
{
public:
  Collected(ros::NodeHandle& node, const std::string& topic)
      : subscriber_(node.subscribe(topic, 100, &Collected::add, this))
  {
  }
  std::map<ros::Time, typename Message::ConstPtr> by_stamp;

private:
  void add(const typename Message::ConstPtr& message) { by_stamp[message->header.stamp] = message; }
  ros::Subscriber subscriber_;
};

class OpenNI2CameraNodelet : public testing::Test
{
protected:
  template <class Condition>
  bool waitFor(Condition&& condition)
  {
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(40.0);
    while (ros::ok() && ros::WallTime::now() < deadline) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
      if (condition()) return true;
    }
    return false;
  }
  std::vector<ros::Time> complete() const
  {
    std::vector<ros::Time> stamps;
    for (const auto& entry : raw_.by_stamp) {
      const ros::Time& stamp = entry.first;
      if (rectified_.by_stamp.count(stamp) + info_.by_stamp.count(stamp) + floor_.by_stamp.count(stamp) +
              polygons_.by_stamp.count(stamp) ==
          4)
        stamps.push_back(stamp);
    }
    return stamps;
  }
  std::string seen() const
  {
    return "images " + std::to_string(raw_.by_stamp.size()) + ", rectified " +
           std::to_string(rectified_.by_stamp.size()) + ", infos " + std::to_string(info_.by_stamp.size()) +
           ", floors " + std::to_string(floor_.by_stamp.size()) + ", polygons " +
           std::to_string(polygons_.by_stamp.size());
  }

  ros::NodeHandle node_;
  virtual_device::Plug plug_{ros::NodeHandle("~").param<std::string>("plug", "")};
  Collected<sensor_msgs::Image> raw_{node_, "camera/depth/image_raw"};
  Collected<sensor_msgs::Image> rectified_{node_, "camera/depth/image_rect"};
  Collected<sensor_msgs::CameraInfo> info_{node_, "camera/depth/camera_info"};
  Collected<FloorPlane> floor_{node_, "polygonal_perception/floor"};
  Collected<PolygonArray> polygons_{node_, "polygonal_perception/polygons"};
};

/// The true points of obstacles of a frame, in the floor's frame [m], well inside the grid and the heights
/// that count.
std::vector<cv::Point2f> obstaclePoints(const simulation::SimulatedFrame& frame,
                                        const simulation::PinholeCamera& camera)
{
  const Eigen::Isometry3d to_floor = perception::floorFrame(frame.floor, perception::ViewAxes{});
  std::vector<cv::Point2f> points;
  for (std::size_t i = 0; i < frame.depth.size(); i += 3) {
    const double z = frame.truth.depth[i];
    if (std::isnan(frame.depth[i]) || std::isnan(z)) continue;
    const std::size_t column = i % camera.width;
    const std::size_t row = i / camera.width;
    const double u = static_cast<double>(column);
    const double v = static_cast<double>(row);
    const Eigen::Vector3d p =
        to_floor * Eigen::Vector3d((u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z);
    if (p.z() > 0.08 && p.z() < 0.55 && p.x() > 0.3 && p.x() < 4.5 && std::abs(p.y()) < 2.3)
      points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
  }
  return points;
}

std::vector<std::vector<cv::Point2f>> boundaries(const PolygonArray& message)
{
  std::vector<std::vector<cv::Point2f>> result;
  for (const ObstaclePolygon& polygon : message.polygons) {
    result.emplace_back();
    for (const auto& vertex : polygon.boundary.points) result.back().emplace_back(vertex.x, vertex.y);
  }
  return result;
}

bool isInsideOne(const cv::Point2f& point, const std::vector<std::vector<cv::Point2f>>& polygons)
{
  for (const auto& polygon : polygons) {
    if (cv::pointPolygonTest(polygon, point, false) >= 0.0) return true;
  }
  return false;
}

void compareFloor(const FloorPlane& found, const geometry::Plane& truth)
{
  ASSERT_EQ(found.status, FloorPlane::FOUND);
  const Eigen::Vector3d normal(found.normal.x, found.normal.y, found.normal.z);
  const double angle = std::atan2(normal.cross(truth.normal).norm(), normal.dot(truth.normal));
  EXPECT_LT(angle * 180.0 / M_PI, 1.0);
  EXPECT_NEAR(found.distance, truth.distance, 0.02);
}

void comparePolygons(const PolygonArray& found, const std::vector<cv::Point2f>& truth)
{
  const auto polygons = boundaries(found);
  std::size_t inside = 0;
  for (const cv::Point2f& point : truth) inside += isInsideOne(point, polygons) ? 1 : 0;
  EXPECT_GE(static_cast<double>(inside), 0.99 * static_cast<double>(truth.size()));
}

TEST_F(OpenNI2CameraNodelet, FindsTheTrueFloorAndObstaclesAndSurvivesAnUnplug)
{
  plug_.putIn();
  ASSERT_TRUE(waitFor([this] { return complete().size() >= 10; })) << seen();

  virtual_device::RenderedFrames rendered({320, 240, 30});
  const simulation::PinholeCamera& camera = rendered.camera().options().camera;
  std::uint32_t index = 0;
  std::size_t obstacles = 0;
  for (const ros::Time& stamp : complete()) {
    const sensor_msgs::Image& image = *raw_.by_stamp[stamp];
    ASSERT_EQ(image.encoding, "16UC1");
    EXPECT_EQ(image.header.frame_id, "camera_depth_optical_frame");
    EXPECT_EQ(rectified_.by_stamp[stamp]->data, image.data);
    EXPECT_NEAR(info_.by_stamp[stamp]->K[0], camera.fx, 1e-3);
    EXPECT_NEAR(info_.by_stamp[stamp]->K[2], camera.cx, 1e-9);
    EXPECT_LT(std::abs((ros::Time::now() - stamp).toSec()), 60.0);

    const std::uint32_t first = index;
    const auto is_image = [&](const std::vector<std::uint16_t>& depth) {
      return depth.size() * 2 == image.data.size() &&
             std::memcmp(depth.data(), image.data.data(), image.data.size()) == 0;
    };
    while (index < first + 60 && !is_image(rendered.depth(index))) ++index;
    ASSERT_LT(index, first + 60) << "the image is none of the rendered frames from " << first << " on";

    SCOPED_TRACE("frame " + std::to_string(index));
    const simulation::SimulatedFrame& truth = rendered.frame(index);
    compareFloor(*floor_.by_stamp[stamp], truth.floor);
    const auto points = obstaclePoints(truth, camera);
    obstacles += points.size();
    comparePolygons(*polygons_.by_stamp[stamp], points);
    ++index;
  }
  EXPECT_GT(obstacles, 1000U) << "the scene shows too little to compare";

  plug_.pull();
  std::size_t count = 0;
  ros::WallTime last;
  ASSERT_TRUE(waitFor([&] {
    if (raw_.by_stamp.size() != count) last = ros::WallTime::now();
    count = raw_.by_stamp.size();
    return ros::WallTime::now() - last > ros::WallDuration(1.0);
  })) << "the frames go on";
  const ros::Time back = ros::Time::now();
  plug_.putIn();
  ASSERT_TRUE(waitFor([&] {
    const auto stamps = complete();
    return !stamps.empty() && stamps.back() > back;
  })) << seen();
}

}  // namespace
}  // namespace polygonal_perception::test

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_openni2_camera");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
