#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/planning/arc.hpp"
#include "polygonal_perception/planning/moving_edges.hpp"

namespace polygonal_perception::planning {

/// The first contacts of many arcs that begin near one place, among many edges. An arc is followed piece by piece; a piece is
/// held exactly (arc_contact.hpp) against the edges that are near enough to be reached so soon, and whose box it meets.
class POLYGONAL_PERCEPTION_EXPORT ContactSearch
{
public:
  /// [m] As far as a robot may stand in an obstacle and still be taken to stand at its border: it must not get deeper.
  static constexpr double kAtBorder = 1e-3;

  /// Takes in edges. Memory is used again.
  ///
  /// @param place    [m] near which all arcs begin, the robot's
  /// @param reach    [m] as far from it as arcs go; edges that stay farther away are left out
  /// @param horizon  [s] as long as edges move
  void setEdges(const std::vector<MovingEdge>& edges, const Eigen::Vector2d& place, double reach,
                double horizon);

  /// Whether no edge can be reached.
  bool isEmpty() const { return edges_.empty(); }

  /// @param until  [s] <= the horizon, after the arc's beginning
  /// @return [s] when the arc first enters an obstacle, if it does by then
  std::optional<double> firstContact(const Arc& arc, double until) const;

private:
  /// An edge that can be reached.
  struct Reachable
  {
    MovingEdge edge;
    double level = 0.0;     // [m] behind its line where the place is at its border
    double distance = 0.0;  // [m] from the place, when it is nearest
  };

  /// A short part of an arc.
  struct Piece
  {
    double from = 0.0;      // [s]
    double to = 0.0;        // [s]
    Eigen::Vector2d begin;  // [m] where it is then
    Eigen::Vector2d end;    // [m]
    double bulge = 0.0;     // [m] between the arc and its chord, at the same time

    /// Whether its chord comes near enough to an edge.
    bool mayEnter(const Reachable& reachable) const;
  };

  std::optional<double> firstContact(const Arc& arc, const Piece& piece, std::size_t count) const;

  Eigen::Vector2d place_ = Eigen::Vector2d::Zero();
  std::vector<Reachable> edges_;  // the nearest first
  // The boxes of the same, with all their motion.
  std::vector<float> low_x_, low_y_, high_x_, high_y_;
};

}  // namespace polygonal_perception::planning
