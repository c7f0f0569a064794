#include "polygonal_perception/perception/scan/floor_scanner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "perception/grid/nearest_standing.hpp"
#include "perception/scan/view_bearings.hpp"
#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::perception {

using geometry::kPi;

namespace {

/// The cells along a ray from the floor frame's origin.
class CellsAlong
{
public:
  CellsAlong(const occupancy::GridGeometry& geometry, double bearing)
      : geometry_(geometry), x_(std::cos(bearing)), y_(std::sin(bearing))
  {
  }

  /// The row-major index of the cell at a distance [m], or nothing beyond the grid.
  std::optional<std::size_t> at(double distance) const
  {
    return geometry_.cellOf(distance * x_, distance * y_);
  }

private:
  const occupancy::GridGeometry& geometry_;
  double x_, y_;
};

/// Whether anything is occupied in which nothing stands.
bool hasDrops(const occupancy::BinaryGrid& occupancy, const occupancy::ObservedCells& observed)
{
  std::size_t drops = 0;
  for (std::size_t cell = 0; cell < observed.hit.size(); ++cell)
    drops += static_cast<std::size_t>((occupancy.cells()[cell] != 0) & (observed.hit[cell] == 0));
  return drops > 0;
}

}  // namespace

FloorScanner::FloorScanner(const Parameters& parameters)
    : parameters_(parameters), nearest_(std::make_unique<NearestStanding>())
{
}

FloorScanner::FloorScanner(FloorScanner&& other) noexcept = default;
FloorScanner& FloorScanner::operator=(FloorScanner&& other) noexcept = default;
FloorScanner::~FloorScanner() = default;

void FloorScanner::cover(const View& view)
{
  constexpr double kStep = kPi / 18.0;
  const Parameters& p = parameters_;
  Span span{p.scan_angle_min, p.scan_angle_max};
  if (p.coversView()) {
    const ViewBearings bearings = viewBearings(view);
    if (!seen_) seen_ = Span{bearings.first, bearings.last};
    seen_->first = std::min(seen_->first, bearings.first);
    seen_->last = std::max(seen_->last, bearings.last);
    const bool is_behind = seen_->first < -kPi || seen_->last > kPi;
    span = {is_behind ? -kPi : std::max(-kPi, std::floor(seen_->first / kStep) * kStep),
            is_behind ? kPi : std::min(kPi, std::ceil(seen_->last / kStep) * kStep)};
  }
  // Of a whole turn the last bin would be the first once more.
  const double turn = 2.0 * kPi - p.scan_angle_increment;
  const double width = std::min(span.last - span.first, turn);
  constexpr double kRounding = 1e-6;
  bins_ = {span.first, p.scan_angle_increment,
           1 + static_cast<std::uint32_t>(width / p.scan_angle_increment + kRounding)};
}

NearestStanding& FloorScanner::beginFrame(const View& view, const FloorPointNoise& noise)
{
  nearest_->setUp(bins_, rowsOfOneBearing(view, 0.5 * bins_.increment), noise,
                  parameters_.scan_height_sigmas);
  return *nearest_;
}

void FloorScanner::makeUnknown(LevelScan& scan) const
{
  scan.bins = bins_;
  scan.range_max = parameters_.scan_range_max;
  scan.ranges.assign(bins_.count, std::numeric_limits<float>::quiet_NaN());
}

void FloorScanner::finishFrame(const View& view, const occupancy::BinaryGrid& occupancy,
                               const occupancy::ObservedCells& observed, LevelScan& scan) const
{
  makeUnknown(scan);
  const bool has_drops = hasDrops(occupancy, observed);
  const ViewOnFloor on_floor(view);
  const double range_max = parameters_.scan_range_max;
  for (std::uint32_t bin = 0; bin < bins_.count; ++bin) {
    double range = std::sqrt(static_cast<double>(nearest_->squared()[bin]));
    const double bearing = bins_.bearing(bin);
    const CellsAlong cells(occupancy.geometry(), bearing);
    const ViewOnFloor::Part visible = on_floor.along(bearing);
    bool is_seen = range > range_max && visible.from < range_max && visible.to >= range_max;
    for (double distance = visible.from; distance < std::min(range, range_max) && (is_seen || has_drops);
         distance += 0.5 * occupancy.geometry().resolution) {
      const auto cell = cells.at(distance);
      is_seen = is_seen && cell && observed.floor[*cell] != 0 && observed.hit[*cell] == 0;
      // A drop has no points that stand.
      if (cell && occupancy.cells()[*cell] != 0 && observed.hit[*cell] == 0) range = distance;
    }
    if (range <= range_max) {
      scan.ranges[bin] = static_cast<float>(range);
    } else if (is_seen) {
      scan.ranges[bin] = std::numeric_limits<float>::infinity();
    }
  }
}

}  // namespace polygonal_perception::perception
