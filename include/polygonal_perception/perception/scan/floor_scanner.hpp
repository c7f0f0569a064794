#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"
#include "polygonal_perception/occupancy/grid/observed_cells.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/perception/grid/height_noise.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"
#include "polygonal_perception/perception/scan/level_scan.hpp"

namespace polygonal_perception::perception {

class NearestStanding;

/// Makes of a frame what a laser would see that is level by the floor itself, however the camera is tilted.
class POLYGONAL_PERCEPTION_EXPORT FloorScanner
{
public:
  struct Parameters
  {
    double scan_angle_min = 0.0;            ///< [rad] of the first bin
    double scan_angle_max = 0.0;            ///< [rad] of the last one; both 0: what the camera can see
    double scan_angle_increment = 0.00873;  ///< [rad] half a degree
    double scan_range_max = 5.0;            ///< [m]
    /// The scan takes the nearest of some hundred pixels of a bin, so one wrong one in a million is seen: 4.5 standard
    /// deviations are min_height at 5 m for a camera at 0.8 m. doc/scan.md has what others lead to.
    double scan_height_sigmas = 6.0;

    /// Whether the angles are those that the camera can see.
    bool coversView() const { return scan_angle_min == 0.0 && scan_angle_max == 0.0; }

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      visit("scan_angle_min", self.scan_angle_min, parameters::Range{-3.1416, 3.1416}, "rad",
            "Direction of the scan's first bin in the floor frame; 0 as scan_angle_max, too: all that the "
            "camera "
            "can see.");
      visit("scan_angle_max", self.scan_angle_max, parameters::Range{-3.1416, 3.1416}, "rad",
            "Direction of the scan's last bin.");
      visit("scan_angle_increment", self.scan_angle_increment, parameters::Range{0.001, 0.2}, "rad",
            "From bin to bin.");
      visit("scan_range_max", self.scan_range_max, parameters::Range{0.1, 50.0}, "m",
            "How far the scan reaches; a bin is +inf, and clears, only if the floor is seen up to here.");
      visit(
          "scan_height_sigmas", self.scan_height_sigmas, parameters::Range{0.0, 20.0}, "",
          "What ends a bin is higher than so many standard deviations of the height of a floor point there.");
    }
  };

  /// Where the pixels of a view look.
  struct View
  {
    const PointView& points;
    /// From a direction in the input's frame to (u, v, 1) up to a positive factor; nothing: nobody knows.
    const std::optional<Eigen::Matrix3f>& pixels;
    const Eigen::Isometry3d& to_floor_frame;
  };

  explicit FloorScanner(const Parameters& parameters);
  FloorScanner(FloorScanner&& other) noexcept;
  FloorScanner& operator=(FloorScanner&& other) noexcept;
  ~FloorScanner();

  /// Makes room for what a view can see: bins are added where it sees farther round than all before it, in steps of ten
  /// degrees, so that those who read the scan seldom see its size change.
  void cover(const View& view);
  /// Forgets what views have seen.
  void reset() { seen_.reset(); }
  const BearingBins& bins() const { return bins_; }

  /// What the projection fills of a frame. Valid until the next call.
  /// @param noise  of points on the floor
  NearestStanding& beginFrame(const View& view, const FloorPointNoise& noise);

  /// @param observed   of the frame's grid
  /// @param occupancy  with what only drop_height finds
  void finishFrame(const View& view, const occupancy::BinaryGrid& occupancy,
                   const occupancy::ObservedCells& observed, LevelScan& scan) const;

  /// The scan where there is no floor: nobody knows anything.
  void makeUnknown(LevelScan& scan) const;

private:
  /// Bearings from the first to the last.
  struct Span
  {
    double first, last;
  };

  Parameters parameters_;
  std::optional<Span> seen_;  // by all views
  BearingBins bins_;
  std::unique_ptr<NearestStanding> nearest_;
};

}  // namespace polygonal_perception::perception
