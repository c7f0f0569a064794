#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "perception/floor/floor_selection.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::test {

using perception::ExtractedPlane;
using perception::FloorCandidate;
using perception::FloorPrior;
using perception::FloorSelection;
using perception::FloorSelectionParameters;
using perception::PlaneExtraction;
using perception::PlaneExtractionParameters;
using perception::PlaneOffsets;
using perception::SampleGrid;

constexpr double kDegree = 0.017453292519943295;

inline const geometry::Plane kFloor = floorSeenFrom(1.0, 0.7);
inline const Eigen::Vector3d kAhead(0.0, kFloor.normal.z(), -kFloor.normal.y());  // along the floor

inline double ahead(const Eigen::Vector3d& point)
{
  return kAhead.dot(point);
}

inline bool isLeft(const Eigen::Vector3d& point)
{
  return point.x() < 0.0;
}

inline bool isRight(const Eigen::Vector3d& point)
{
  return point.x() >= 0.0;
}

/// Only the number of samples counts: a test adds the term that it is about.
inline FloorSelectionParameters onlySupport()
{
  FloorSelectionParameters parameters;
  parameters.tilt_about_seed = parameters.tilt_about_measured = 1e6;
  parameters.scatter = parameters.distance = 0.0;
  parameters.confirmed = parameters.other_plane = parameters.step = 0.0;
  parameters.lower_plane_weight = parameters.nearer = 0.0;
  parameters.least_score = -1e6;
  return parameters;
}

/// Planes of a drawn scene, rated.
class Selection : public testing::Test
{
protected:
  Selection() { prior_.up = kFloor.normal; }

  void rate()
  {
    grid_.update(scene_.view());
    extraction_.extract(grid_, PlaneExtractionParameters{}, {});
    selection_.rate(extraction_, parameters_, prior_);
  }

  /// The distance of the floor; 0: there is none.
  double best()
  {
    rate();
    return bestOfRated();
  }
  double bestOfRated()
  {
    const FloorCandidate* candidate = selection_.best(parameters_);
    return candidate == nullptr ? 0.0 : candidate->fit.plane.distance;
  }

  /// The candidate at that distance.
  const FloorCandidate& at(double distance) const
  {
    const auto& candidates = selection_.candidates();
    const auto nearest =
        std::min_element(candidates.begin(), candidates.end(), [&](const auto& a, const auto& b) {
          return std::abs(a.fit.plane.distance - distance) < std::abs(b.fit.plane.distance - distance);
        });
    if (nearest == candidates.end() || std::abs(nearest->fit.plane.distance - distance) > 0.02) {
      ADD_FAILURE() << "no candidate at " << distance << " m";
      static const FloorCandidate kNone;
      return kNone;
    }
    return *nearest;
  }

  /// The score of the plane at that distance, beyond the number of its samples.
  double termOf(double distance) const
  {
    const FloorCandidate& candidate = at(distance);
    return candidate.score - std::log(static_cast<double>(candidate.size));
  }

  PlaneScene scene_;
  SampleGrid grid_{SampleGrid::Parameters{}};
  PlaneExtraction extraction_;
  FloorSelectionParameters parameters_ = onlySupport();
  FloorPrior prior_;
  FloorSelection selection_;
};

}  // namespace polygonal_perception::test
