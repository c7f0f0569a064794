#pragma once

#include <optional>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/planning/arc.hpp"
#include "polygonal_perception/planning/moving_edges.hpp"

namespace polygonal_perception::planning {

/// [m] How far a point is beyond an edge's line, on the obstacle's side.
POLYGONAL_PERCEPTION_EXPORT double depthBehind(const MovingEdge& edge, const Eigen::Vector2d& point,
                                               double time);

/// [m] By which an edge is taken to be longer, so that no point slips through between two of them: where an arc grazes an
/// edge, the place of the contact has half of a double's digits.
constexpr double kEdgeOverlap = 1e-6;

/// [m] As deep a point may get in an obstacle by rounding: who drives along a border does not enter.
constexpr double kTouch = 1e-9;

/// When a point on an arc first enters an obstacle through an edge. Its depth behind the edge's line is
///
///     d(t) = n . (p(t) - a) - (n . u - g) t,
///
/// whose derivative is 0 where the cosine of the angle between the motion and n is (n . u - g) / v. Between two such times d
/// is monotone, so that it has at most one root there, which is bracketed and found by Newton's method with bisection, to
/// the last digits. A root counts where d grows and the point lies on the edge. To touch is no contact: the
/// depth has to exceed kTouch.
///
/// Times are on one clock, on which edges are where they are said to be at 0.
///
/// @param from   [s] not before the arc begins
/// @param to     [s] >= from
/// @param level  [m] >= 0 up to which the point may be behind the line: where it stands already
/// @return [s] within [from, to]; nothing if it does not enter there
POLYGONAL_PERCEPTION_EXPORT std::optional<double> firstContact(const Arc& arc, const MovingEdge& edge,
                                                               double from, double to, double level = 0.0);

}  // namespace polygonal_perception::planning
