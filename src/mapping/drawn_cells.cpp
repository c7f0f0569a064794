#include "mapping/drawn_cells.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace polygonal_perception::mapping {

namespace {

constexpr double kRounding = 1e-6;  // [cells] of a place

/// Draws edges that are given in cells from the corner of the grid.
class Drawing
{
public:
  explicit Drawing(DrawnCells& drawn)
      : columns_(drawn.geometry.cells_x),
        rows_(drawn.geometry.cells_y),
        cells_(drawn.cells),
        turns_(drawn.cells.size(), 0)
  {
  }

  void add(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
  {
    markAlong(a.y() < b.y() ? a : b, a.y() < b.y() ? b : a);
    countCrossings(a, b);
  }

  /// Fills what the edges enclose.
  void fill()
  {
    for (std::size_t row = 0; row < cells_.size(); row += static_cast<std::size_t>(columns_)) {
      std::uint8_t inside = 0;
      for (std::size_t cell = row; cell < row + static_cast<std::size_t>(columns_); ++cell) {
        inside ^= turns_[cell];
        cells_[cell] |= inside;
      }
    }
  }

private:
  std::size_t at(int i, int j) const
  {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }
  static int clamped(double place, int size)
  {
    return static_cast<int>(std::clamp(std::floor(place), 0.0, size - 1.0));
  }

  /// All cells that the edge touches, row by row.
  void markAlong(const Eigen::Vector2d& low, const Eigen::Vector2d& high)
  {
    const double height = high.y() - low.y();
    const int last = clamped(high.y() + kRounding, rows_);
    for (int j = clamped(low.y() - kRounding, rows_); j <= last; ++j) {
      // An edge that lies along the row passes through it from end to end.
      const bool is_flat = height < kRounding;
      const double from = is_flat ? 0.0 : std::clamp((j - kRounding - low.y()) / height, 0.0, 1.0);
      const double to = is_flat ? 1.0 : std::clamp((j + 1 + kRounding - low.y()) / height, 0.0, 1.0);
      const double x0 = low.x() + from * (high.x() - low.x());
      const double x1 = low.x() + to * (high.x() - low.x());
      const int end = clamped(std::max(x0, x1) + kRounding, columns_);
      for (int i = clamped(std::min(x0, x1) - kRounding, columns_); i <= end; ++i) cells_[at(i, j)] = 1;
    }
  }

  /// Along the line through the middles of each row a polygon begins or ends where an edge crosses it. Rounding may take the
  /// cell beside: then the edge runs through its middle, and it is marked anyway.
  void countCrossings(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
  {
    const int first = std::max(0, static_cast<int>(std::ceil(std::min(a.y(), b.y()) - 0.5)));
    for (int j = first; j < rows_ && j + 0.5 < std::max(a.y(), b.y()); ++j) {
      const double x = a.x() + (j + 0.5 - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      const double i = std::max(0.0, std::ceil(x - 0.5));
      if (i < columns_) turns_[at(static_cast<int>(i), j)] ^= 1;
    }
  }

  int columns_, rows_;
  std::vector<std::uint8_t>& cells_;
  std::vector<std::uint8_t>
      turns_;  // 1: from this cell's middle on it is inside that was outside, or the reverse
};

}  // namespace

std::variant<DrawnCells, MapFileError> drawCells(const geometry::PolygonSet& polygons, double resolution)
{
  constexpr double kMostCells = 4e6;
  constexpr double kMostAlongEdges = 2e7;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& vertex : polygons.vertices) box.extend(vertex / resolution);
  if (box.isEmpty()) box.extend(Eigen::Vector2d::Zero());
  const Eigen::Vector2d corner = (box.min().array() - kRounding).floor();
  const Eigen::Vector2d size = (box.max().array() + kRounding).floor() + 1.0 - corner.array();
  if (!(size.prod() <= kMostCells)) return MapFileError{"the polygons reach over more than 4e6 cells"};

  const auto forEachEdge = [&](auto&& visit) {
    for (const geometry::PolygonSet::Ring& ring : polygons.rings) {
      for (const auto [from, to] : polygons.view(ring).edges())
        visit(from / resolution - corner, to / resolution - corner);
    }
  };
  double along_edges = 0.0;
  forEachEdge(
      [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { along_edges += (b - a).lpNorm<1>(); });
  if (!(along_edges <= kMostAlongEdges))
    return MapFileError{"the edges of the polygons run through more than 2e7 cells"};

  DrawnCells drawn;
  drawn.geometry.resolution = resolution;
  drawn.geometry.origin_x = corner.x() * resolution;
  drawn.geometry.origin_y = corner.y() * resolution;
  drawn.geometry.cells_x = static_cast<int>(size.x());
  drawn.geometry.cells_y = static_cast<int>(size.y());
  drawn.cells.assign(drawn.geometry.size(), 0);
  Drawing drawing(drawn);
  forEachEdge([&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { drawing.add(a, b); });
  drawing.fill();
  return drawn;
}

}  // namespace polygonal_perception::mapping
