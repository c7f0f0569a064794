#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/perception/pipeline.hpp"

namespace polygonal_perception::reference {

/// What a frame of a course gave, beside the truth.
struct CourseFrame
{
  double x = 0.0;  ///< [m] the robot's place along the course
  perception::FloorStatus status = perception::FloorStatus::kNotFound;
  bool is_on_edge = false;   ///< the robot's wheels stand on two pieces of ground: there is no one floor
  double degrees = 0.0;      ///< error of the floor's normal; 0 with NOT_FOUND
  double millimetres = 0.0;  ///< error of its height
  int false_cells = 0;       ///< occupied, and no obstacle is seen there or beside it; within kNear ahead
  int false_far_cells = 0;   ///< the same farther off
  int obstacle_cells = 0;    ///< in which an obstacle is plainly seen, within kFar
  int missed_cells = 0;      ///< of them, neither occupied nor beside one that is
  static constexpr double kNear = 2.5;  ///< [m]
  static constexpr double kFar = 4.0;   ///< [m]

  /// The floor is more than a degree or 2 cm off.
  bool isOff() const { return !is_on_edge && (degrees > 1.0 || millimetres > 20.0); }
};

/// A robot that drives through a course in the simulated camera, with each frame held against the truth: where an
/// obstacle is, and ground, follows from what each pixel hit without noise. Ground is the floor, its ramps and what
/// they lead to, whatever `max_slope` is.
class CourseRun
{
public:
  struct Options
  {
    std::string course = "ramps";
    std::uint64_t seed = 1;
    double rate = 5.0;  ///< [Hz]
    perception::Pipeline::Parameters parameters;
    bool has_mount = false;  ///< tf says where the floor is, as the robot was at the start
  };

  explicit CourseRun(const Options& options);

  /// Of the frames there and back.
  static constexpr std::uint32_t kFrames = 900;

  /// The next frame. What it is made of lives until the one after.
  CourseFrame next();
  const simulation::SimulatedFrame& frame() const { return frame_; }
  const perception::Pipeline::Result& result() const { return pipeline_.result(); }
  const simulation::Scene& scene() const { return camera_.scene(); }
  const simulation::PinholeCamera& camera() const { return camera_.options().camera; }
  /// Whether no obstacle is seen in a cell of the frame or beside it.
  bool isFalse(int i, int j) const;

private:
  void rateFloor(CourseFrame& rating) const;
  void findObstacles();
  void rateCells(CourseFrame& rating) const;

  simulation::SimulatedCamera camera_;
  perception::PinholeRays rays_;
  perception::Pipeline pipeline_;
  perception::FloorHints hints_;
  simulation::SimulatedFrame frame_;
  std::vector<int>
      possible_;  // a cell: whether a point of an obstacle may be seen there, heights being what they are
  std::vector<int> plain_;  // and how many plainly are
  std::uint32_t index_ = 0;
};

}  // namespace polygonal_perception::reference
