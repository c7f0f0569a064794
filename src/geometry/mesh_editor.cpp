#include "geometry/mesh_editor.hpp"

namespace polygonal_perception::geometry {

void MeshEditor::put(std::uint32_t to, const HalfEdge& edge)
{
  mesh_.half_edges[to] = edge;
  if (edge.twin != TriangleMesh::kNone) mesh_.half_edges[edge.twin].twin = to;
  mesh_.outgoing[edge.origin] = to;
}

std::uint32_t MeshEditor::addVertex(const Eigen::Vector2d& point)
{
  mesh_.vertices.push_back(point);
  mesh_.outgoing.push_back(TriangleMesh::kNone);
  return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
}

std::uint32_t MeshEditor::addTriangle()
{
  const auto first = static_cast<std::uint32_t>(mesh_.half_edges.size());
  mesh_.half_edges.resize(mesh_.half_edges.size() + 3);
  return first;
}

void MeshEditor::join(std::uint32_t a, std::uint32_t b)
{
  mesh_.half_edges[a].twin = b;
  mesh_.half_edges[b].twin = a;
}

void MeshEditor::beginWithSquare(const Eigen::Vector2d& low, const Eigen::Vector2d& high)
{
  mesh_.clear();
  addVertex(low);
  addVertex({high.x(), low.y()});
  addVertex(high);
  addVertex({low.x(), high.y()});
  const std::uint32_t lower = addTriangle();
  const std::uint32_t upper = addTriangle();
  const std::uint32_t corners[2][3] = {{0, 1, 2}, {0, 2, 3}};
  for (std::uint32_t i = 0; i < 3; ++i) {
    put(lower + i, {corners[0][i]});
    put(upper + i, {corners[1][i]});
  }
  join(lower + 2, upper);
}

std::uint32_t MeshEditor::splitTriangle(std::uint32_t triangle, const Eigen::Vector2d& point)
{
  // a, b, c become a, b, v in its place, and b, c, v and c, a, v.
  const std::uint32_t ab = 3 * triangle;
  const HalfEdge bc = mesh_.half_edges[ab + 1];
  const HalfEdge ca = mesh_.half_edges[ab + 2];
  const std::uint32_t v = addVertex(point);
  const std::uint32_t second = addTriangle();
  const std::uint32_t third = addTriangle();
  put(second, bc);
  put(third, ca);
  put(ab + 1, {bc.origin});
  put(ab + 2, {v});
  put(second + 1, {ca.origin});
  put(second + 2, {v});
  put(third + 1, {mesh_.half_edges[ab].origin});
  put(third + 2, {v});
  join(ab + 1, second + 2);
  join(second + 1, third + 2);
  join(third + 1, ab + 2);
  return v;
}

std::uint32_t MeshEditor::splitEdge(std::uint32_t half_edge, const Eigen::Vector2d& point)
{
  // a, b, c and, on the other side, b, a, d become a, v, c and v, b, c, and b, v, d and v, a, d.
  const std::uint32_t av = half_edge;
  const std::uint32_t bv = mesh_.twin(half_edge);
  const std::uint32_t bc_place = TriangleMesh::next(av);
  const std::uint32_t ad_place = TriangleMesh::next(bv);
  const HalfEdge bc = mesh_.half_edges[bc_place];
  const HalfEdge ad = mesh_.half_edges[ad_place];
  const std::uint32_t c = mesh_.apex(av);
  const std::uint32_t d = mesh_.apex(bv);
  const std::uint32_t v = addVertex(point);
  const std::uint32_t vb = addTriangle();
  const std::uint32_t va = addTriangle();
  HalfEdge along = mesh_.half_edges[av];
  along.origin = v;
  put(vb, along);  // its twin, b to a, becomes b to v in its place
  HalfEdge against = mesh_.half_edges[bv];
  against.origin = v;
  against.twin = TriangleMesh::kNone;
  put(va, against);
  put(vb + 1, bc);
  put(vb + 2, {c});
  put(va + 1, ad);
  put(va + 2, {d});
  put(bc_place, {v});
  put(ad_place, {v});
  join(bc_place, vb + 2);
  join(ad_place, va + 2);
  join(av, va);
  join(bv, vb);
  return v;
}

void MeshEditor::flip(std::uint32_t half_edge)
{
  // a, b, c and b, a, d become d, c, a and c, d, b.
  const std::uint32_t h = half_edge;
  const std::uint32_t g = mesh_.twin(half_edge);
  const std::uint32_t h_next = TriangleMesh::next(h);
  const std::uint32_t h_previous = TriangleMesh::previous(h);
  const std::uint32_t g_next = TriangleMesh::next(g);
  const std::uint32_t g_previous = TriangleMesh::previous(g);
  const HalfEdge bc = mesh_.half_edges[h_next];
  const HalfEdge ca = mesh_.half_edges[h_previous];
  const HalfEdge ad = mesh_.half_edges[g_next];
  const HalfEdge db = mesh_.half_edges[g_previous];
  put(h, {db.origin, g});
  put(g, {ca.origin, h});
  put(h_next, ca);
  put(h_previous, ad);
  put(g_next, db);
  put(g_previous, bc);
}

}  // namespace polygonal_perception::geometry
