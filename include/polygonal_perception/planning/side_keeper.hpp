#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/planning/free_space.hpp"
#include "polygonal_perception/planning/sleeve.hpp"
#include "polygonal_perception/planning/sleeve_tracer.hpp"
#include "polygonal_perception/planning/taut_path.hpp"

namespace polygonal_perception::planning {

/// Paths on the same side of each obstacle as an earlier one, though obstacles and start have moved since. Of a path a guide
/// is kept: a line through the same triangles, drawn off the corners, so that it stays clear of what moves by a little.
class POLYGONAL_PERCEPTION_EXPORT SideKeeper
{
public:
  /// [m] How far a guide keeps from corners, where there is room for it. Polygons are drawn anew in each frame, and their
  /// borders move by a cell or two (0.05 to 0.1 m). Where a border has passed the guide nevertheless, it is led round on the
  /// shorter side, which is nearly always right. doc/side_ablation.md has what
  /// other values do.
  static constexpr double kClearance = 0.25;

  /// @param path   through the sleeve
  /// @param guide  [m] replaced
  static void makeGuide(const geometry::TriangleMesh& mesh, const Sleeve& sleeve,
                        const std::vector<Eigen::Vector2d>& path, std::vector<Eigen::Vector2d>& guide);

  /// The shortest path on the guide's side of each obstacle.
  /// @param guide   what lies before its point nearest to the start has been passed
  /// @param path    replaced
  /// @param sleeve  replaced by that of the path
  /// @return its length [m]; nothing where the way is blocked, or there is no guide
  std::optional<double> follow(const FreeSpace& space, const FreePlace& start, const FreePlace& goal,
                               const std::vector<Eigen::Vector2d>& guide, std::vector<Eigen::Vector2d>& path,
                               Sleeve& sleeve);

private:
  std::vector<Eigen::Vector2d> line_;
  SleeveTracer tracer_;
  TautPath taut_path_;
};

}  // namespace polygonal_perception::planning
