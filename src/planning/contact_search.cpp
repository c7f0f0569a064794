#include "polygonal_perception/planning/contact_search.hpp"

#include <algorithm>
#include <cmath>

#include "polygonal_perception/geometry/angle.hpp"
#include "polygonal_perception/geometry/distance.hpp"
#include "polygonal_perception/planning/arc_contact.hpp"

namespace polygonal_perception::planning {

namespace {

// Of a piece: short, so that its box is small, and turning little, so that the box is near to it.
constexpr double kPieceLength = 0.5;                // [m]
constexpr double kPieceTurn = geometry::kPi / 4.0;  // [rad]

// A long way is cut into no more pieces than this: it takes the time of these, whatever a base can do.
constexpr double kMostPieces = 64.0;

/// Bounds as floats, which are faster to compare: rounded outward.
float below(double value)
{
  return static_cast<float>(value - 1e-6 * std::abs(value));
}
float above(double value)
{
  return static_cast<float>(value + 1e-6 * std::abs(value));
}

Eigen::Vector2d endOf(const MovingEdge& edge)
{
  return edge.from + edge.length * edge.along;
}

}  // namespace

void ContactSearch::setEdges(const std::vector<MovingEdge>& edges, const Eigen::Vector2d& place, double reach,
                             double horizon)
{
  place_ = place;
  edges_.clear();
  for (const MovingEdge& edge : edges) {
    const Eigen::Vector2d nearest = geometry::nearestOnSegment(place, edge.from, endOf(edge));
    const double away = (nearest - place).norm();
    // As long as it grows an edge gets longer, too.
    const double motion = horizon * (edge.velocity.norm() + 2.0 * edge.growth);
    const double distance = std::max(0.0, away - motion - kEdgeOverlap);
    if (distance > reach) continue;
    const double depth = depthBehind(edge, place, 0.0);
    const bool is_at_border = depth > 0.0 && away <= kAtBorder;
    edges_.push_back({edge, is_at_border ? depth : 0.0, distance});
  }
  std::sort(edges_.begin(), edges_.end(),
            [](const Reachable& a, const Reachable& b) { return a.distance < b.distance; });

  for (auto* bounds : {&low_x_, &low_y_, &high_x_, &high_y_}) bounds->resize(edges_.size());
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const MovingEdge& edge = edges_[i].edge;
    const Eigen::Vector2d way = horizon * edge.velocity;
    Eigen::AlignedBox2d box(edge.from);
    box.extend(endOf(edge)).extend(edge.from + way).extend(endOf(edge) + way);
    const double margin = 2.0 * edge.growth * horizon + edges_[i].level + kEdgeOverlap + kTouch;
    low_x_[i] = below(box.min().x() - place.x() - margin);
    low_y_[i] = below(box.min().y() - place.y() - margin);
    high_x_[i] = above(box.max().x() - place.x() + margin);
    high_y_[i] = above(box.max().y() - place.y() + margin);
  }
}

bool ContactSearch::Piece::mayEnter(const Reachable& reachable) const
{
  const MovingEdge& edge = reachable.edge;
  const Eigen::Vector2d at_from = begin - edge.from - from * edge.velocity;
  const Eigen::Vector2d at_to = end - edge.from - to * edge.velocity;
  const double grown = edge.growth * to;
  const Eigen::Vector2d normal = edge.normal();
  if (std::max(normal.dot(at_from), normal.dot(at_to)) + bulge + grown <= reachable.level) return false;
  const double first = edge.along.dot(at_from);
  const double last = edge.along.dot(at_to);
  const double margin = bulge + grown + kEdgeOverlap;
  return std::max(first, last) >= -margin && std::min(first, last) <= edge.length + margin;
}

std::optional<double> ContactSearch::firstContact(const Arc& arc, double until) const
{
  const double duration = until - arc.begin();
  const double wanted =
      std::max(arc.speed() * duration / kPieceLength, std::abs(arc.turnRate()) * duration / kPieceTurn);
  const double pieces = std::clamp(std::ceil(wanted), 1.0, kMostPieces);
  const double step = duration / pieces;
  const double offset = (arc.start().position - place_).norm();
  Piece piece;
  // A point is beside the place where it would be on the chord at that time by its acceleration's share.
  piece.bulge = arc.speed() * std::abs(arc.turnRate()) * step * step / 8.0;
  piece.to = arc.begin();
  piece.end = arc.start().position;
  std::size_t count = 0;
  for (double k = 1.0; k <= pieces; ++k) {
    piece.from = piece.to;
    piece.begin = piece.end;
    piece.to = k < pieces ? arc.begin() + k * step : until;
    piece.end = arc.position(piece.to);
    const double reach = offset + arc.speed() * (piece.to - arc.begin());
    while (count < edges_.size() && edges_[count].distance <= reach) ++count;
    if (const auto time = firstContact(arc, piece, count)) return time;
  }
  return std::nullopt;
}

std::optional<double> ContactSearch::firstContact(const Arc& arc, const Piece& piece, std::size_t count) const
{
  const Eigen::Vector2d low = piece.begin.cwiseMin(piece.end).array() - piece.bulge;
  const Eigen::Vector2d high = piece.begin.cwiseMax(piece.end).array() + piece.bulge;
  const Eigen::Vector2f from_place(below(low.x() - place_.x()), below(low.y() - place_.y()));
  const Eigen::Vector2f to_place(above(high.x() - place_.x()), above(high.y() - place_.y()));
  std::optional<double> first;
  double to = piece.to;
  for (std::size_t i = 0; i < count; ++i) {
    const bool meets = (low_x_[i] <= to_place.x()) & (high_x_[i] >= from_place.x()) &
                       (low_y_[i] <= to_place.y()) & (high_y_[i] >= from_place.y());
    if (!meets || !piece.mayEnter(edges_[i])) continue;
    const auto time = planning::firstContact(arc, edges_[i].edge, piece.from, to, edges_[i].level);
    if (!time) continue;
    first = time;
    to = *time;
  }
  return first;
}

}  // namespace polygonal_perception::planning
