#include "cameras/simulation_ros/simulated_camera_ros.hpp"

#include <cmath>
#include <stdexcept>

#include "cameras/simulation_ros/simulated_camera_messages.hpp"

namespace polygonal_perception::simulation_ros {
namespace {

constexpr int kMaxSide = 8192;  // [px] of an image

int readSize(const ros::NodeHandle& node, const std::string& name, std::uint32_t fallback)
{
  const int value = node.param(name, static_cast<int>(fallback));
  if (value < 1 || value > kMaxSide) {
    throw std::invalid_argument(name + " is " + std::to_string(value) + ", must be within 1.." +
                                std::to_string(kMaxSide));
  }
  return value;
}

/// Reads the parameters of the noise, each as noise_<its name>.
class NoiseReader
{
public:
  explicit NoiseReader(const ros::NodeHandle& node) : node_(node) {}
  template <class T>
  void operator()(const char* name, T& value, const parameters::Range& /*range*/, const char* /*unit*/,
                  const char* /*help*/) const
  {
    node_.param(std::string("noise_") + name, value, value);
  }

private:
  ros::NodeHandle node_;
};

simulation::SimulatedCamera::Options readOptions(const ros::NodeHandle& node)
{
  simulation::SimulatedCamera::Options options;
  node.param("scene", options.scene, options.scene);
  node.param("trajectory", options.trajectory, options.trajectory);
  options.seed = static_cast<std::uint64_t>(node.param("seed", static_cast<int>(options.seed)));
  node.param("rate", options.rate, options.rate);
  const int width = readSize(node, "width", options.camera.width);
  const int height = readSize(node, "height", options.camera.height);
  options.camera = simulation::PinholeCamera::ofSize(static_cast<std::uint32_t>(width),
                                                     static_cast<std::uint32_t>(height));
  if (!node.param("noise", true)) options.noise = simulation::DepthNoise::Parameters::none();
  simulation::DepthNoise::Parameters::describe(options.noise, NoiseReader(node));
  return options;
}

}  // namespace

SimulatedCameraRos::SimulatedCameraRos(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : camera_(std::make_unique<simulation::SimulatedCamera>(readOptions(private_node)))
{
  private_node.param("min_height", min_height_, min_height_);
  private_node.param("max_height", max_height_, max_height_);
  private_node.param("publish_tf", publish_tf_, publish_tf_);
  world_frame_ = private_node.param<std::string>("world_frame", "odom");
  base_frame_ = private_node.param<std::string>("base_frame", "base_link");
  body_frame_ = private_node.param<std::string>("camera_frame", "camera_link");
  optical_frame_ = private_node.param<std::string>("optical_frame", "camera_depth_optical_frame");

  ros::NodeHandle camera_node(node, private_node.param<std::string>("camera", "camera"));
  image_transport::ImageTransport transport(camera_node);
  raw_ = transport.advertiseCamera("depth/image_raw", 1);
  rectified_ = transport.advertise("depth/image_rect", 1);
  points_ = camera_node.advertise<sensor_msgs::PointCloud2>("depth/points", 1);
  ros::NodeHandle truth_node(private_node, "ground_truth");
  true_floor_ = truth_node.advertise<FloorPlane>("floor", 1);
  true_obstacles_ = truth_node.advertise<PolygonArray>("obstacles", 1);

  start_ = ros::Time::now();
  if (publish_tf_) static_tf_.sendTransform(toOpticalTransform(start_, body_frame_, optical_frame_));
  timer_ = ros::NodeHandle(node).createTimer(ros::Duration(1.0 / camera_->options().rate),
                                             [this](const ros::TimerEvent&) { tick(); });
}

SimulatedCameraRos::~SimulatedCameraRos()
{
  timer_.stop();
}

void SimulatedCameraRos::tick()
{
  const ros::Time stamp = ros::Time::now();
  // After a jump back in time everything begins again.
  if (stamp < start_) start_ = stamp;
  const auto index =
      static_cast<std::uint32_t>(std::lround((stamp - start_).toSec() * camera_->options().rate));
  if (publish_tf_) {
    tf_.sendTransform(toTransforms(camera_->pose(index), stamp, world_frame_, base_frame_, body_frame_));
  }
  if (frameIsRead()) {
    camera_->render(index, frame_);
    publishFrame(stamp);
  }
  if (true_obstacles_.getNumSubscribers() > 0) {
    std_msgs::Header world;
    world.stamp = stamp;
    world.frame_id = world_frame_;
    const double time = index / camera_->options().rate;
    true_obstacles_.publish(boost::make_shared<PolygonArray>(
        toPolygons(camera_->scene().obstacles(time, min_height_, max_height_), world)));
  }
}

bool SimulatedCameraRos::frameIsRead() const
{
  return raw_.getNumSubscribers() > 0 || rectified_.getNumSubscribers() > 0 ||
         points_.getNumSubscribers() > 0 || true_floor_.getNumSubscribers() > 0;
}

void SimulatedCameraRos::publishFrame(const ros::Time& stamp)
{
  const simulation::PinholeCamera& camera = camera_->options().camera;
  std_msgs::Header header;
  header.seq = ++sequence_;
  header.stamp = stamp;
  header.frame_id = optical_frame_;
  if (raw_.getNumSubscribers() > 0 || rectified_.getNumSubscribers() > 0) {
    // A pinhole's raw image is rectified.
    const sensor_msgs::ImageConstPtr image = toImage(frame_, camera, header);
    raw_.publish(image, boost::make_shared<sensor_msgs::CameraInfo>(toCameraInfo(camera, header)));
    rectified_.publish(image);
  }
  if (points_.getNumSubscribers() > 0) points_.publish(toCloud(frame_, camera, header));
  if (true_floor_.getNumSubscribers() > 0)
    true_floor_.publish(boost::make_shared<FloorPlane>(toFloor(frame_, header)));
}

}  // namespace polygonal_perception::simulation_ros
