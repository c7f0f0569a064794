#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/cameras/simulation/driven_robot.hpp"
#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"

namespace polygonal_perception::simulation_ros {

/// "corridor, office, ..."
inline std::string listed(const std::vector<std::string>& names)
{
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

inline std::vector<std::string> scenesAndCourses()
{
  std::vector<std::string> names = simulation::sceneNames();
  names.insert(names.end(), simulation::courseNames().begin(), simulation::courseNames().end());
  return names;
}
inline bool isScene(const std::string& text)
{
  const auto names = scenesAndCourses();
  return std::find(names.begin(), names.end(), text) != names.end();
}
/// Not a trajectory: the robot obeys cmd_vel.
inline constexpr char kDriven[] = "cmd_vel";

inline bool isTrajectory(const std::string& text)
{
  const auto& names = simulation::trajectoryNames();
  return text == kDriven || std::find(names.begin(), names.end(), text) != names.end();
}
inline bool isName(const std::string& text)
{
  return !text.empty();
}

/// Every parameter of the simulated camera, read when it starts.
struct SimulatedCameraParameters
{
  std::string camera = "camera";
  std::vector<std::string> cameras;  ///< several in the place of `camera`
  std::string scene = "office";
  std::string trajectory = "robotino";
  int seed = 1;
  double rate = 30.0;  ///< [Hz]
  int width = 640;     ///< [px]
  int height = 480;    ///< [px]
  bool has_noise = true;
  simulation::DepthNoise::Parameters noise;
  double min_height = 0.03;  ///< [m] of the obstacles in the truth
  double max_height = 0.60;  ///< [m]
  bool publish_tf = true;
  std::string world_frame = "odom";
  std::string base_frame = "base_link";
  std::string camera_frame = "camera_link";
  std::string optical_frame = "camera_depth_optical_frame";
  simulation::DrivenRobot::Parameters robot;  ///< where it is driven

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    using parameters::Range;
    using parameters::TextRule;
    const TextRule name{"a name", isName};
    visit("camera", self.camera, name, "Namespace of the camera's topics.");
    visit("cameras", self.cameras,
          "Of several cameras in its place, spread evenly around the robot, each with frames of its name; "
          "the first "
          "looks ahead.");
    static const std::string scenes = listed(scenesAndCourses());
    static const std::string trajectories = listed(simulation::trajectoryNames()) + ", " + kDriven;
    visit("scene", self.scene, TextRule{scenes.c_str(), isScene}, "Where the camera looks.");
    visit("trajectory", self.trajectory, TextRule{trajectories.c_str(), isTrajectory},
          "How it moves; by cmd_vel: as it is told.");
    visit("seed", self.seed, Range{0, 1e9}.atStart(), "", "Another number, another room.");
    visit("rate", self.rate, Range{0.1, 1000.0}.atStart(), "Hz", "Frames a second.");
    visit("width", self.width, Range{1, 8192}.atStart(), "px", "Of the image.");
    visit("height", self.height, Range{1, 8192}.atStart(), "px", "Of the image.");
    visit("noise", self.has_noise,
          "Whether depth has the noise of a structured-light camera; false: noise_... have no effect.");
    simulation::DepthNoise::Parameters::describe(
        self.noise,
        [&visit](const char* noise_name, auto& value, const Range& range, const auto&... unit_and_help) {
          visit(("noise_" + std::string(noise_name)).c_str(), value, range.atStart(), unit_and_help...);
        });
    visit("min_height", self.min_height, Range{-10.0, 10.0}.atStart(), "m", "Lowest of the true obstacles.");
    visit("max_height", self.max_height, Range{-10.0, 10.0}.atStart(), "m", "Highest of the true obstacles.");
    visit("publish_tf", self.publish_tf, "Whether to broadcast the robot's and the camera's frames.");
    visit("world_frame", self.world_frame, name, "Frame in which the room stands still.");
    visit("base_frame", self.base_frame, name, "Of the robot, on the floor under the camera.");
    visit("camera_frame", self.camera_frame, name, "Of the camera, x ahead, z up.");
    planning::RobotModel::describe(
        self.robot.model,
        [&visit](const char* limit, auto& value, const Range& range, const auto&... unit_and_help) {
          visit(limit, value, range.atStart(), unit_and_help...);
        });
    visit("latency", self.robot.latency, Range{0.0, 2.0}.atStart(), "s",
          "How long it takes until the base follows a command.");
    visit("radius", self.robot.radius, Range{0.01, 5.0}.atStart(), "m", "Of the robot, for bumps.");
    visit("command_timeout", self.robot.command_timeout, Range{0.01, 100.0}.atStart(), "s",
          "How long a command holds.");
    visit("optical_frame", self.optical_frame, name, "Of its images, x right, z ahead.");
  }

  bool isDriven() const { return trajectory == kDriven; }

  std::optional<parameters::ParameterFault> conflict() const
  {
    return parameters::findDisorder("min_height", min_height, "max_height", max_height);
  }

  /// What a camera's topics and frames are called.
  struct CameraNames
  {
    std::string topics;  ///< their namespace
    std::string body_frame;
    std::string optical_frame;
    std::string truth;  ///< namespace of the truth about its frames
  };
  std::vector<CameraNames> cameraNames() const
  {
    if (cameras.empty()) return {{camera, camera_frame, optical_frame, "ground_truth"}};
    std::vector<CameraNames> names;
    for (const std::string& name : cameras)
      names.push_back({name, name + "_link", name + "_depth_optical_frame", "ground_truth/" + name});
    return names;
  }

  /// @param number  of the camera
  simulation::SimulatedCamera::Options options(std::uint32_t number) const
  {
    simulation::SimulatedCamera::Options options;
    options.scene = scene;
    options.trajectory = isDriven() ? "robotino" : trajectory;
    options.seed = static_cast<std::uint64_t>(seed);
    options.rate = rate;
    options.number = number;
    options.count = static_cast<std::uint32_t>(std::max<std::size_t>(1, cameras.size()));
    options.camera = simulation::PinholeCamera::ofSize(static_cast<std::uint32_t>(width),
                                                       static_cast<std::uint32_t>(height));
    options.noise = has_noise ? noise : simulation::DepthNoise::Parameters::none();
    return options;
  }
};

}  // namespace polygonal_perception::simulation_ros
