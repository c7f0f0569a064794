#pragma once

#include <cstdint>
#include <vector>

#include "perception/grid/projection_kernel.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"
#include "polygonal_perception/perception/grid/bearing_bins.hpp"
#include "polygonal_perception/perception/grid/height_noise.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::perception {

/// The nearest point that stands in each direction along the floor, found as a frame goes through the projection.
///
/// Most pixels are compared with those above them alone: of each column of a band of some rows the nearest is kept,
/// and only those are looked up by their bearing. A band is so low that a column's bearing hardly changes within it.
class NearestStanding
{
public:
  /// To be called before a frame is projected.
  /// @param rows_per_band  in which the bearing of a column changes by less than a bin
  /// @param noise   of points on the floor
  /// @param sigmas  a point must be higher than so many standard deviations of a floor point's height there
  void setUp(const BearingBins& bins, std::uint32_t rows_per_band, const FloorPointNoise& noise,
             double sigmas);

  /// The projection calls these. First: null: all points count; else those in cells that are occupied when the frame is
  /// finished.
  void countIn(const occupancy::BinaryGrid* occupancy) { occupancy_ = occupancy; }
  /// Turns to a frame.
  /// @return what its rows are to fill
  NearestLanes begin(const ProjectionKernel& kernel, const PointView& points);
  /// To be called after row v.
  void endRow(std::uint32_t v)
  {
    if (v + 1 < band_end_) return;
    endBand();
    if (occupancy_ == nullptr) lookUp();
  }
  void finish()
  {
    endBand();
    lookUp();
  }

  /// [m^2] Squared distances along the floor from the sensor, by bin; infinite where nothing stands.
  const std::vector<float>& squared() const { return squared_; }

private:
  void endBand();
  void lookUp();

  const ProjectionKernel* kernel_ = nullptr;
  const occupancy::BinaryGrid* occupancy_ = nullptr;
  BinRule rule_{};
  std::size_t width_ = 0;  // with what fills up the last block
  std::uint32_t rows_per_band_ = 1;
  std::uint32_t band_end_ = 0;         // one past its last row
  std::vector<float> lanes_;           // of the band: squared, x, y, height, one after the other
  std::vector<std::uint8_t> changed_;  // by block
  std::size_t found_ = 0;              // and not looked up yet
  std::vector<float> x_, y_, height_;  // [m] of what was found, and room
  std::vector<std::int32_t> bin_;
  std::vector<float> squared_;
};

}  // namespace polygonal_perception::perception
