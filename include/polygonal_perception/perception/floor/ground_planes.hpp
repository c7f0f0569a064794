#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/perception/floor/floor_detector.hpp"

namespace polygonal_perception::perception {

/// A plane on which a robot can drive, in the input's frame.
struct GroundPlane
{
  geometry::Plane plane;                 ///< up normal
  std::vector<Eigen::Vector3f> samples;  ///< [m] where it was seen
};

/// Ground is more than one plane: finds the planes that continue the floor, ramps and what they lead to.
///
/// A plane continues another one where the two meet in a line between their samples: a ramp rises from the floor in front
/// of it, and a crest falls from a ramp. Where one lies above the other on both sides of the border there is a step, a
/// kerb or a ledge.
class POLYGONAL_PERCEPTION_EXPORT GroundPlanes
{
public:
  struct Parameters
  {
    double max_slope = 0.0;  ///< [rad] against the floor; 0: the floor is all
    /// [m] In the mean over a border: half of what min_height calls an obstacle by default, so that no kerb is taken for a
    /// hinge, however noisy its samples are.
    double least_step = 0.015;
    /// Pairs of samples, at least: fewer are a corner that happens to touch.
    double least_pairs = 3.0;
    /// [m] A plane that passes the robot's foot so nearly meets the floor there: a robot's wheels stand on it.
    double meeting_height = 0.02;
    /// Samples of a pair lie no farther apart than this share of their range: what is behind an edge is elsewhere.
    double nearest_pair = 0.25;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      visit("max_slope", self.max_slope, parameters::Range{0.0, 0.6}, "rad",
            "Planes that continue the floor with at most this slope are ground, too: heights count from "
            "them. 0: a slope "
            "is an obstacle.");
    }
  };

  explicit GroundPlanes(const Parameters& parameters);
  GroundPlanes(GroundPlanes&& other) noexcept;
  GroundPlanes& operator=(GroundPlanes&& other) noexcept;
  ~GroundPlanes();

  /// Whether there can be more ground than the floor.
  bool isActive() const { return parameters_.max_slope > 0.0; }

  /// @param detector  after it has looked at the frame
  /// @param floor     the frame's floor
  /// @return the floor first, and then what continues it, valid until the next call
  const std::vector<GroundPlane>& find(const FloorDetector& detector, const geometry::Plane& floor);

private:
  struct Workspace;

  Parameters parameters_;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace polygonal_perception::perception
