#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "polygonal_perception/geometry/constrained_triangulation.hpp"
#include "polygonal_perception/geometry/mesh_location.hpp"
#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::geometry {
namespace {

using Ring = std::vector<Eigen::Vector2d>;

PolygonSet setOf(const std::vector<Ring>& boundaries)
{
  PolygonSet set;
  for (const Ring& ring : boundaries) set.append(ring, false);
  return set;
}

Ring square(double x, double y, double side)
{
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

double doubledArea(const TriangleMesh& mesh, std::uint32_t edge)
{
  const Eigen::Vector2d a = mesh.targetPoint(edge) - mesh.originPoint(edge);
  const Eigen::Vector2d b = mesh.apexPoint(edge) - mesh.originPoint(edge);
  return a.x() * b.y() - a.y() * b.x();
}

/// What is wrong with a mesh; empty where it is one.
std::string meshFault(const TriangleMesh& mesh)
{
  for (std::uint32_t edge = 0; edge < mesh.half_edges.size(); ++edge) {
    const std::string name = "half-edge " + std::to_string(edge);
    if (edge % 3 == 0 && orientation(mesh.originPoint(edge), mesh.targetPoint(edge), mesh.apexPoint(edge)) !=
                             Orientation::kCounterClockwise)
      return name + " is of a triangle that is not counter-clockwise";
    const std::uint32_t twin = mesh.twin(edge);
    if (twin == TriangleMesh::kNone) {
      if (mesh.origin(edge) >= 4 || mesh.target(edge) >= 4) return name + " is on a border within the square";
      continue;
    }
    if (mesh.twin(twin) != edge || mesh.origin(twin) != mesh.target(edge) ||
        mesh.target(twin) != mesh.origin(edge))
      return name + " and its twin do not fit";
    if (mesh.half_edges[edge].constrained != mesh.half_edges[twin].constrained ||
        mesh.half_edges[edge].step != -mesh.half_edges[twin].step)
      return name + " and its twin are marked differently";
  }
  for (std::uint32_t vertex = 0; vertex < mesh.vertices.size(); ++vertex)
    if (mesh.origin(mesh.outgoing[vertex]) != vertex)
      return "vertex " + std::to_string(vertex) + " has another's edge";
  return "";
}

/// The area that is in polygons, each as often as polygons contain it, from the steps between triangles.
double coveredArea(const TriangleMesh& mesh)
{
  std::vector<int> depth(mesh.triangleCount(), std::numeric_limits<int>::min());
  std::vector<std::uint32_t> open{mesh.outgoing[0]};
  depth[open.front() / 3] = 0;
  double area = 0.0;
  while (!open.empty()) {
    std::uint32_t edge = open.back();
    open.pop_back();
    area += 0.5 * depth[edge / 3] * doubledArea(mesh, edge);
    for (int i = 0; i < 3; ++i, edge = TriangleMesh::next(edge)) {
      const std::uint32_t twin = mesh.twin(edge);
      if (twin == TriangleMesh::kNone || depth[twin / 3] != std::numeric_limits<int>::min()) continue;
      depth[twin / 3] = depth[edge / 3] + mesh.half_edges[twin].step;
      open.push_back(twin);
    }
  }
  return area;
}

double signedArea(const PolygonSet& set)
{
  double area = 0.0;
  for (const PolygonSet::Ring& ring : set.rings)
    for (const auto [from, to] : set.view(ring).edges())
      area += 0.5 * (from.x() * to.y() - from.y() * to.x());
  return area;
}

/// Whether the way from one vertex to another is a chain of constrained edges.
bool hasChain(const TriangleMesh& mesh, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  Eigen::Vector2d at = from;
  while (at != to) {
    const MeshPlace place = locate(mesh, at, 0);
    if (!place.at_origin) return false;
    std::uint32_t spoke = place.half_edge;
    double nearest = std::numeric_limits<double>::infinity();
    Eigen::Vector2d next = at;
    do {
      const Eigen::Vector2d end = mesh.targetPoint(spoke);
      const double distance = (end - at).norm();
      if (mesh.half_edges[spoke].constrained && distance < nearest && isOnSegment(end, at, to)) {
        nearest = distance;
        next = end;
      }
      spoke = mesh.nextAround(spoke);
    } while (spoke != place.half_edge);
    if (next == at) return false;
    at = next;
  }
  return true;
}

TEST(ConstrainedTriangulation, ASquareOfItsOwnWithoutPolygons)
{
  TriangleMesh mesh;
  ASSERT_FALSE(ConstrainedTriangulation().triangulate({}, mesh));
  EXPECT_EQ(mesh.triangleCount(), 2U);
  EXPECT_EQ(meshFault(mesh), "");
  EXPECT_GE(mesh.vertices[2].x(), ConstrainedTriangulation::kLeastMargin);
}

TEST(ConstrainedTriangulation, EveryEdgeOfAPolygonIsOne)
{
  const PolygonSet set = setOf({square(0, 0, 1), square(3, 1, 2)});
  TriangleMesh mesh;
  ASSERT_FALSE(ConstrainedTriangulation().triangulate(set, mesh));
  EXPECT_EQ(meshFault(mesh), "");
  EXPECT_EQ(mesh.vertices.size(), 12U);
  for (const auto& ring : set.rings)
    for (const auto [from, to] : set.view(ring).edges()) EXPECT_TRUE(hasChain(mesh, from, to));
  EXPECT_DOUBLE_EQ(coveredArea(mesh), 5.0);
}

TEST(ConstrainedTriangulation, AnEdgeThroughAVertexIsAChain)
{
  const PolygonSet set = setOf({{{0, 0}, {4, 0}, {2, 3}}, {{1, -1}, {2, 0}, {1, 0}}});
  TriangleMesh mesh;
  ASSERT_FALSE(ConstrainedTriangulation().triangulate(set, mesh));
  EXPECT_EQ(meshFault(mesh), "");
  EXPECT_TRUE(hasChain(mesh, {0, 0}, {4, 0}));
  EXPECT_DOUBLE_EQ(coveredArea(mesh), 6.5);
}

TEST(ConstrainedTriangulation, PolygonsThatShareAnEdgeOrACorner)
{
  for (const double shift : {0.0, 0.5, 1.0}) {
    const PolygonSet set = setOf({square(0, 0, 1), square(1, shift, 1)});
    TriangleMesh mesh;
    ASSERT_FALSE(ConstrainedTriangulation().triangulate(set, mesh)) << shift;
    EXPECT_EQ(meshFault(mesh), "") << shift;
    EXPECT_DOUBLE_EQ(coveredArea(mesh), 2.0) << shift;
  }
}

TEST(ConstrainedTriangulation, CrossingEdgesMeetInAVertex)
{
  const PolygonSet set = setOf({square(0, 0, 2), square(1, 1, 2)});
  TriangleMesh mesh;
  ASSERT_FALSE(ConstrainedTriangulation().triangulate(set, mesh));
  EXPECT_EQ(meshFault(mesh), "");
  EXPECT_EQ(mesh.vertices.size(), 4U + 8U + 2U);
  EXPECT_DOUBLE_EQ(coveredArea(mesh), 8.0) << "what both contain counts twice";
}

TEST(ConstrainedTriangulation, RefusesWhatHasNoPlaceOrTooManyCrossings)
{
  TriangleMesh mesh;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {nan, std::numeric_limits<double>::infinity(), -2e8, 1e-200}) {
    for (const Eigen::Vector2d& vertex : {Eigen::Vector2d(bad, 0), Eigen::Vector2d(1.5, bad)}) {
      const auto fault =
          ConstrainedTriangulation().triangulate(setOf({square(0, 0, 1), {{0, 0}, vertex, {1, 1}}}), mesh);
      ASSERT_TRUE(fault) << vertex.transpose();
      EXPECT_EQ(fault->ring, 1U) << fault->text;
    }
  }
  // Combs across each other: n squared crossings.
  Ring comb;
  Ring across;
  for (int i = 0; i < 50; ++i) {
    comb.insert(comb.end(), {{2.0 * i, 0.0}, {2.0 * i + 1.0, 200.0}});
    across.insert(across.end(), {{-10.0, 1.0 + 2.0 * i}, {200.0, 2.0 + 2.0 * i}});
  }
  const auto fault = ConstrainedTriangulation().triangulate(setOf({comb, across}), mesh);
  ASSERT_TRUE(fault);
  EXPECT_NE(fault->text.find("too often"), std::string::npos) << fault->text;
}

TEST(ConstrainedTriangulation, HoldsForRandomRingsThatCrossAndTouch)
{
  std::mt19937 random(5);
  int whole = 0;
  for (int i = 0; i < 3000; ++i) {
    // On a coarse raster, so that vertices fall on edges; on a fine one; and anywhere, far from the origin.
    const double raster = std::array{1.0, 0.05, 1e-7}[i % 3];
    const double away = i % 3 == 2 ? 1e5 : 0.0;
    std::uniform_real_distribution<double> place(-4.0, 4.0);
    PolygonSet set;
    for (int r = 0; r < 1 + i % 5; ++r) {
      Ring ring;
      for (int k = 0; k < 3 + i % 4; ++k)
        ring.emplace_back(std::round(place(random) / raster) * raster + away,
                          std::round(place(random) / raster) * raster);
      set.append(ring, false);
    }
    TriangleMesh mesh;
    if (ConstrainedTriangulation().triangulate(set, mesh)) continue;
    ++whole;
    ASSERT_EQ(meshFault(mesh), "") << "set " << i;
    // Rings run either way: the area counts with its sign.
    ASSERT_NEAR(coveredArea(mesh), signedArea(set), 1e-5) << "set " << i;
  }
  EXPECT_GT(whole, 2400) << "the others cross too closely or too often";
}

TEST(MeshLocation, FindsTheTriangleTheEdgeAndTheVertex)
{
  std::mt19937 random(7);
  std::uniform_int_distribution<int> place(-40, 40);
  PolygonSet set;
  for (int r = 0; r < 60; ++r) set.append(square(place(random), place(random), 1), false);
  TriangleMesh mesh;
  ASSERT_FALSE(ConstrainedTriangulation().triangulate(set, mesh));
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector2d point(0.5 * place(random), 0.5 * place(random));
    const MeshPlace at = locate(mesh, point, random() % mesh.half_edges.size());
    int sides = 0;
    std::uint32_t edge = at.half_edge;
    for (int k = 0; k < 3; ++k, edge = TriangleMesh::next(edge)) {
      const Orientation side = orientation(mesh.originPoint(edge), mesh.targetPoint(edge), point);
      ASSERT_NE(side, Orientation::kClockwise) << point.transpose();
      sides += side == Orientation::kCollinear ? 1 : 0;
    }
    ASSERT_EQ(at.on_edge, sides > 0) << point.transpose();
    ASSERT_EQ(at.at_origin, sides == 2) << point.transpose();
    if (at.on_edge) {
      ASSERT_TRUE(isOnSegment(point, mesh.originPoint(at.half_edge), mesh.targetPoint(at.half_edge)));
    }
    if (at.at_origin) {
      ASSERT_EQ(mesh.originPoint(at.half_edge), point);
    }
  }
}

}  // namespace
}  // namespace polygonal_perception::geometry
