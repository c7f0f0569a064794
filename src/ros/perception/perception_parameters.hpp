#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/parameters/frame_box.hpp"
#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/perception/pipeline.hpp"
#include "polygonal_perception/ros/common/text_rules.hpp"

namespace polygonal_perception::ros_perception {

inline bool isInputKind(const std::string& text)
{
  return text == "cloud" || text == "depth";
}
inline bool isTransport(const std::string& text)
{
  return !text.empty() && text.find('/') == std::string::npos;
}
inline bool isSensorNoise(const std::string& text)
{
  return perception::SensorNoise::preset(text).has_value();
}

/// Every parameter of the node: those that only the ROS side knows, and the pipeline's.
struct PerceptionParameters
{
  std::string input = "cloud";
  std::string image_transport = "raw";
  double depth_unit = 0.001;  ///< [m]
  std::string floor_frame = "floor";
  std::string output_frame;
  bool publish_tf = true;
  bool lazy = true;
  std::string up_frame;
  std::string mount_frame;
  std::vector<parameters::FrameBox> ignore_boxes;
  double tf_timeout = 0.1;  ///< [s]
  std::string sensor_noise = "xtion";
  perception::Pipeline::Parameters pipeline;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    using parameters::Range;
    using parameters::TextRule;
    visit("input", self.input, TextRule{"cloud, depth", isInputKind},
          "What the camera's driver sends: a PointCloud2 or a depth image.");
    visit(
        "image_transport", self.image_transport, TextRule{"a transport", isTransport},
        "How the depth image comes: raw, compressedDepth or another for which image_transport has a plugin.");
    visit("depth_unit", self.depth_unit, Range{1e-5, 0.1}, "m",
          "What a number in a 16UC1 depth image means.");
    visit("floor_frame", self.floor_frame, ros_common::kFrame,
          "Child frame of the input's: on the floor under the camera, x ahead, z up. Each camera needs its "
          "own.");
    visit("output_frame", self.output_frame, ros_common::kFrameOrEmpty,
          "Frame of grids and polygons; empty: the floor frame. x, y and yaw come from tf, the rest from the "
          "floor.");
    visit("publish_tf", self.publish_tf, "Whether to broadcast the floor frame.");
    visit("lazy", self.lazy, "Work only while an output topic has a reader.");
    visit("initial_up", self.pipeline.tracker.initial_up,
          "Where up is when nothing better is known, in the input's frame.");
    perception::ViewAxesParameters::describe(self.pipeline.view, visit);
    visit("up_frame", self.up_frame, ros_common::kFrameOrEmpty,
          "A frame whose z axis is up, looked up at the start and whenever the floor is lost; empty: "
          "initial_up.");
    visit("mount_frame", self.mount_frame, ros_common::kFrameOrEmpty,
          "A frame whose z = 0 is the floor where the robot stands (base_footprint): the floor is sought "
          "there, and "
          "ASSUMED where none is in view; empty: nobody knows.");
    visit("up_feedback", self.pipeline.tracker.up_feedback,
          "The floor's normal is the next frame's up vector; false: up_frame or initial_up in every frame.");
    visit("ignore_boxes", self.ignore_boxes,
          "Boxes along the axes of a frame [m] that hold the robot's own parts: what is seen in them is no "
          "point.");
    visit("tf_timeout", self.tf_timeout, Range{0.0, 1.0}.atStart(), "s",
          "How long a frame waits for its transforms and its camera_info; others are not held up.");
    visit("sensor_noise", self.sensor_noise, TextRule{perception::SensorNoise::kPresets, isSensorNoise},
          "The kind of sensor, which gives noise_constant, noise_linear and noise_quadratic where they are "
          "not set.");
    perception::Pipeline::Parameters::describe(self.pipeline, visit);
  }

  /// Takes what nobody has set of the noise from the kind of sensor.
  /// @param is_set  says whether a parameter of that name is
  void complete(const std::function<bool(const char*)>& is_set)
  {
    perception::SensorNoise preset = *perception::SensorNoise::preset(sensor_noise);
    perception::SensorNoise& noise = pipeline.detector.planes.noise;
    if (!is_set("noise_constant")) noise.constant = preset.constant;
    if (!is_set("noise_linear")) noise.linear = preset.linear;
    if (!is_set("noise_quadratic")) noise.quadratic = preset.quadratic;
  }

  /// What algorithm 2 of the paper calls tau_h and its factor were read under these names, but meant other things.
  static std::vector<parameters::RetiredName> retired()
  {
    return {{"merge_distance", "inlier_distance"}, {"replacement_factor", "lower_plane_weight"}};
  }

  std::optional<parameters::ParameterFault> conflict() const { return pipeline.conflict(); }

  /// Whether any parameter names a frame that tf must know.
  bool needsTf() const
  {
    return !mount_frame.empty() || !up_frame.empty() || !ignore_boxes.empty() || hasOutputFrame();
  }

  /// Whether grids and polygons lie in another frame than the floor's own.
  bool hasOutputFrame() const { return !output_frame.empty() && output_frame != floor_frame; }
};

}  // namespace polygonal_perception::ros_perception
