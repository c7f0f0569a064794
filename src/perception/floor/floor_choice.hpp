#pragma once

#include <Eigen/Core>
#include <vector>

#include "perception/floor/noisy_points.hpp"
#include "polygonal_perception/perception/floor/floor_detector.hpp"

namespace polygonal_perception::perception {

/// The angle between two vectors of any length [rad].
double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// A level plane of the frame.
struct FloorCandidate
{
  geometry::Plane plane;
  NoisyPoints::InlierCount counts;   // of the samples
  double ground_range = 0.0;         // [m] from the camera to the middle of its samples, along the plane
  double tilt = 0.0;                 // [rad] from the up vector
  double disagreement = 0.0;         // [rad] between its normal and the mean of its samples' normals
  bool lowest = false;               // hardly a sample lies below it
  bool continues = false;            // it is where the last floor was
  bool matches_other_plane = false;  // it is where another plane was seen with the last floor
  bool is_stair_top = false;         // it is the top of a staircase, whose steps lie below it
  bool refused = false;              // it is a step, or a closer look found that it is no floor
};

/// Takes no step of a staircase that leads down for the floor. A step may lie at a height that the camera can
/// have, but the next one below it, by the same rise, does not, and the next one above it is a plane too.
/// Each lower one lies farther away: what a shiny floor mirrors of something low that stands on it does not.
/// @param candidates  steps among them are refused, and what they lead down from is marked
/// @param too_low     the level planes of the frame that lie lower than the camera can stand on; steps are
///                    added
void rejectStairSteps(std::vector<FloorCandidate>& candidates, std::vector<FloorCandidate>& too_low);

/// The most likely floor among the candidates that are not refused, or nullptr.
/// @param lowest_possible  [m] a floor that lies deeper under the camera may have points below it
FloorCandidate* mostLikelyFloor(std::vector<FloorCandidate>& candidates, const FloorPrior& prior,
                                double lowest_possible);

}  // namespace polygonal_perception::perception
