#include "polygonal_perception/perception/grid/look_through.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace polygonal_perception::perception {

namespace {

constexpr int kSlabs = occupancy::ObservedCells::kSlabs;

/// Noise moves what is seen behind a slab into it, or through it, once in 40 times. More sigmas leave ghosts 4 m away for some
/// frames longer; a point that stands in the cell counts more than any look through it.
constexpr float kSigmas = 2.0F;

/// The slabs of a cell in the image. A point's pixel (u, v) and how far ahead it lies are linear in its place, up to
/// the division: (u w, v w, w).
struct Column
{
  // The vector extensions that GCC and Clang share: one lane a slab.
  typedef float Floats __attribute__((vector_size(4 * kSlabs)));
  typedef std::int32_t Ints __attribute__((vector_size(4 * kSlabs)));

  Floats u, v, w;
  Ints inside;  // of the image: -1 or 0

  /// @param lowest  of the middle of the lowest slab, @param up  from slab to slab
  void set(const Eigen::Vector3f& lowest, const Eigen::Vector3f& up, float columns, float rows)
  {
    constexpr Floats kSlab = {0.0F, 1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F, 7.0F};
    w = lowest.z() + kSlab * up.z();
    const Floats inverse = 1.0F / w;
    u = (lowest.x() + kSlab * up.x()) * inverse + 0.5F;
    v = (lowest.y() + kSlab * up.y()) * inverse + 0.5F;
    // Written so that NaN fails.
    inside = (w > 0.0F) & (u >= 0.0F) & (u < columns) & (v >= 0.0F) & (v < rows);
  }
};

/// What pixels see, by how far ahead it lies; NaN or less where they see nothing.
class AnyImage
{
public:
  AnyImage(const PointView& points, const Eigen::Matrix3f& pixels) : points_(points), pixels_(pixels) {}

  /// Asks for the memory of a pixel that is looked at soon.
  void prefetch(float u, float v) const
  {
    points_.prefetch(static_cast<std::uint32_t>(u), static_cast<std::uint32_t>(v));
  }

  bool seesBehind(float u, float v, float w) const
  {
    return liesBehind(points_.point(static_cast<std::uint32_t>(u), static_cast<std::uint32_t>(v)), u, v, w);
  }

protected:
  /// Whether a point lies farther ahead than w, and on the ray of a pixel: a cloud's may lie anywhere.
  bool liesBehind(const Eigen::Vector3f& point, float u, float v, float w) const
  {
    constexpr float kNear = 1.5F;  // [px]
    const float ahead = pixels_.row(2).dot(point);
    return ahead > w && std::abs(pixels_.row(0).dot(point) - (u - 0.5F) * ahead) < kNear * ahead &&
           std::abs(pixels_.row(1).dot(point) - (v - 0.5F) * ahead) < kNear * ahead;
  }

  const PointView& points_;
  const Eigen::Matrix3f& pixels_;
};

/// A cloud none of whose points is left out by its range or its place.
class CloudImage : public AnyImage
{
public:
  using AnyImage::AnyImage;

  bool seesBehind(float u, float v, float w) const
  {
    const PointView::CloudStrides& strides = points_.strides();
    const std::uint8_t* const at =
        points_.row(static_cast<std::uint32_t>(v)) + static_cast<std::uint32_t>(u) * strides.point_step;
    Eigen::Vector3f point;
    std::memcpy(&point.x(), at + strides.x_offset, sizeof(float));
    std::memcpy(&point.y(), at + strides.y_offset, sizeof(float));
    std::memcpy(&point.z(), at + strides.z_offset, sizeof(float));
    return liesBehind(point, u, v, w);
  }
};

/// A depth image none of whose points is left out by its range or its place.
template <class Depth>
class DepthImage
{
public:
  explicit DepthImage(const PointView& points)
      : data_(points.row(0)), row_step_(points.strides().row_step), unit_(points.unit())
  {
  }

  // A depth image is small enough for the cache.
  void prefetch(float /*u*/, float /*v*/) const {}

  bool seesBehind(float u, float v, float w) const
  {
    Depth depth;
    std::memcpy(&depth,
                data_ + static_cast<std::size_t>(v) * row_step_ + static_cast<std::size_t>(u) * sizeof depth,
                sizeof depth);
    if constexpr (std::is_integral_v<Depth>)
      return depth != std::numeric_limits<Depth>::max() && unit_ * static_cast<float>(depth) > w;
    return depth > w && depth < std::numeric_limits<float>::infinity();
  }

private:
  const std::uint8_t* data_;
  std::size_t row_step_;
  float unit_;
};

/// A cell that is about to be looked at.
struct NextCell
{
  Column column{};
  float farther = 1.0F;          // that what is seen must lie so many times as far ahead
  std::uint8_t* free = nullptr;  // null: there is none
};

template <class Image>
void lookAt(const Image& image, const NextCell& cell)
{
  if (cell.free == nullptr) return;
  const Column& column = cell.column;
  unsigned bits = 0;
  for (int k = 0; k < kSlabs; ++k) {
    if (column.inside[k] != 0 && image.seesBehind(column.u[k], column.v[k], cell.farther * column.w[k]))
      bits |= 1U << k;
  }
  *cell.free = static_cast<std::uint8_t>(bits);
}

/// The middles of the slabs of all cells, as homogeneous pixels.
struct Slabs
{
  const LookThrough::Cells& cells;
  Eigen::Matrix3f pixel_of_place;  // of a direction in the floor frame
  Eigen::Vector3f offset;          // from the camera
  Eigen::Vector3f camera;          // [m] in the floor frame
  float slab;                      // [m]
  float columns, rows;             // of the image
  SensorNoise noise;
};

/// Whether a column between two homogeneous pixels lies wholly beyond one border of the image.
bool isBeside(const Eigen::Vector3f& a, const Eigen::Vector3f& b, float columns, float rows)
{
  constexpr float kHalf = 0.5F;  // a pixel reaches so far to each side
  const auto both = [&](auto&& is_beyond) { return is_beyond(a) && is_beyond(b); };
  return both([](const Eigen::Vector3f& p) { return p.z() <= 0.0F; }) ||
         both([](const Eigen::Vector3f& p) { return p.x() < -kHalf * p.z(); }) ||
         both([](const Eigen::Vector3f& p) { return p.y() < -kHalf * p.z(); }) ||
         both([&](const Eigen::Vector3f& p) { return p.x() > columns * p.z(); }) ||
         both([&](const Eigen::Vector3f& p) { return p.y() > rows * p.z(); });
}

template <class Image>
void lookAtAll(const Image& image, const Slabs& slabs, std::vector<std::uint8_t>& free)
{
  const occupancy::GridGeometry& geometry = slabs.cells.geometry;
  const auto side = static_cast<float>(geometry.resolution);
  const float to_corner = 0.5F * std::sqrt(2.0F * side * side + slabs.slab * slabs.slab);
  const float first = static_cast<float>(slabs.cells.heights.min_height) + 0.5F * slabs.slab;
  const Eigen::Vector3f up = slabs.slab * slabs.pixel_of_place.col(2);
  // A cloud's pixels lie all over the memory: those of the next cell are on their way while one is looked at.
  NextCell cells[2];
  unsigned turn = 0;
  // Across the view, not along it: cells side by side are looked up in the same rows of the image.
  for (int i = 0; i < geometry.cells_x; ++i) {
    for (int j = 0; j < geometry.cells_y; ++j) {
      const float x = static_cast<float>(geometry.origin_x) + (static_cast<float>(i) + 0.5F) * side;
      const float y = static_cast<float>(geometry.origin_y) + (static_cast<float>(j) + 0.5F) * side;
      const float ground = slabs.cells.ground != nullptr ? slabs.cells.ground->at(x, y).lower : 0.0F;
      const Eigen::Vector3f lowest(x, y, ground + first);
      const Eigen::Vector3f pixel = slabs.pixel_of_place * lowest + slabs.offset;
      if (isBeside(pixel, pixel + (kSlabs - 1.0F) * up, slabs.columns, slabs.rows)) continue;
      NextCell& next = cells[turn];
      turn = 1 - turn;
      next.column.set(pixel, up, slabs.columns, slabs.rows);
      for (int k = 0; k < kSlabs; ++k) {
        if (next.column.inside[k] != 0) image.prefetch(next.column.u[k], next.column.v[k]);
      }
      const float range = (lowest - slabs.camera).norm();
      next.farther = 1.0F + (to_corner + kSigmas * slabs.noise.at(range)) / range;
      next.free = free.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(geometry.cells_x) +
                  static_cast<std::size_t>(i);
      lookAt(image, cells[turn]);
    }
  }
  lookAt(image, cells[1 - turn]);
}

}  // namespace

void LookThrough::look(const PointView& points, const std::optional<Eigen::Matrix3f>& pixels,
                       const Eigen::Isometry3d& to_floor_frame, const Cells& cells,
                       std::vector<std::uint8_t>& free) const
{
  free.assign(cells.geometry.size(), 0);
  if (!pixels || points.size() == 0) return;
  const Eigen::Isometry3f from_floor = to_floor_frame.inverse().cast<float>();
  const Slabs slabs{cells,
                    *pixels * from_floor.linear(),
                    *pixels * from_floor.translation(),
                    to_floor_frame.translation().cast<float>(),
                    static_cast<float>(cells.heights.slabHeight()),
                    static_cast<float>(points.width()),
                    static_cast<float>(points.height()),
                    noise_};
  const bool is_whole = !points.leavesOut() && !points.isLimited();
  if (is_whole && points.layout() == PointLayout::kDepthUnits) {
    lookAtAll(DepthImage<std::uint16_t>(points), slabs, free);
  } else if (is_whole && points.layout() == PointLayout::kDepthMetres) {
    lookAtAll(DepthImage<float>(points), slabs, free);
  } else if (is_whole && points.layout() == PointLayout::kCloud) {
    lookAtAll(CloudImage(points, *pixels), slabs, free);
  } else {
    lookAtAll(AnyImage(points, *pixels), slabs, free);
  }
}

}  // namespace polygonal_perception::perception
