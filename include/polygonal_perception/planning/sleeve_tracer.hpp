#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/planning/free_space.hpp"
#include "polygonal_perception/planning/sleeve.hpp"

namespace polygonal_perception::planning {

/// Finds the sleeve of a line that was drawn among other obstacles than those that are there now. Where it cuts one, the
/// sleeve goes round it on the side where the border is shorter.
class POLYGONAL_PERCEPTION_EXPORT SleeveTracer
{
public:
  /// @param line    [m] from the start's point to the goal's
  /// @param sleeve  replaced
  /// @return false: it has none, for it cuts an obstacle that fills the way from wall to wall, or bends exactly in a vertex
  bool trace(const FreeSpace& space, const FreePlace& start, const FreePlace& goal,
             const std::vector<Eigen::Vector2d>& line, Sleeve& sleeve);

private:
  /// An edge that the line crosses, free or not, and where.
  struct Crossing
  {
    std::uint32_t half_edge;
    Eigen::Vector2d place;
  };
  /// A way along a border, on free ground.
  struct Detour
  {
    std::vector<std::uint32_t> crossed;
    double length = 0.0;  // [m]
  };

  std::optional<std::uint32_t> firstTriangle(const FreeSpace& space, const FreePlace& start,
                                             const Eigen::Vector2d& towards) const;
  bool crossTriangles(const geometry::TriangleMesh& mesh, std::uint32_t first, std::uint32_t last,
                      const std::vector<Eigen::Vector2d>& line);
  bool goRound(const FreeSpace& space, const Crossing& entry, const Crossing& exit, Sleeve& sleeve);
  static bool followBorder(const FreeSpace& space, const Crossing& entry, const Crossing& exit, bool forward,
                           Detour& detour);

  std::vector<Crossing> crossings_;
  Detour forward_;
  Detour backward_;
};

}  // namespace polygonal_perception::planning
