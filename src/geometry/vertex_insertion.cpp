#include "geometry/vertex_insertion.hpp"

#include <cmath>
#include <limits>

#include "polygonal_perception/geometry/mesh_location.hpp"

namespace polygonal_perception::geometry {

namespace {

/// Whether d lies in the circle through a, b and c, beyond doubt: a triangulation that is flipped then only comes nearer
/// to Delaunay's each time, so that it ends, and where rounding leaves a doubt either diagonal is as good.
bool isSurelyInCircle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                      const Eigen::Vector2d& d)
{
  // The filter of J. R. Shewchuk's incircle test (1997).
  constexpr double kEpsilon = 0.5 * std::numeric_limits<double>::epsilon();
  constexpr double kBound = (10.0 + 96.0 * kEpsilon) * kEpsilon;
  const double adx = a.x() - d.x();
  const double ady = a.y() - d.y();
  const double bdx = b.x() - d.x();
  const double bdy = b.y() - d.y();
  const double cdx = c.x() - d.x();
  const double cdy = c.y() - d.y();
  const double a_lift = adx * adx + ady * ady;
  const double b_lift = bdx * bdx + bdy * bdy;
  const double c_lift = cdx * cdx + cdy * cdy;
  const double determinant =
      a_lift * (bdx * cdy - cdx * bdy) + b_lift * (cdx * ady - adx * cdy) + c_lift * (adx * bdy - bdx * ady);
  const double magnitude = a_lift * (std::abs(bdx * cdy) + std::abs(cdx * bdy)) +
                           b_lift * (std::abs(cdx * ady) + std::abs(adx * cdy)) +
                           c_lift * (std::abs(adx * bdy) + std::abs(bdx * ady));
  return determinant > kBound * magnitude;
}

}  // namespace

std::uint32_t VertexInsertion::insert(const Eigen::Vector2d& point)
{
  const MeshPlace place = locate(mesh_, point, last_);
  if (place.at_origin) return mesh_.origin(place.half_edge);
  const std::uint32_t vertex = place.on_edge
                                   ? editor_.splitEdge(place.half_edge, point)
                                   : editor_.splitTriangle(TriangleMesh::triangleOf(place.half_edge), point);
  makeDelaunay(vertex);
  last_ = mesh_.outgoing[vertex];
  return vertex;
}

void VertexInsertion::makeDelaunay(std::uint32_t vertex)
{
  // The edges opposite the new vertex, and those that flips bring there.
  doubtful_.clear();
  const std::uint32_t first = mesh_.outgoing[vertex];
  std::uint32_t spoke = first;
  do {
    doubtful_.push_back(TriangleMesh::next(spoke));
    spoke = mesh_.nextAround(spoke);
  } while (spoke != first);
  while (!doubtful_.empty()) {
    const std::uint32_t edge = doubtful_.back();
    doubtful_.pop_back();
    const std::uint32_t twin = mesh_.twin(edge);
    if (twin == TriangleMesh::kNone) continue;
    if (!isSurelyInCircle(mesh_.originPoint(edge), mesh_.targetPoint(edge), mesh_.apexPoint(edge),
                          mesh_.apexPoint(twin)))
      continue;
    editor_.flip(edge);
    // The vertex is now an end of the diagonal, in both triangles.
    doubtful_.push_back(TriangleMesh::previous(edge));
    doubtful_.push_back(TriangleMesh::next(twin));
  }
}

}  // namespace polygonal_perception::geometry
