#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/mapping/observation.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"

namespace polygonal_perception::mapping {

/// What stands around a robot, remembered: a square of cells that rolls with it, on a lattice that stands still in a frame
/// that does not jump (odom). It is the map over time that section VI of the paper promises.
///
/// An obstacle comes with one frame that sees it. It goes only where the floor was seen under it, and the heights at which
/// it was seen were looked through, each in clear_views frames since it was seen last: so the seat of a chair stays
/// whose legs stand apart, a leg that is seen in every third frame, and all that is out of view.
class POLYGONAL_PERCEPTION_EXPORT RollingMap
{
public:
  struct Parameters
  {
    double map_size = 12.0;  ///< [m] side of the square
    /// One or two frames that look through a thin leg are noise; a person is gone a tenth of a second after. See doc/map.md.
    int clear_views = 3;
    double remember = std::numeric_limits<double>::infinity();  ///< [s] after which an obstacle goes unseen

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      visit("map_size", self.map_size, parameters::Range{1.0, 100.0}, "m",
            "Side of the square around the robot that is remembered.");
      visit(
          "clear_views", self.clear_views, parameters::Range{1, 100}, "",
          "In how many frames the floor under an obstacle must be seen, and the heights at which it was seen "
          "looked through, before it goes.");
      visit("remember", self.remember, parameters::Range{0.1, std::numeric_limits<double>::infinity()}, "s",
            "An obstacle that has not been seen for so long goes, whatever is there.");
    }
  };

  explicit RollingMap(const Parameters& parameters) : parameters_(parameters) {}

  /// Takes on new parameters. Of another map_size what lies in both squares stays.
  void configure(const Parameters& parameters);

  /// Cells of a side: where they are so small that map_size has more, the square is smaller.
  static constexpr double kMostCells = 3000.0;

  /// Forgets everything, and takes on a resolution [m].
  void reset(double resolution);
  /// False until a resolution is known.
  bool isActive() const { return cells_ > 0; }

  /// Rolls so that a place [m] is in the middle cell. What leaves the square is forgotten.
  void moveTo(const Eigen::Vector2d& middle);

  /// Takes in a frame. What lies beyond the square counts for nothing.
  void add(const Observation& observation);

  /// Forgets what has not been seen for `remember` before a stamp [s].
  void forgetOld(double stamp);

  /// Of the square, in the map's frame. The origin is a multiple of the resolution.
  occupancy::GridGeometry geometry() const;

  /// @param occupied  set anew: 1 where an obstacle is remembered
  void copyOccupied(occupancy::BinaryGrid& occupied) const;
  /// @param seen  set anew, in the order of the grid: 1 where the floor was seen
  void copySeen(std::vector<std::uint8_t>& seen) const;
  /// @param heights  set anew: of each cell the slabs in which something stands
  void copyHeights(std::vector<std::uint8_t>& heights) const;

  /// Puts back what was copied.
  /// @param stamp  [s] when it is taken to be seen
  void restore(const occupancy::GridGeometry& geometry, const std::vector<std::uint8_t>& heights,
               const std::vector<std::uint8_t>& seen, double stamp);

private:
  static constexpr int kSlabs = 8;

  /// How an obstacle is on its way to be forgotten.
  struct Views
  {
    std::uint32_t frame = 0;          // in which anything was last seen here
    float stamp = 0.0F;               // [s] the same, since first_stamp_
    std::uint8_t floor = 0;           // frames that have seen the floor since then
    std::uint8_t looks[kSlabs] = {};  // and those that have looked through each slab
  };

  /// Where cell (x, y) of the lattice is stored: the square is a torus.
  std::size_t at(int x, int y) const
  {
    return static_cast<std::size_t>(wrapped(y)) * static_cast<std::size_t>(cells_) +
           static_cast<std::size_t>(wrapped(x));
  }
  int wrapped(int k) const
  {
    const int rest = k % cells_;
    return rest < 0 ? rest + cells_ : rest;
  }
  /// Calls visit(first, at, count) for each run of cells that lie in a row of the map and of the memory: in the grid from
  /// `first` on, in the memory from `at`.
  template <class Visit>
  void visitRuns(Visit&& visit) const;
  void forgetStrip(int from, int to, bool is_column);

  void mark(const Observation& observation);
  void clear(const Observation& observation);
  struct Steps;
  void clearRow(const Observation& observation, int x0, int y, const Eigen::Vector2d& first,
                const Eigen::Vector2d& step, const Steps& inside);
  void lookAt(std::size_t cell, std::uint8_t free, bool is_floor_seen);

  Parameters parameters_;
  double resolution_ = 0.05;
  int cells_ = 0;                  // of a side
  int first_x_ = 0, first_y_ = 0;  // on the lattice: of the square's corner
  // A number a cell.
  std::vector<std::uint8_t> heights_;  // bit k: something stands in the slab k
  std::vector<std::uint8_t> seen_;     // 1: the floor was seen
  std::vector<Views> views_;           // of the obstacles
  std::uint32_t frame_ = 0;
  double first_stamp_ = 0.0;
  double newest_stamp_ = 0.0;
};

}  // namespace polygonal_perception::mapping
