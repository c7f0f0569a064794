#include "reference/polygon_checker.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace polygonal_perception::reference {

namespace {

constexpr std::int64_t kCell = 64;  // lattice units

// Squares of areas outgrow 64 bits; GCC and Clang have this type on every 64-bit machine.
__extension__ using Wide = __int128;

std::int64_t square(std::int64_t value)
{
  return value * value;
}

/// How far `value` lies outside of [low, low + kCell].
std::int64_t gap(std::int64_t value, std::int64_t low)
{
  return std::max<std::int64_t>({0, low - value, value - low - kCell});
}

std::string at(std::int64_t x, std::int64_t y)
{
  std::ostringstream text;
  text << "(" << static_cast<double>(x) / kCell << ", " << static_cast<double>(y) / kCell << ")";
  return text.str();
}

}  // namespace

PolygonChecker::PolygonChecker(const occupancy::BinaryGrid& occupancy, const geometry::PolygonSet& polygons,
                               CellLength radius, CellLength limit)
    : grid_(occupancy),
      radius_(radius),
      limit_(limit),
      width_(kCell * occupancy.cellsX()),
      height_(kCell * occupancy.cellsY())
{
  const occupancy::GridGeometry& geometry = occupancy.geometry();
  for (const geometry::PolygonSet::Ring& ring : polygons.rings) {
    Ring points;
    for (std::uint32_t k = ring.first; k < ring.first + ring.size; ++k) {
      const double x = (polygons.vertices[k].x() - geometry.origin_x) / geometry.resolution * kCell;
      const double y = (polygons.vertices[k].y() - geometry.origin_y) / geometry.resolution * kCell;
      constexpr double kRounding = 1e-6;  // of the conversion to metres and back
      on_lattice_ =
          on_lattice_ && std::abs(x - std::round(x)) < kRounding && std::abs(y - std::round(y)) < kRounding;
      points.push_back({std::llround(x), std::llround(y)});
    }
    boundary_of_.push_back(ring.hole && !rings_.empty() ? boundary_of_.back() : rings_.size());
    is_hole_.push_back(ring.hole);
    for (std::size_t k = 0; k < points.size(); ++k) {
      edges_.push_back({points[k], points[(k + 1) % points.size()], rings_.size(), k});
    }
    rings_.push_back(std::move(points));
  }
  for (int j = 0; j < occupancy.cellsY(); ++j) {
    for (int i = 0; i < occupancy.cellsX(); ++i) {
      if (occupancy.occupied(i, j)) occupied_.push_back({kCell * i, kCell * j});
    }
  }
}

std::int64_t PolygonChecker::cross(Point a, Point b, Point c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool PolygonChecker::touch(const Edge& e, const Edge& f)
{
  if (std::max(e.a.x, e.b.x) < std::min(f.a.x, f.b.x) || std::max(f.a.x, f.b.x) < std::min(e.a.x, e.b.x) ||
      std::max(e.a.y, e.b.y) < std::min(f.a.y, f.b.y) || std::max(f.a.y, f.b.y) < std::min(e.a.y, e.b.y)) {
    return false;
  }
  const auto side = [](std::int64_t value) { return (value > 0) - (value < 0); };
  return side(cross(e.a, e.b, f.a)) * side(cross(e.a, e.b, f.b)) <= 0 &&
         side(cross(f.a, f.b, e.a)) * side(cross(f.a, f.b, e.b)) <= 0;
}

bool PolygonChecker::inside(const Ring& ring, Point p)
{
  bool in = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point a = ring[k];
    const Point b = ring[(k + 1) % ring.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const std::int64_t turn = cross(a, b, p);
    if ((b.y > a.y) == (turn > 0)) in = !in;
  }
  return in;
}

bool PolygonChecker::insidePolygons(Point p) const
{
  // The rings of all polygons together: each hole takes away what its boundary adds.
  bool in = false;
  for (const Ring& ring : rings_) in = in != inside(ring, p);
  return in;
}

bool PolygonChecker::onBorder(const Edge& edge) const
{
  const auto both = [](std::int64_t a, std::int64_t b, std::int64_t line) { return a == line && b == line; };
  return both(edge.a.x, edge.b.x, 0) || both(edge.a.x, edge.b.x, width_) || both(edge.a.y, edge.b.y, 0) ||
         both(edge.a.y, edge.b.y, height_);
}

bool PolygonChecker::within(Point p, Point corner, CellLength length) const
{
  const std::int64_t distance2 = square(gap(p.x, corner.x)) + square(gap(p.y, corner.y));
  return distance2 * square(length.denominator) <= square(kCell * length.numerator);
}

bool PolygonChecker::nearerThan(const Edge& edge, Point corner, CellLength length) const
{
  const std::int64_t limit2 = square(kCell * length.numerator);
  const std::int64_t scale2 = square(length.denominator);
  // Through the inside of the square: neither axis nor the edge's own line parts them.
  const Point corners[] = {{corner.x, corner.y},
                           {corner.x + kCell, corner.y},
                           {corner.x + kCell, corner.y + kCell},
                           {corner.x, corner.y + kCell}};
  bool left = false;
  bool right = false;
  for (const Point& c : corners) {
    const std::int64_t side = cross(edge.a, edge.b, c);
    left = left || side > 0;
    right = right || side < 0;
  }
  const bool apart =
      std::max(edge.a.x, edge.b.x) <= corner.x || std::min(edge.a.x, edge.b.x) >= corner.x + kCell ||
      std::max(edge.a.y, edge.b.y) <= corner.y || std::min(edge.a.y, edge.b.y) >= corner.y + kCell;
  if (!apart && left && right) return true;
  // From an end of the edge to the square, or from a corner of the square to the inside of the edge.
  for (const Point& end : {edge.a, edge.b}) {
    const std::int64_t distance2 = square(gap(end.x, corner.x)) + square(gap(end.y, corner.y));
    if (distance2 * scale2 < limit2) return true;
  }
  const std::int64_t length2 = square(edge.b.x - edge.a.x) + square(edge.b.y - edge.a.y);
  return std::any_of(std::begin(corners), std::end(corners), [&](const Point& c) {
    const std::int64_t along =
        (c.x - edge.a.x) * (edge.b.x - edge.a.x) + (c.y - edge.a.y) * (edge.b.y - edge.a.y);
    if (along <= 0 || along >= length2) return false;
    return static_cast<Wide>(square(cross(edge.a, edge.b, c))) * scale2 < static_cast<Wide>(limit2) * length2;
  });
}

template <class Predicate>
bool PolygonChecker::anyNear(Point p, Predicate&& holds) const
{
  const std::int64_t reach = limit_.numerator / limit_.denominator + 2;
  const std::int64_t i = p.x / kCell;
  const std::int64_t j = p.y / kCell;
  for (auto y = std::max<std::int64_t>(0, j - reach);
       y <= std::min<std::int64_t>(grid_.cellsY() - 1, j + reach); ++y) {
    for (auto x = std::max<std::int64_t>(0, i - reach);
         x <= std::min<std::int64_t>(grid_.cellsX() - 1, i + reach); ++x) {
      if (grid_.occupied(static_cast<int>(x), static_cast<int>(y)) && holds(Point{kCell * x, kCell * y}))
        return true;
    }
  }
  return false;
}

bool PolygonChecker::crossed(Point corner, std::int64_t side) const
{
  return std::any_of(edges_.begin(), edges_.end(), [&](const Edge& edge) {
    return std::max(edge.a.x, edge.b.x) >= corner.x && std::min(edge.a.x, edge.b.x) <= corner.x + side &&
           std::max(edge.a.y, edge.b.y) >= corner.y && std::min(edge.a.y, edge.b.y) <= corner.y + side;
  });
}

bool PolygonChecker::reachable(Point a, Point b, int depth) const
{
  // The distance to a square is convex: within the limit at both ends, it is so in between.
  if (anyNear(a, [&](Point corner) { return within(a, corner, limit_) && within(b, corner, limit_); }))
    return true;
  if (depth == 0) return false;
  const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
  // Rounding the middle moves it off the edge, by less than a unit: it is checked against both neighbours.
  return reachable(a, middle, depth - 1) && reachable(middle, b, depth - 1);
}

bool PolygonChecker::reachable(Point corner, std::int64_t side) const
{
  if (!crossed(corner, side) && !insidePolygons(corner)) return true;
  const Point corners[] = {
      corner, {corner.x + side, corner.y}, {corner.x + side, corner.y + side}, {corner.x, corner.y + side}};
  const bool by_one = anyNear(corner, [&](Point occupied) {
    return std::all_of(std::begin(corners), std::end(corners),
                       [&](const Point& c) { return within(c, occupied, limit_); });
  });
  if (by_one) return true;
  const std::int64_t half = side / 2;
  if (half == 0) {
    // As small as can be: what an edge runs through is checked along the edge.
    const bool at_edge = std::any_of(edges_.begin(), edges_.end(), [&](const Edge& edge) {
      return nearerThan(edge, corner, {1, 32});
    });
    return at_edge || !insidePolygons(corner);
  }
  for (const Point& quarter : {corner, Point{corner.x + half, corner.y}, Point{corner.x, corner.y + half},
                               Point{corner.x + half, corner.y + half}}) {
    if (!reachable(quarter, half)) return false;
  }
  return true;
}

std::optional<std::string> PolygonChecker::fault() const
{
  for (const auto check : {&PolygonChecker::notOnLattice, &PolygonChecker::notSimple,
                           &PolygonChecker::wrongNesting, &PolygonChecker::unsafe, &PolygonChecker::loose}) {
    if (auto found = (this->*check)()) return found;
  }
  return std::nullopt;
}

std::optional<std::string> PolygonChecker::notOnLattice() const
{
  if (!on_lattice_) return "a vertex is not on the lattice of 64ths of a cell";
  return std::nullopt;
}

std::optional<std::string> PolygonChecker::notSimple() const
{
  for (const Ring& ring : rings_) {
    if (ring.size() < 3) return "clause 1: a ring of " + std::to_string(ring.size()) + " vertices";
  }
  for (std::size_t m = 0; m < edges_.size(); ++m) {
    for (std::size_t n = m + 1; n < edges_.size(); ++n) {
      const Edge& e = edges_[m];
      const Edge& f = edges_[n];
      if (e.ring == f.ring) {
        const std::size_t size = rings_[e.ring].size();
        const bool follows = f.index == e.index + 1;
        const bool precedes = e.index == 0 && f.index + 1 == size;
        if (follows || precedes) {
          // Neighbours meet in one vertex and do not fold back.
          const Edge& first = follows ? e : f;
          const Edge& second = follows ? f : e;
          const std::int64_t ahead = (first.b.x - first.a.x) * (second.b.x - second.a.x) +
                                     (first.b.y - first.a.y) * (second.b.y - second.a.y);
          if (cross(first.a, first.b, second.b) == 0 && ahead <= 0) {
            return "clause 1: a ring folds back at " + at(first.b.x, first.b.y);
          }
          continue;
        }
      }
      if (touch(e, f)) {
        return std::string(e.ring == f.ring ? "clause 1: a ring touches itself" : "clause 2: rings touch") +
               " near " + at(e.a.x, e.a.y);
      }
    }
  }
  return std::nullopt;
}

std::optional<std::string> PolygonChecker::wrongNesting() const
{
  for (std::size_t r = 0; r < rings_.size(); ++r) {
    std::int64_t area2 = 0;
    for (std::size_t k = 0; k < rings_[r].size(); ++k) {
      const Point a = rings_[r][k];
      const Point b = rings_[r][(k + 1) % rings_[r].size()];
      area2 += a.x * b.y - b.x * a.y;
    }
    if (is_hole_[r] ? area2 >= 0 : area2 <= 0)
      return std::string("clause 1: wrong orientation of a ") + (is_hole_[r] ? "hole" : "boundary");
    if (is_hole_[r] && (boundary_of_[r] == r || !inside(rings_[boundary_of_[r]], rings_[r][0]))) {
      return "clause 1: a hole is outside of its boundary, near " + at(rings_[r][0].x, rings_[r][0].y);
    }
    // As rings do not touch, one vertex says where a ring lies.
    for (std::size_t other = 0; other < rings_.size(); ++other) {
      if (is_hole_[other] || boundary_of_[r] == other || !inside(rings_[other], rings_[r][0])) continue;
      bool in_its_hole = false;
      for (std::size_t hole = 0; hole < rings_.size(); ++hole) {
        in_its_hole = in_its_hole ||
                      (is_hole_[hole] && boundary_of_[hole] == other && inside(rings_[hole], rings_[r][0]));
      }
      if (!in_its_hole) return "clause 2: polygons overlap near " + at(rings_[r][0].x, rings_[r][0].y);
    }
  }
  return std::nullopt;
}

std::optional<std::string> PolygonChecker::unsafe() const
{
  for (const Point& corner : occupied_) {
    if (!insidePolygons({corner.x + kCell / 2, corner.y + kCell / 2})) {
      return "clause 3: the occupied cell at " + at(corner.x, corner.y) + " is outside of the polygons";
    }
    for (const Edge& edge : edges_) {
      if (!onBorder(edge) && nearerThan(edge, corner, radius_)) {
        return "clause 3: the edge from " + at(edge.a.x, edge.a.y) + " to " + at(edge.b.x, edge.b.y) +
               " is too near to the occupied cell at " + at(corner.x, corner.y);
      }
    }
  }
  return std::nullopt;
}

std::optional<std::string> PolygonChecker::loose() const
{
  constexpr int kDepth = 14;
  for (const Edge& edge : edges_) {
    if (!reachable(edge.a, edge.b, kDepth)) {
      return "clause 4: the edge from " + at(edge.a.x, edge.a.y) + " to " + at(edge.b.x, edge.b.y) +
             " is too far from every occupied cell";
    }
  }
  for (std::int64_t y = 0; y < height_; y += kCell) {
    for (std::int64_t x = 0; x < width_; x += kCell) {
      if (!reachable({x, y}, kCell))
        return "clause 4: a point inside is too far from every occupied cell, near " + at(x, y);
    }
  }
  return std::nullopt;
}

}  // namespace polygonal_perception::reference
