#pragma once

#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <polygonal_perception/DriveStatus.h>
#include <polygonal_perception/PolygonArray.h>
#include <polygonal_perception/TrackedPolygonArray.h>

#include <deque>
#include <string>

#include "polygonal_perception/planning/dynamic_window.hpp"
#include "ros/driving/drive_inputs.hpp"
#include "ros/driving/dynamic_window_parameters.hpp"

namespace polygonal_perception::ros_driving {

/// A command, and why it is as it is.
struct DriveReport
{
  std_msgs::Header header;  ///< time of the command, frame of the odometry
  planning::Twist command;
  std::uint8_t status = DriveStatus::STALE;
  std::string message;
  double time_to_collision = 0.0;  ///< [s]
  bool is_refusal = false;         ///< it stops because a message cannot be used
};

/// Keeps the newest of each input and makes a command of them at each tick.
class Driver
{
public:
  explicit Driver(const DynamicWindowParameters& parameters) { configure(parameters); }

  void configure(const DynamicWindowParameters& parameters);
  void setPolygons(const PolygonArrayConstPtr& polygons) { polygons_ = polygons; }
  void setTracked(const TrackedPolygonArrayConstPtr& tracked) { tracked_ = tracked; }
  void setPath(const nav_msgs::PathConstPtr& path) { path_ = path; }
  void setOdometry(const nav_msgs::OdometryConstPtr& odometry) { odometry_ = odometry; }

  /// @param now  from which the command is to hold, as far as latency lets it
  DriveReport tick(const ros::Time& now);
  /// Of the last tick, for pictures: the velocities that are admissible, and the one that was chosen.
  const planning::DynamicWindow& window() const { return window_; }
  /// Time has jumped back: forgets everything.
  void reset();

private:
  struct Sent
  {
    double effect = 0.0;  // [s] from which it holds: sums of ros::Time throw at the end of their range
    planning::Twist twist;
  };

  DriveReport drive(const ros::Time& now);
  /// Why it cannot drive now; empty where it can.
  std::string stale(const ros::Time& now) const;
  bool isOld(const ros::Time& stamp, const ros::Time& now) const;
  /// The robot at a later time, under the commands that were sent.
  planning::RobotState predicted(planning::RobotState state, double time, double end) const;
  double period() const { return 1.0 / parameters_.control_frequency; }
  /// The same where the message says what is wrong with an input.
  DriveReport refusing(const ros::Time& now, std::uint8_t status, const std::string& message) const;
  DriveReport stopping(const ros::Time& now, std::uint8_t status, const std::string& message) const;

  DynamicWindowParameters parameters_;
  planning::DynamicWindow window_;
  DriveInputs inputs_;
  PolygonArrayConstPtr polygons_;
  TrackedPolygonArrayConstPtr tracked_;
  nav_msgs::PathConstPtr path_;
  nav_msgs::OdometryConstPtr odometry_;
  std::deque<Sent> sent_;
};

}  // namespace polygonal_perception::ros_driving
