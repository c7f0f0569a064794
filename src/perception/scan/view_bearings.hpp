#pragma once

#include "polygonal_perception/perception/scan/floor_scanner.hpp"

namespace polygonal_perception::perception {

/// The bearings in which a view sees anything at all, counter-clockwise from first to last; as wide as a whole turn where
/// it looks straight down or up, or where nobody knows.
struct ViewBearings
{
  double first, last;  ///< [rad] first <= last, each up to a turn
};
ViewBearings viewBearings(const FloorScanner::View& view);

/// How many rows of a view make a band in which the bearing of each column changes by less than `most` [rad], within limits.
std::uint32_t rowsOfOneBearing(const FloorScanner::View& view, double most);

/// What a view can see of the floor.
class ViewOnFloor
{
public:
  explicit ViewOnFloor(const FloorScanner::View& view);

  /// A part of a ray from the floor frame's origin: distances [m]; from > to: nothing.
  struct Part
  {
    double from, to;
  };
  Part along(double bearing) const;

private:
  bool is_known_;
  // A place (x, y) of the floor is in view where all products of a row with (x, y, 1) are positive: it is ahead, and
  // within each border of the image.
  Eigen::Matrix<double, 5, 3> sides_;
};

}  // namespace polygonal_perception::perception
