#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/perception/pipeline.hpp"

namespace polygonal_perception::ros_perception {

/// What a text parameter may be.
struct TextRule
{
  const char* accepted;
  bool (*accepts)(const std::string& text);
};

bool isInputKind(const std::string& text);
bool isFrame(const std::string& text);
bool isFrameOrEmpty(const std::string& text);

/// Every parameter of the node: those that only the ROS side knows, and the pipeline's.
struct NodeParameters
{
  std::string input = "cloud";
  std::string floor_frame = "floor";
  std::string output_frame;
  bool publish_tf = true;
  bool lazy = true;
  std::string up_frame;
  double tf_timeout = 0.1;  ///< [s]
  perception::Pipeline::Parameters pipeline;

  /// Visits the parameters that only the ROS side knows, as parameter_table.hpp says, and those of the
  /// pipeline that are no numbers. Texts come with a TextRule in the place of the range, booleans and vectors
  /// with neither range nor unit.
  template <class Self, class Visitor>
  static void describeFixed(Self& self, Visitor&& visit)
  {
    visit("input", self.input, TextRule{"cloud, depth", isInputKind},
          "What the camera's driver sends: a PointCloud2 or a depth image.");
    visit("floor_frame", self.floor_frame, TextRule{"a frame", isFrame},
          "Child frame of the input's: on the floor under the camera, x ahead, z up.");
    visit("output_frame", self.output_frame, TextRule{"a frame or empty", isFrameOrEmpty},
          "Frame of grids and polygons; empty: the floor frame. x, y and yaw come from tf, the rest from the "
          "floor.");
    visit("publish_tf", self.publish_tf, "Whether to broadcast the floor frame.");
    visit("lazy", self.lazy, "Work only while an output topic has a reader.");
    visit("initial_up", self.pipeline.tracker.initial_up,
          "Where up is when nothing better is known, in the input's frame.");
    visit("up_frame", self.up_frame, TextRule{"a frame or empty", isFrameOrEmpty},
          "A frame whose z axis is up, looked up at the start and whenever the floor is lost; empty: "
          "initial_up.");
    visit("up_feedback", self.pipeline.tracker.up_feedback,
          "The floor's normal is the next frame's up vector; false: up_frame or initial_up in every frame.");
    visit("tf_timeout", self.tf_timeout, parameters::Range{0.0, 1.0}, "s",
          "How long a frame waits for its transforms and its camera_info; others are not held up.");
  }

  /// All of them, the numbers of the pipeline's stages last.
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    describeFixed(self, visit);
    perception::Pipeline::Parameters::describe(self.pipeline, visit);
  }
};

/// Reads the parameters from the node's private namespace.
///
/// @param errors    a text a parameter that is refused, with its name, its value and what is accepted; its
/// default stays
/// @param warnings  names in the namespace that are no parameter of this node: slips of the pen
NodeParameters readNodeParameters(const ros::NodeHandle& private_handle, std::vector<std::string>& errors,
                                  std::vector<std::string>& warnings);

/// Writes the numbers of the pipeline's stages to the parameter server, so that `rosparam get` shows what is
/// in force.
void writePipelineParameters(const ros::NodeHandle& private_handle,
                             const perception::Pipeline::Parameters& parameters);

/// The table of all parameters in Markdown: name, default, range, unit, meaning. The README's must be this
/// one.
POLYGONAL_PERCEPTION_EXPORT std::string parameterTable();

}  // namespace polygonal_perception::ros_perception
