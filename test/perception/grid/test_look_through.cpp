#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "polygonal_perception/perception/grid/look_through.hpp"
#include "support/projection_scene.hpp"

namespace polygonal_perception::perception {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t kWidth = 160;
constexpr std::uint32_t kHeight = 120;

/// A camera 0.8 m above the floor before a wall, with a box on the floor between them.
class WallView
{
public:
  explicit WallView(double wall) : wall_(wall)
  {
    for (std::uint32_t k = 0; k < kWidth * kHeight; ++k) depth_.push_back(depthOf(k % kWidth, k / kWidth));
    for (std::uint32_t k = 0; k < depth_.size(); ++k)
      cloud_.push_back({pointOf(k).x(), pointOf(k).y(), pointOf(k).z(), 0.0F});
    for (const float z : depth_) millimetres_.push_back(static_cast<std::uint16_t>(std::lround(1000.0F * z)));
  }

  PointView metres() const { return PointView::depth(depth_.data(), kWidth * sizeof(float), rays_); }
  PointView millimetres() const
  {
    return PointView::depth(millimetres_.data(), kWidth * sizeof(std::uint16_t), rays_);
  }
  PointView cloud() const { return PointView::points(cloud_.data(), kWidth, kHeight); }
  Eigen::Matrix3f pixels() const { return rays_.pixelOfDirection(); }

  void blind() { depth_.assign(depth_.size(), kNaN); }
  /// Points that lie where no pixel looks.
  void scatter()
  {
    for (test::PackedPoint& point : cloud_) std::swap(point.x, point.y);
  }

  /// Of the middle of a slab: whether it is in view, how far ahead of it the wall or the floor is along its ray.
  struct Truth
  {
    bool is_in_view;
    double behind;  // [m]
  };
  Truth truth(const Eigen::Vector3d& middle) const
  {
    const Eigen::Vector3d q = to_floor_.inverse() * middle;
    const double u = 130.0 * q.x() / q.z() + 80.0;
    const double v = 130.0 * q.y() / q.z() + 60.0;
    const bool is_in_view = q.z() > 0.0 && u > 0.0 && u < kWidth - 1.0 && v > 0.0 && v < kHeight - 1.0;
    return {is_in_view, (surfaceAlong(q) - 1.0) * q.norm()};
  }

private:
  /// How many times as far as a direction reaches the floor or the wall is.
  double surfaceAlong(const Eigen::Vector3d& direction) const
  {
    const Eigen::Vector3d ray = to_floor_.linear() * direction;
    const Eigen::Vector3d camera = to_floor_.translation();
    double nearest = (wall_ - camera.x()) / ray.x();
    if (ray.z() < 0.0) nearest = std::min(nearest, -camera.z() / ray.z());
    return nearest;
  }
  float depthOf(std::uint32_t u, std::uint32_t v) const
  {
    return static_cast<float>(surfaceAlong({rays_.column_slope[u], rays_.row_slope[v], 1.0}));
  }
  Eigen::Vector3f pointOf(std::uint32_t k) const
  {
    return depth_[k] * Eigen::Vector3f(rays_.column_slope[k % kWidth], rays_.row_slope[k / kWidth], 1.0F);
  }

  Eigen::Isometry3d to_floor_ = test::tiltedCamera();
  PinholeRays rays_ = PinholeRays::make(kWidth, kHeight, 130.0, 130.0, 80.0, 60.0);
  double wall_;
  std::vector<float> depth_;
  std::vector<std::uint16_t> millimetres_;
  std::vector<test::PackedPoint> cloud_;
};

const occupancy::GridGeometry kGrid{occupancy::GridParameters{}};

std::vector<std::uint8_t> look(const PointView& points, const std::optional<Eigen::Matrix3f>& pixels)
{
  const Projection::Parameters heights;
  std::vector<std::uint8_t> free;
  LookThrough(*SensorNoise::preset("xtion"))
      .look(points, pixels, test::tiltedCamera(), {kGrid, heights, nullptr}, free);
  return free;
}

template <class Visit>
void forEachSlab(const std::vector<std::uint8_t>& free, Visit&& visit)
{
  const Projection::Parameters heights;
  for (int j = 0; j < kGrid.cells_y; ++j) {
    for (int i = 0; i < kGrid.cells_x; ++i) {
      for (int k = 0; k < occupancy::ObservedCells::kSlabs; ++k) {
        const Eigen::Vector3d middle(kGrid.origin_x + (i + 0.5) * kGrid.resolution,
                                     kGrid.origin_y + (j + 0.5) * kGrid.resolution,
                                     heights.min_height + (k + 0.5) * heights.slabHeight());
        visit(middle, (free[static_cast<std::size_t>(j * kGrid.cells_x + i)] >> k & 1) != 0);
      }
    }
  }
}

TEST(LookThrough, IsFreeWhatHasTheFloorOrTheWallWellBehindIt)
{
  const WallView view(3.02);
  for (const PointView& points : {view.metres(), view.millimetres(), view.cloud()}) {
    int free_slabs = 0;
    forEachSlab(look(points, view.pixels()), [&](const Eigen::Vector3d& middle, bool is_free) {
      const WallView::Truth truth = view.truth(middle);
      free_slabs += is_free ? 1 : 0;
      // 5 cm to a slab's corner, 3 sigma of noise, and what a pixel's width is worth on a slanted floor.
      if (truth.behind < 0.04) {
        EXPECT_FALSE(is_free) << middle.transpose();
      }
      if (truth.is_in_view && truth.behind > 0.2) {
        EXPECT_TRUE(is_free) << middle.transpose();
      }
      if (!truth.is_in_view && middle.x() < 0.3) {
        EXPECT_FALSE(is_free) << middle.transpose();
      }
    });
    EXPECT_GT(free_slabs, 10000);
  }
}

TEST(LookThrough, WhereNothingIsSeenNothingIsLookedThrough)
{
  WallView view(3.02);
  view.blind();
  for (const std::uint8_t bits : look(view.metres(), view.pixels())) ASSERT_EQ(bits, 0);
}

TEST(LookThrough, WithoutKnowingWherePixelsLookNothingIsFree)
{
  for (const std::uint8_t bits : look(WallView(3.02).cloud(), std::nullopt)) ASSERT_EQ(bits, 0);
}

TEST(LookThrough, PointsThatLieElsewhereThanTheirPixelsLookTellNothing)
{
  WallView view(3.02);
  const auto freeCells = [&] {
    int cells = 0;
    for (const std::uint8_t bits : look(view.cloud(), view.pixels())) cells += bits != 0 ? 1 : 0;
    return cells;
  };
  const int as_it_is = freeCells();
  view.scatter();
  // On the image's diagonal the two are the same.
  EXPECT_LT(freeCells(), as_it_is / 6);
  EXPECT_GT(as_it_is, 2000);
}

TEST(LookThrough, PointsBeyondMaxRangeAreNone)
{
  const WallView view(3.02);
  for (const PointView& points : {view.metres(), view.millimetres(), view.cloud()}) {
    forEachSlab(look(points.within({0.01, 1.5}), view.pixels()),
                [&](const Eigen::Vector3d& middle, bool is_free) {
                  if ((test::tiltedCamera().translation() - middle).norm() > 1.5) {
                    ASSERT_FALSE(is_free) << middle.transpose();
                  }
                });
  }
}

}  // namespace
}  // namespace polygonal_perception::perception
