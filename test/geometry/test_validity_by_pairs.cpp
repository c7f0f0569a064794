// The validity of random sets of every kind, against each edge compared with every other one.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>

#include "polygonal_perception/geometry/distance.hpp"
#include "polygonal_perception/geometry/location.hpp"
#include "polygonal_perception/geometry/predicates.hpp"
#include "polygonal_perception/geometry/validity.hpp"

namespace polygonal_perception::geometry {
namespace {

using Vertices = std::vector<Eigen::Vector2d>;

/// What is wrong with a set, and the ring, or nothing: the plain way, of sets that findDefect() looks at edge by edge.
class ByPairs
{
public:
  explicit ByPairs(const PolygonSet& polygons) : polygons_(polygons) {}

  std::optional<Defect> defect() const
  {
    if (anyPair(true)) return Defect::kRingMeetsItself;
    if (anyPair(false)) return Defect::kRingsMeet;
    for (const PolygonSet::Ring& ring : polygons_.rings) {
      if ((orientation(polygons_.view(ring)) == Orientation::kClockwise) != ring.hole)
        return Defect::kWrongOrientation;
    }
    for (std::size_t r = 0; r < polygons_.rings.size(); ++r) {
      if (auto found = nesting(r)) return found;
    }
    return std::nullopt;
  }

  /// Whether a place lies on two edges that are no neighbours, of a ring or of two.
  bool meetAt(const Eigen::Vector2d& place) const
  {
    int edges = 0;
    for (const PolygonSet::Ring& ring : polygons_.rings) {
      for (const auto [from, to] : polygons_.view(ring).edges()) {
        edges += (nearestOnSegment(place, from, to) - place).norm() < 1e-9 ? 1 : 0;
      }
    }
    return edges >= 2;
  }

private:
  bool anyPair(bool of_one_ring) const
  {
    for (std::size_t r = 0; r < polygons_.rings.size(); ++r) {
      for (std::size_t s = r; s < (of_one_ring ? r + 1 : polygons_.rings.size()); ++s) {
        if (r == s && !of_one_ring) continue;
        if (meet(r, s)) return true;
      }
    }
    return false;
  }

  bool meet(std::size_t r, std::size_t s) const
  {
    const RingView a = polygons_.view(polygons_.rings[r]);
    const RingView b = polygons_.view(polygons_.rings[s]);
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = r == s ? i + 1 : 0; j < b.size(); ++j) {
        const auto contact = segmentContact(a.edge(i).from, a.edge(i).to, b.edge(j).from, b.edge(j).to);
        const bool follow = r == s && (a.next(i) == j || a.next(j) == i);
        if (follow ? contact == SegmentContact::kOverlap : contact != SegmentContact::kNone) return true;
      }
    }
    return false;
  }

  bool isIn(std::size_t inner, std::size_t outer) const
  {
    return inner != outer && locate(polygons_.vertices[polygons_.rings[inner].first],
                                    polygons_.view(polygons_.rings[outer])) == Location::kInside;
  }

  std::size_t boundaryOf(std::size_t r) const
  {
    while (polygons_.rings[r].hole) --r;
    return r;
  }

  std::optional<Defect> nesting(std::size_t r) const
  {
    if (polygons_.rings[0].hole) return Defect::kHoleOutside;
    if (polygons_.rings[r].hole) {
      bool is_wrong = !isIn(r, boundaryOf(r));
      for (std::size_t s = 0; s < polygons_.rings.size(); ++s)
        is_wrong = is_wrong || (polygons_.rings[s].hole && boundaryOf(s) == boundaryOf(r) && isIn(r, s));
      return is_wrong ? std::optional(Defect::kHoleOutside) : std::nullopt;
    }
    for (std::size_t s = 0; s < polygons_.rings.size(); ++s) {
      if (polygons_.rings[s].hole || !isIn(r, s)) continue;
      bool is_in_hole = false;
      for (std::size_t h = s + 1; h < polygons_.rings.size() && polygons_.rings[h].hole; ++h)
        is_in_hole = is_in_hole || isIn(r, h);
      if (!is_in_hole) return Defect::kPolygonsOverlap;
    }
    return std::nullopt;
  }

  const PolygonSet& polygons_;
};

std::string textOf(const PolygonSet& polygons)
{
  std::ostringstream text;
  for (const PolygonSet::Ring& ring : polygons.rings) {
    text << (ring.hole ? "hole" : "ring");
    for (const Eigen::Vector2d& vertex : polygons.view(ring)) text << " (" << vertex.transpose() << ")";
    text << "\n";
  }
  return text.str();
}

/// How often each answer came, so that a test can hold that all do.
class Tally
{
public:
  void compare(const PolygonSet& polygons)
  {
    const ByPairs plain(polygons);
    const std::optional<Defect> expected = plain.defect();
    const std::optional<Invalidity> found = findDefect(polygons);
    ASSERT_EQ(found.has_value(), expected.has_value()) << (found ? found->text : "taken for valid") << "\n"
                                                       << textOf(polygons);
    ++(expected ? count_[static_cast<std::size_t>(*expected)] : valid_);
    if (!expected) return;
    ASSERT_EQ(found->defect, *expected) << found->text << "\n" << textOf(polygons);
    if (*expected == Defect::kRingMeetsItself || *expected == Defect::kRingsMeet) {
      ASSERT_TRUE(plain.meetAt(found->place)) << found->text << "\n" << textOf(polygons);
    }
  }

  int valid() const { return valid_; }
  int count(Defect defect) const { return count_[static_cast<std::size_t>(defect)]; }

private:
  int valid_ = 0;
  int count_[8] = {};
};

/// Draws whole numbers, so that points fall on points and edges, and edges on edges.
class Draw
{
public:
  explicit Draw(std::uint32_t seed) : random_(seed) {}
  int below(int end) { return static_cast<int>(random_() % static_cast<std::uint32_t>(end)); }
  Eigen::Vector2d point(int side) { return Eigen::Vector2d(below(side), below(side)); }

  /// A ring of random points, none followed by itself.
  Vertices ring(int size, int side)
  {
    Vertices vertices;
    while (static_cast<int>(vertices.size()) < size) {
      const Eigen::Vector2d p = point(side);
      const bool is_last = static_cast<int>(vertices.size()) + 1 == size;
      if (!vertices.empty() && (p == vertices.back() || (is_last && p == vertices.front()))) continue;
      vertices.push_back(p);
    }
    return vertices;
  }

  /// A rectangle or a triangle with whole corners, in the direction that it ought to have.
  Vertices simple(int side, bool clockwise)
  {
    const Eigen::Vector2d a = point(side);
    const Eigen::Vector2d size(1 + below(side), 1 + below(side));
    Vertices vertices = {a, a + Eigen::Vector2d(size.x(), 0), a + size, a + Eigen::Vector2d(0, size.y())};
    if (below(3) == 0) vertices.erase(vertices.begin() + below(4));
    if (below(4) == 0) vertices.insert(vertices.begin() + 1, 0.5 * (vertices[0] + vertices[1]));
    std::rotate(vertices.begin(), vertices.begin() + below(static_cast<int>(vertices.size())),
                vertices.end());
    if (clockwise) std::reverse(vertices.begin(), vertices.end());
    return vertices;
  }

private:
  std::mt19937 random_;
};

TEST(ValidityByPairs, OfRingsOfAnyPoints)
{
  Draw draw(1);
  Tally tally;
  for (int round = 0; round < 20000; ++round) {
    PolygonSet polygons;
    const int side = 2 + draw.below(round % 2 == 0 ? 4 : 1000);
    for (int rings = 1 + draw.below(2); rings > 0; --rings)
      polygons.append(draw.ring(3 + draw.below(5), side), draw.below(3) == 0);
    ASSERT_NO_FATAL_FAILURE(tally.compare(polygons)) << "round " << round;
  }
  EXPECT_GT(tally.valid(), 1000);
  for (const Defect defect : {Defect::kRingMeetsItself, Defect::kRingsMeet, Defect::kWrongOrientation})
    EXPECT_GT(tally.count(defect), 200) << static_cast<int>(defect);
}

TEST(ValidityByPairs, OfSimpleRingsInAndBesideOneAnother)
{
  Draw draw(2);
  Tally tally;
  for (int round = 0; round < 40000; ++round) {
    PolygonSet polygons;
    const int side = 3 + draw.below(60);
    for (int rings = 1 + draw.below(5); rings > 0; --rings) {
      const bool is_hole = draw.below(3) == 0;
      polygons.append(draw.simple(side, is_hole != (draw.below(30) == 0)), is_hole);
    }
    ASSERT_NO_FATAL_FAILURE(tally.compare(polygons)) << "round " << round;
  }
  EXPECT_GT(tally.valid(), 1000);
  for (const Defect defect :
       {Defect::kRingsMeet, Defect::kWrongOrientation, Defect::kHoleOutside, Defect::kPolygonsOverlap})
    EXPECT_GT(tally.count(defect), 50) << static_cast<int>(defect);
}

TEST(ValidityByPairs, OfRingsAroundOnePointInAnyOrder)
{
  Draw draw(3);
  Tally tally;
  for (int round = 0; round < 5000; ++round) {
    // Boundaries and holes in turn from the outside in; some are mixed up.
    struct Level
    {
      Vertices vertices;
      bool hole;
    };
    std::vector<Level> levels;
    const int depth = 1 + draw.below(7);
    for (int k = 0; k < depth; ++k) {
      const double side = 2.0 * (depth - k);
      Vertices square = {{-side, -side}, {side, -side}, {side, side}, {-side, side}};
      if (draw.below(3) == 0) square.erase(square.begin() + draw.below(4));
      levels.push_back({square, k % 2 == 1});
    }
    if (draw.below(3) == 0 && depth > 1)
      std::swap(levels[static_cast<std::size_t>(draw.below(depth))],
                levels[static_cast<std::size_t>(draw.below(depth))]);
    if (draw.below(4) == 0) levels.erase(levels.begin() + draw.below(depth));
    PolygonSet polygons;
    for (Level& level : levels) {
      if (draw.below(8) == 0) level.hole = !level.hole;
      if (level.hole) std::reverse(level.vertices.begin(), level.vertices.end());
      polygons.append(level.vertices, level.hole);
    }
    ASSERT_NO_FATAL_FAILURE(tally.compare(polygons)) << "round " << round;
  }
  EXPECT_GT(tally.valid(), 500);
  for (const Defect defect : {Defect::kHoleOutside, Defect::kPolygonsOverlap})
    EXPECT_GT(tally.count(defect), 200) << static_cast<int>(defect);
}

/// Triangles around one point, each in the one before it: boundaries and holes in turn.
PolygonSet triangles(int count)
{
  PolygonSet polygons;
  for (int k = 0; k < count; ++k) {
    const double side = count - k;
    Vertices triangle = {{-2 * side, -side}, {2 * side, -side}, {0, side}};
    if (k % 2 == 1) std::reverse(triangle.begin(), triangle.end());
    polygons.append(triangle, k % 2 == 1);
  }
  return polygons;
}

TEST(ValidityByPairs, AHostileFileIsLookedThroughInSeconds)
{
  // All edges lie over one another along x and along y: pair by pair it takes hours.
  PolygonSet polygons = triangles(100'000);
  const auto found = findDefect(polygons);
  EXPECT_FALSE(found) << found->text;
  polygons.vertices[3 * 60'001] = {0.0, -39'000.5};
  EXPECT_TRUE(findDefect(polygons)) << "one that reaches into the next ones is taken for valid";
}

}  // namespace
}  // namespace polygonal_perception::geometry
