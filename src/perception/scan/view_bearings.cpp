#include "perception/scan/view_bearings.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::perception {

using geometry::kPi;

ViewBearings viewBearings(const FloorScanner::View& view)
{
  constexpr ViewBearings kAll{-kPi, kPi};
  if (!view.pixels) return kAll;
  // A view is the cone of its four corners, and so is its shadow on the floor.
  const Eigen::Matrix3d look = view.to_floor_frame.linear() * view.pixels->cast<double>().inverse();
  const double right = view.points.width() - 0.5;
  const double bottom = view.points.height() - 0.5;
  std::array<double, 4> bearings{};
  std::size_t k = 0;
  for (const double u : {-0.5, right}) {
    for (const double v : {-0.5, bottom}) {
      const Eigen::Vector3d along = look * Eigen::Vector3d(u, v, 1.0);
      bearings.at(k++) = std::atan2(along.y(), along.x());
    }
  }
  std::sort(bearings.begin(), bearings.end());
  // The shadow is on the other side of the widest gap, or everywhere where no half of the directions is free of it.
  double widest = bearings.front() + 2.0 * kPi - bearings.back();
  ViewBearings seen{bearings.front(), bearings.back()};
  for (std::size_t i = 1; i < bearings.size(); ++i) {
    const double gap = bearings.at(i) - bearings.at(i - 1);
    if (gap <= widest) continue;
    widest = gap;
    seen = {bearings.at(i), bearings.at(i - 1) + 2.0 * kPi};
  }
  return widest > kPi ? seen : kAll;
}

std::uint32_t rowsOfOneBearing(const FloorScanner::View& view, double most)
{
  // Where it looks straight down bearings go all round within a few rows.
  constexpr std::uint32_t kMostBands = 120;
  const std::uint32_t fewest_rows = std::max(1U, view.points.height() / kMostBands);
  if (!view.pixels) return fewest_rows;
  const Eigen::Matrix3d look = view.to_floor_frame.linear() * view.pixels->cast<double>().inverse();
  double most_per_row = 1e-9;
  for (const double u : {0.0, 1.0}) {
    for (const double v : {0.0, 0.5, 1.0}) {
      const Eigen::Vector3d along =
          look * Eigen::Vector3d(u * view.points.width(), v * view.points.height(), 1.0);
      // Of the bearing by v: the cross product with what a row adds, over the square.
      const double per_row =
          (along.x() * look(1, 1) - along.y() * look(0, 1)) / along.head<2>().squaredNorm();
      most_per_row = std::max(most_per_row, std::abs(per_row));
    }
  }
  const double rows = std::min(most / most_per_row, static_cast<double>(view.points.height()));
  return std::max(fewest_rows, static_cast<std::uint32_t>(rows));
}

ViewOnFloor::ViewOnFloor(const FloorScanner::View& view) : is_known_(view.pixels.has_value())
{
  if (!is_known_) return;
  const Eigen::Isometry3d back = view.to_floor_frame.inverse();
  Eigen::Matrix3d place;  // (x, y, 1) to the input's frame
  place << back.linear().leftCols<2>(), back.translation();
  Eigen::Matrix<double, 5, 3> borders;
  borders << 0.0, 0.0, 1.0,                  //
      1.0, 0.0, 0.5,                         //
      0.0, 1.0, 0.5,                         //
      -1.0, 0.0, view.points.width() - 0.5,  //
      0.0, -1.0, view.points.height() - 0.5;
  sides_ = borders * view.pixels->cast<double>() * place;
}

ViewOnFloor::Part ViewOnFloor::along(double bearing) const
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Part part{0.0, is_known_ ? kInfinity : -kInfinity};
  if (!is_known_) return part;
  const Eigen::Matrix<double, 5, 1> slopes =
      sides_.leftCols<2>() * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
  for (Eigen::Index k = 0; k < sides_.rows(); ++k) {
    const double offset = sides_(k, 2);
    if (slopes(k) > 0.0) {
      part.from = std::max(part.from, -offset / slopes(k));
    } else if (slopes(k) < 0.0) {
      part.to = std::min(part.to, -offset / slopes(k));
    } else if (offset < 0.0) {
      part.to = -kInfinity;
    }
  }
  return part;
}

}  // namespace polygonal_perception::perception
