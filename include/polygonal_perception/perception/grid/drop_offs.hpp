#pragma once

#include <Eigen/Geometry>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/perception/grid/ground_map.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::perception {

/// Finds where the floor ends above something lower: stairs down, a ledge, a loading dock. The paper throws
/// away everything below the floor, so that a robot would drive down there; this stage marks the way to it as
/// an obstacle.
class POLYGONAL_PERCEPTION_EXPORT DropOffs
{
public:
  struct Parameters
  {
    double drop_height = 0.0;  ///< [m] 0 = off

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      visit("drop_height", self.drop_height, parameters::Range{0.0, 5.0}, "m",
            "A ray that ends more than this below the floor marks the cell where it crossed the floor as "
            "occupied; 0: "
            "drop-offs are not marked.");
    }
  };

  explicit DropOffs(const Parameters& parameters) : parameters_(parameters) {}
  const Parameters& parameters() const { return parameters_; }

  /// Marks the cells in which the rays to points far below the floor cross it. Every fourth pixel of every
  /// fourth row is looked at: at the grid's far end, 5 m, these are 3.5 cm apart across the view.
  /// @param to_floor_frame  from the input's frame, in whose origin the camera is, into the floor frame
  /// @param occupancy       cells are only ever added
  /// @param ground          that a drop counts from; null: the floor
  void mark(const PointView& points, const Eigen::Isometry3d& to_floor_frame,
            occupancy::BinaryGrid& occupancy, const GroundMap* ground = nullptr) const;

private:
  Parameters parameters_;
};

}  // namespace polygonal_perception::perception
