#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "polygonal_perception/cameras/simulation/pinhole_camera.hpp"
#include "polygonal_perception/cameras/simulation/scene.hpp"
#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"

namespace polygonal_perception::test {

using Ring = std::vector<Eigen::Vector2d>;  // [m]

/// How the polygons around something that stands still differ from frame to frame [m].
struct Spread
{
  std::size_t frames = 0;
  double standard_deviation = 0.0;  ///< of the centroids
  double greatest = 0.0;            ///< distance of a centroid from their mean
  double bias = 0.0;                ///< of their mean from the true centre
};

/// The leg of a table that stands alone, and the polygons that were found around it.
class TrackedLeg
{
public:
  explicit TrackedLeg(const Eigen::Vector2d& centre) : centre_(centre) {}

  const Eigen::Vector2d& centre() const { return centre_; }
  /// Whether its foot is well within the image, and near enough to show.
  bool isInView(const simulation::SimulatedFrame& frame, const simulation::PinholeCamera& camera) const;
  /// @param boundary  of the polygon that the centre lies in
  void add(const Ring& boundary);
  Spread spread() const;

private:
  Eigen::Vector2d centre_;
  std::vector<Eigen::Vector2d> centroids_;
};

/// The legs in a scene that are so far from all else that their inflated polygons hold nothing else.
/// @param min_height, max_height  [m] that count as obstacles
/// @param clearance               [m] that nothing else comes nearer than
std::vector<TrackedLeg> findLegs(const simulation::Scene& scene, double min_height, double max_height,
                                 double clearance);

}  // namespace polygonal_perception::test
