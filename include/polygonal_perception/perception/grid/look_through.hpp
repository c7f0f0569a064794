#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"
#include "polygonal_perception/perception/grid/ground_map.hpp"
#include "polygonal_perception/perception/grid/projection.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"
#include "polygonal_perception/perception/input/sensor_noise.hpp"

namespace polygonal_perception::perception {

/// Finds the heights of each cell that the camera looked through: what a map needs to forget an obstacle. A map that
/// forgets by the floor alone loses the seat of a chair whose legs stand apart.
///
/// The middle of each slab of a cell is looked up in the image. It was looked through where the pixel there sees
/// something behind it, by more than the slab reaches and noise can tell.
class POLYGONAL_PERCEPTION_EXPORT LookThrough
{
public:
  /// The cells, and the heights of their slabs.
  struct Cells
  {
    const occupancy::GridGeometry& geometry;
    const Projection::Parameters& heights;
    const GroundMap* ground;  ///< that heights count from; null: the floor
  };

  explicit LookThrough(const SensorNoise& noise) : noise_(noise) {}

  /// @param pixels          from a direction in the input's frame to (u, v, 1) up to a positive factor; nothing: nobody
  ///                        knows, and nothing was looked through
  /// @param to_floor_frame  from the input's frame
  /// @param free            set anew: for each cell a bit a slab, as in ObservedCells
  void look(const PointView& points, const std::optional<Eigen::Matrix3f>& pixels,
            const Eigen::Isometry3d& to_floor_frame, const Cells& cells,
            std::vector<std::uint8_t>& free) const;

private:
  SensorNoise noise_;
};

}  // namespace polygonal_perception::perception
