#include "geometry/ring_sweep.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::geometry {

RingSweep::RingSweep(const PolygonSet& polygons, std::size_t first, std::size_t last)
    : first_ring_(static_cast<std::uint32_t>(first)), crossed_(Below{*this})
{
  const std::size_t rings = last - first;
  begin_.push_back(0);
  for (std::size_t r = 0; r < rings; ++r) {
    const RingView ring = polygons.view(polygons.rings[first + r]);
    vertices_.insert(vertices_.end(), ring.begin(), ring.end());
    ring_of_.insert(ring_of_.end(), ring.size(), static_cast<std::uint32_t>(r));
    begin_.push_back(static_cast<std::uint32_t>(vertices_.size()));
  }
  order_.resize(vertices_.size());
  std::iota(order_.begin(), order_.end(), 0U);
  std::sort(order_.begin(), order_.end(),
            [this](std::uint32_t a, std::uint32_t b) { return isBefore(a, b); });
  around_.assign(rings, kNone);
  is_known_.assign(rings, false);
  runs_left_.assign(rings, false);
  places_.assign(vertices_.size(), crossed_.end());
}

std::uint32_t RingSweep::next(std::uint32_t vertex) const
{
  const std::uint32_t ring = ring_of_[vertex];
  return vertex + 1 == begin_[ring + 1] ? begin_[ring] : vertex + 1;
}

std::uint32_t RingSweep::previous(std::uint32_t vertex) const
{
  const std::uint32_t ring = ring_of_[vertex];
  return (vertex == begin_[ring] ? begin_[ring + 1] : vertex) - 1;
}

bool RingSweep::isBefore(std::uint32_t a, std::uint32_t b) const
{
  const Eigen::Vector2d& p = vertices_[a];
  const Eigen::Vector2d& q = vertices_[b];
  return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
}

bool RingSweep::Below::operator()(std::uint32_t a, std::uint32_t b) const
{
  if (a == b) return false;
  const auto& vertices = sweep.vertices_;
  const auto sideOf = [&](std::uint32_t vertex, std::uint32_t edge) {
    return orientation(vertices[sweep.left(edge)], vertices[sweep.right(edge)], vertices[vertex]);
  };
  // Both are crossed where the later one begins: it lies above or below the other one there, or goes on so from it.
  const bool a_is_first = sweep.isBefore(sweep.left(a), sweep.left(b));
  const std::uint32_t earlier = a_is_first ? a : b;
  const std::uint32_t later = a_is_first ? b : a;
  Orientation side = sideOf(sweep.left(later), earlier);
  if (side == Orientation::kCollinear) side = sideOf(sweep.right(later), earlier);
  return side == (a_is_first ? Orientation::kCounterClockwise : Orientation::kClockwise);
}

RingSweep::Contact RingSweep::contact(std::uint32_t a, std::uint32_t b) const
{
  const auto placed = [this](std::uint32_t edge) {
    return PlacedEdge{{vertices_[edge], vertices_[next(edge)]}, first_ring_ + ring_of_[edge]};
  };
  return {placed(std::min(a, b)), placed(std::max(a, b))};
}

std::optional<RingSweep::Contact> RingSweep::contactOf(std::uint32_t a, std::uint32_t b) const
{
  const SegmentContact in_common =
      segmentContact(vertices_[a], vertices_[next(a)], vertices_[b], vertices_[next(b)]);
  const bool follow = next(a) == b || next(b) == a;
  const bool meet = follow ? in_common == SegmentContact::kOverlap : in_common != SegmentContact::kNone;
  return meet ? std::optional(contact(a, b)) : std::nullopt;
}

std::optional<RingSweep::Contact> RingSweep::run()
{
  for (std::size_t k = 0; k < order_.size(); ++k) {
    if (k + 1 < order_.size() && !isBefore(order_[k], order_[k + 1])) {
      // Two vertices in one place, which do not follow one another.
      return contact(order_[k], order_[k + 1]);
    }
    if (auto found = pass(order_[k])) return found;
  }
  return std::nullopt;
}

std::optional<RingSweep::Contact> RingSweep::pass(std::uint32_t vertex)
{
  const std::uint32_t edges[] = {previous(vertex), vertex};
  for (const std::uint32_t edge : edges) {
    if (right(edge) != vertex) continue;
    if (auto found = leave(edge)) return found;
  }
  for (const std::uint32_t edge : edges) {
    if (left(edge) != vertex) continue;
    if (auto found = enter(edge)) return found;
  }
  if (!is_known_[ring_of_[vertex]]) noteRing(vertex);
  return std::nullopt;
}

std::optional<RingSweep::Contact> RingSweep::leave(std::uint32_t edge)
{
  const auto after = crossed_.erase(places_[edge]);
  if (after == crossed_.begin() || after == crossed_.end()) return std::nullopt;
  return contactOf(*std::prev(after), *after);
}

std::optional<RingSweep::Contact> RingSweep::enter(std::uint32_t edge)
{
  const auto [place, is_new] = crossed_.insert(edge);
  if (!is_new) return contact(edge, *place);  // they lie on one another
  places_[edge] = place;
  if (place != crossed_.begin()) {
    if (auto found = contactOf(*std::prev(place), edge)) return found;
  }
  const auto after = std::next(place);
  return after == crossed_.end() ? std::nullopt : contactOf(*after, edge);
}

/// The first vertex of a ring from the left, where both of its edges begin.
void RingSweep::noteRing(std::uint32_t vertex)
{
  const std::uint32_t ring = ring_of_[vertex];
  const auto one = places_[previous(vertex)];
  const auto other = places_[vertex];
  const auto lower = std::next(one) == other ? one : other;
  is_known_[ring] = true;
  runs_left_[ring] = lower == one;
  if (lower == crossed_.begin()) return;
  // What lies below encloses it, or lies beside it in the same ring.
  const std::uint32_t below = *std::prev(lower);
  const std::uint32_t beside = ring_of_[below];
  const bool edge_runs_left = right(below) == below;
  around_[ring] = edge_runs_left == runs_left_[beside] ? beside : around_[beside];
}

}  // namespace polygonal_perception::geometry
