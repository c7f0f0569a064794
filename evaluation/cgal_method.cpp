#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyline_simplification_2/Squared_distance_cost.h>
#include <CGAL/Polyline_simplification_2/simplify.h>

#include <opencv2/core.hpp>

#include "polygon_methods.hpp"

namespace polygonal_perception::evaluation {
namespace {

namespace ps = CGAL::Polyline_simplification_2;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Triangulation_data_structure_2<ps::Vertex_base_2<Kernel>,
                                                  CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_triangulation_plus_2<
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Mesh, CGAL::Exact_predicates_tag>>;

class CgalPolylines : public PolygonMethod
{
public:
  std::string name() const override { return "CGAL Polyline_simplification_2"; }
  void polygonize(const PolygonTask& task, geometry::PolygonSet& polygons) override
  {
    Triangulation triangulation;
    std::vector<Triangulation::Constraint_id> rings;
    std::vector<Kernel::Point_2> points;
    for (const geometry::PolygonSet::Ring& ring : task.outlines.rings) {
      points.clear();
      for (const Eigen::Vector2d& vertex : task.outlines.view(ring))
        points.emplace_back(vertex.x(), vertex.y());
      rings.push_back(triangulation.insert_constraint(points.begin(), points.end(), true));
    }
    ps::simplify(triangulation, ps::Squared_distance_cost(),
                 ps::Stop_above_cost_threshold(task.tolerance * task.tolerance));
    polygons.clear();
    std::vector<cv::Point2d> simplified;
    for (std::size_t r = 0; r < rings.size(); ++r) {
      simplified.clear();
      for (auto p = triangulation.points_in_constraint_begin(rings[r]);
           p != triangulation.points_in_constraint_end(rings[r]); ++p) {
        simplified.emplace_back(p->x(), p->y());
      }
      simplified.pop_back();  // the first point is repeated
      addRing(simplified, task.outlines.rings[r].hole, polygons);
    }
  }
};

}  // namespace

std::unique_ptr<PolygonMethod> makeCgalMethod()
{
  return std::make_unique<CgalPolylines>();
}

}  // namespace polygonal_perception::evaluation
