#pragma once

#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/perception/pipeline.hpp"

namespace polygonal_perception::ros_perception {

/// Where the floor frame lies in the frame of the outputs.
struct OutputPlace
{
  std::string frame;
  Eigen::Isometry2d pose = Eigen::Isometry2d::Identity();
};

/// A frame with everything that its messages are made of.
struct Answer
{
  const std_msgs::Header& input;  ///< of the frame, which must stay
  perception::PointView points;
  perception::FloorState floor;
  std::optional<OutputPlace> place;  ///< nothing: unknown, and what lies in the output frame is left out
  /// How far the pipeline went; nothing: it could not look at the frame, and there is no floor. A reader who
  /// came in the meantime waits for the next frame.
  std::optional<perception::Pipeline::Goal> goal;
};

/// The output topics, which are made only for readers.
class Outputs
{
public:
  /// @param private_handle   where the topics are
  /// @param readers_changed  called from the handle's queue when a reader has come or gone
  Outputs(const ros::NodeHandle& private_handle, const std::function<void()>& readers_changed);
  ~Outputs();

  bool hasReaders() const;
  /// How far the pipeline has to go for those who read now.
  perception::Pipeline::Goal goal() const;

  /// Publishes what is read, every topic with the input's stamp. Grid, polygons and samples are the
  /// pipeline's last.
  void publish(const Answer& answer, perception::Pipeline& pipeline);

  /// Forgets the hull of a floor that is held.
  void reset() { hull_.clear(); }

  /// Ends all topics and waits for callbacks under way.
  void shutdown();

private:
  void publishInInputFrame(const Answer& answer, const perception::Pipeline& pipeline);
  void publishInOutputFrame(const Answer& answer, perception::Pipeline& pipeline);
  void publishMarkers(const Answer& answer, const perception::Pipeline& pipeline);

  ros::Publisher floor_;
  ros::Publisher floor_coefficients_;
  ros::Publisher occupancy_grid_;
  ros::Publisher inflated_grid_;
  ros::Publisher polygons_;
  ros::Publisher markers_;
  ros::Publisher obstacle_points_;
  image_transport::Publisher samples_;
  std::vector<Eigen::Vector3f> hull_;      // of the floor that was found last
  std::vector<Eigen::Vector3f> standing_;  // kept to allocate only once
};

}  // namespace polygonal_perception::ros_perception
