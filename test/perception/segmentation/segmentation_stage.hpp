#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "polygonal_perception/perception/floor/floor_detector.hpp"
#include "polygonal_perception/perception/floor/floor_tracker.hpp"
#include "polygonal_perception/perception/planes/sample_grid.hpp"
#include "polygonal_perception/perception/segmentation/plane_segmentation.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::test {

/// Looks at frames, the floor first.
struct Stage
{
  explicit Stage(const perception::PlaneSegmentation::Parameters& parameters = {}) : segmentation(parameters)
  {
  }

  /// @param up  none: that of the floor, if there is one
  const std::vector<perception::SegmentedPlane>& see(const PlaneScene& scene,
                                                     const std::optional<Eigen::Vector3d>& up = {})
  {
    stamp += 0.1;
    const perception::PointView points = scene.view();
    grid.update(points);
    const perception::FloorState& floor = tracker.update(points, grid, stamp, {up, {}, {}});
    segmentation.segment(
        points, grid, tracker.detector(), floor,
        !up && floor.status == perception::FloorStatus::kFound ? floor.floor.plane.normal : up, seen);
    return seen.planes;
  }

  std::vector<Eigen::Vector3d> boundaryOf(const perception::SegmentedPlane& plane) const
  {
    std::vector<Eigen::Vector3d> ring;
    for (std::uint32_t k = 0; k < plane.vertex_count; ++k)
      ring.push_back(seen.vertices.at(plane.first_vertex + k).cast<double>());
    return ring;
  }

  perception::SampleGrid grid{perception::SampleGrid::Parameters{}};
  perception::FloorTracker tracker{perception::FloorTracker::Parameters{},
                                   perception::FloorDetector::Parameters{}};
  perception::PlaneSegmentation segmentation;
  perception::SegmentedPlanes seen;
  double stamp = 0.0;
};

}  // namespace polygonal_perception::test
