#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "polygonal_perception/binary_grid.hpp"
#include "polygonal_perception/parameter_table.hpp"
#include "polygonal_perception/point_view.hpp"

namespace polygonal_perception {

/// Transforms every point of a frame into the floor frame and marks the cells of the grid in which something stands
/// (section IV).
class Projection
{
public:
  struct Parameters
  {
    double min_height = 0.03;      ///< [m] lower points are floor
    double max_height = 0.60;      ///< [m] higher points are nothing the robot could touch
    int min_points_per_cell = 1;   ///< a cell with fewer points stays free

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      visit("min_height", self.min_height, Range{-1.0, 5.0}, "m", "Points lower than this are floor.");
      visit("max_height", self.max_height, Range{0.0, 10.0}, "m",
            "Points higher than this are passed under by the robot.");
      visit("min_points_per_cell", self.min_points_per_cell, Range{1, 255}, "",
            "A cell with fewer points than this stays free.");
    }
  };

  explicit Projection(const Parameters& parameters) : parameters_(parameters) {}
  const Parameters& parameters() const { return parameters_; }

  /// Marks the cells that hold at least min_points_per_cell points p with min_height <= height(p) <= max_height.
  /// @param points          the frame; pixels without a return count for nothing
  /// @param to_floor_frame  from the input's frame into the floor frame
  /// @param occupancy       keeps its geometry; its cells are set anew
  void project(const PointView& points, const Eigen::Isometry3d& to_floor_frame, BinaryGrid& occupancy);

private:
  Parameters parameters_;
  std::vector<std::uint16_t> counts_;
};

}  // namespace polygonal_perception
