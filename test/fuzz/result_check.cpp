#include "result_check.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace polygonal_perception::test {

void require(bool holds, const char* what)
{
  if (holds) return;
  std::fprintf(stderr, "this does not hold: %s\n", what);
  std::abort();
}

void requireSound(const perception::Pipeline::Result& result,
                  const perception::FloorDetector::Parameters& parameters)
{
  if (result.floor.status != perception::FloorStatus::kNotFound) {
    const geometry::Plane& plane = result.floor.floor.plane;
    require(std::abs(plane.normal.norm() - 1.0) < 1e-6, "the floor's normal has unit length");
    require(std::isfinite(plane.distance), "the floor's distance is finite");
    require(result.floor.status == perception::FloorStatus::kHeld ||
                (plane.distance >= parameters.selection.min_camera_height &&
                 plane.distance <= parameters.selection.max_camera_height),
            "a floor that is found is at a height that the camera can have");
    require(result.floor.age >= 0.0, "a floor is not younger than now");
    require(result.to_floor_frame.matrix().allFinite(), "the floor frame is finite");
  } else {
    require(result.occupancy.count() == 0 && result.polygons.rings.empty(), "without a floor no obstacles");
  }
  for (const perception::SegmentedPlane& plane : result.planes.planes) {
    require(std::abs(plane.plane.normal.norm() - 1.0) < 1e-6, "a plane's normal has unit length");
    require(std::isfinite(plane.plane.distance) && plane.plane.distance >= 0.0, "a plane faces the sensor");
    require(plane.covariance.allFinite(), "a plane's covariance is finite");
    require(plane.id != 0 && plane.sample_count > 0, "a plane has an id and samples");
    require(plane.first_vertex + plane.vertex_count <= result.planes.vertices.size(),
            "a plane has its boundary");
  }
  for (const Eigen::Vector3f& vertex : result.planes.vertices) {
    require(vertex.allFinite(), "a vertex of a plane is finite");
  }
  const auto& occupied = result.occupancy.cells();
  const auto& inflated = result.inflated.cells();
  require(occupied.size() == inflated.size(), "both grids have the same size");
  for (std::size_t k = 0; k < occupied.size(); ++k) {
    require(occupied[k] <= inflated[k], "an occupied cell is inflated");
  }
  const occupancy::ObservedCells& observed = result.observed;
  require(observed.floor.size() == observed.hit.size(), "what is observed has one size");
  if (result.floor.status != perception::FloorStatus::kNotFound &&
      result.products.has(perception::Product::kLookedThrough))
    require(observed.floor.size() == occupied.size() && observed.free.size() == occupied.size(),
            "and it is the grid's");
  for (std::size_t k = 0; k < observed.hit.size(); ++k)
    require(observed.hit[k] == 0 || occupied[k] != 0, "where something was hit the cell is occupied");
  if (result.products.has(perception::Product::kScan)) {
    require(result.scan.ranges.size() == result.scan.bins.count && result.scan.bins.count > 0,
            "a scan has a range for each bin");
    for (const float range : result.scan.ranges)
      require(!(range < 0.0F) &&
                  (!std::isfinite(range) || range <= 1.001F * static_cast<float>(result.scan.range_max)),
              "a range is within the scan's limits");
  }
  for (const geometry::PolygonSet::Ring& ring : result.polygons.rings) {
    require(ring.size >= 3, "a ring has three vertices");
    require(ring.first + ring.size <= result.polygons.vertices.size(), "a ring has its vertices");
  }
  for (const Eigen::Vector2d& vertex : result.polygons.vertices) {
    require(vertex.allFinite(), "a vertex is finite");
  }
}

}  // namespace polygonal_perception::test
