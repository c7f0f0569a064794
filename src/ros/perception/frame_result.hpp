#pragma once

#include <std_msgs/Header.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "polygonal_perception/perception/input/point_view.hpp"
#include "polygonal_perception/perception/pipeline.hpp"

namespace polygonal_perception::ros_perception {

/// Where the floor frame lies in the output frame.
struct OutputPose
{
  std::string frame;
  Eigen::Isometry2d pose = Eigen::Isometry2d::Identity();
};

/// A frame with everything that its messages are made of. What it refers to must stay while messages are
/// made.
struct FrameResult
{
  const std_msgs::Header& input;
  const perception::PointView& points;
  const perception::Pipeline::Result& result;
  const perception::Pipeline::Parameters& parameters;  ///< that the frame was looked at with
  const std::string& floor_frame;
  /// Nothing: unknown, and what lies in the output frame is left out.
  std::optional<OutputPose> output;

  bool hasFloor() const { return result.floor.status != perception::FloorStatus::kNotFound; }
  /// Stamp of the input, in the output frame. @pre output
  std_msgs::Header outputHeader() const { return headerIn(output->frame); }
  /// Stamp of the input, in the floor frame.
  std_msgs::Header floorHeader() const { return headerIn(floor_frame); }

private:
  std_msgs::Header headerIn(const std::string& frame) const
  {
    std_msgs::Header header;
    header.seq = input.seq;
    header.stamp = input.stamp;
    header.frame_id = frame;
    return header;
  }
};

}  // namespace polygonal_perception::ros_perception
