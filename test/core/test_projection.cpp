#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <ostream>
#include <random>
#include <string>

#include "polygonal_perception/floor_frame.hpp"
#include "polygonal_perception/projection.hpp"
#include "projection_kernel.hpp"
#include "reference_projection.hpp"

namespace polygonal_perception {

void PrintTo(const ProjectionKernel& kernel, std::ostream* out)
{
  *out << kernel.name;
}

namespace {

/// A camera 0.8 m above the floor that looks 20 degrees down, in an optical frame.
Eigen::Isometry3d tiltedCamera(double height = 0.8)
{
  const double pitch = 0.35;
  return floorFrame(Plane{Eigen::Vector3d(0.0, -std::cos(pitch), -std::sin(pitch)), height},
                    Eigen::Vector3d::UnitZ());
}

/// An upright camera frame: x ahead, y left, z up, on the floor.
Eigen::Isometry3d upright()
{
  return Eigen::Isometry3d::Identity();
}

struct PackedPoint
{
  float x, y, z, padding;
};

PointView rowOf(const std::vector<PackedPoint>& points)
{
  return PointView::points(points.data(), static_cast<std::uint32_t>(points.size()), 1);
}

BinaryGrid project(const PointView& points, const Eigen::Isometry3d& to_floor,
                   const Projection::Parameters& parameters = {}, const GridParameters& grid = {})
{
  BinaryGrid occupancy{GridGeometry(grid)};
  Projection(parameters).project(points, to_floor, occupancy);
  return occupancy;
}

TEST(Projection, MarksTheCellThatAPointStandsIn)
{
  const BinaryGrid grid = project(rowOf({{1.02F, 0.51F, 0.3F, 0.0F}}), upright());
  EXPECT_EQ(grid.count(), 1U);
  EXPECT_TRUE(grid.occupied(20, 60));
}

TEST(Projection, TakesHeightsFromTheLowestToTheHighestBothIncluded)
{
  Projection::Parameters parameters;
  parameters.min_height = 0.25;
  parameters.max_height = 0.5;
  const float below = std::nextafter(0.25F, 0.0F);
  const float above = std::nextafter(0.5F, 1.0F);
  EXPECT_EQ(
      project(rowOf({{1.0F, 0.0F, below, 0.0F}, {2.0F, 0.0F, above, 0.0F}}), upright(), parameters).count(),
      0U);
  EXPECT_EQ(
      project(rowOf({{1.0F, 0.0F, 0.25F, 0.0F}, {2.0F, 0.0F, 0.5F, 0.0F}}), upright(), parameters).count(),
      2U);
}

TEST(Projection, LeavesPointsBesideTheGridOut)
{
  const BinaryGrid grid = project(rowOf({{-0.001F, 0.0F, 0.3F, 0.0F},
                                         {5.0F, 0.0F, 0.3F, 0.0F},
                                         {1.0F, 2.5F, 0.3F, 0.0F},
                                         {1.0F, -2.51F, 0.3F, 0.0F}}),
                                  upright());
  EXPECT_EQ(grid.count(), 0U);
}

TEST(Projection, NothingStandsWhereTheNumbersAreNotFiniteOrHuge)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  std::vector<PackedPoint> points;
  for (const float odd : {nan, -nan, infinity, -infinity, 3e38F, -3e38F, 1e10F}) {
    for (int axis = 0; axis < 7; ++axis) {
      const auto component = [&](int bit, float good) { return ((axis + 1) >> bit & 1) != 0 ? odd : good; };
      points.push_back({component(0, 1.0F), component(1, 0.0F), component(2, 0.3F), odd});
    }
  }
  EXPECT_EQ(project(rowOf(points), upright()).count(), 0U);
  EXPECT_EQ(project(rowOf(points), tiltedCamera()).count(), 0U);
}

TEST(Projection, PixelsWithoutReturnAreNotTheCameraItself)
{
  // The camera is as high as an obstacle, and a depth of 0 would put the pixel where the camera is.
  const Eigen::Isometry3d low_camera = tiltedCamera(0.3);
  const PinholeRays rays = PinholeRays::make(40, 4, 500.0, 500.0, 20.0, 2.0);
  const std::vector<std::uint16_t> millimetres(160, 0);
  const std::vector<float> metres(160, 0.0F);
  const std::vector<float> negative(160, -0.1F);
  EXPECT_EQ(project(PointView::depth(millimetres.data(), 80, rays), low_camera).count(), 0U);
  EXPECT_EQ(project(PointView::depth(metres.data(), 160, rays), low_camera).count(), 0U);
  EXPECT_EQ(project(PointView::depth(negative.data(), 160, rays), low_camera).count(), 0U);
}

TEST(Projection, NoTransformMarksNothingWhenItIsNotANumber)
{
  Eigen::Isometry3d broken = upright();
  broken.matrix().setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(project(rowOf({{1.0F, 0.0F, 0.3F, 0.0F}}), broken).count(), 0U);
}

TEST(Projection, CountsThePointsOfACell)
{
  // As many points as there are in a row of a large image, so that the counters have to saturate.
  for (const int in_cell : {1, 2, 254, 255, 2000}) {
    const std::vector<PackedPoint> points(static_cast<std::size_t>(in_cell), {1.02F, 0.51F, 0.3F, 0.0F});
    for (const int enough : {1, 2, 3, 254, 255}) {
      Projection::Parameters parameters;
      parameters.min_points_per_cell = enough;
      EXPECT_EQ(project(rowOf(points), upright(), parameters).count(), in_cell >= enough ? 1U : 0U)
          << in_cell << " points where " << enough << " are enough";
    }
  }
}

TEST(Projection, ForgetsTheLastFrame)
{
  Projection projection{Projection::Parameters{}};
  BinaryGrid grid{GridGeometry(GridParameters{})};
  projection.project(rowOf({{1.0F, 0.0F, 0.3F, 0.0F}}), upright(), grid);
  projection.project(rowOf({{2.0F, 0.0F, 0.3F, 0.0F}}), upright(), grid);
  EXPECT_EQ(grid.count(), 1U);
  EXPECT_TRUE(grid.occupied(40, 50));
}

TEST(Projection, AnEmptyFrameLeavesTheGridFree)
{
  EXPECT_EQ(project(PointView(), upright()).count(), 0U);
}

/// A frame of random points, some of them such that no sensor should give them.
class RandomFrame
{
public:
  explicit RandomFrame(std::mt19937& random) : random_(&random)
  {
    width_ = pick(1U, 140U);
    height_ = pick(1U, 9U);
    rays_ = PinholeRays::make(width_, height_, 40.0, 41.0, 0.5 * width_, 0.4 * height_);
    layout_ = static_cast<PointLayout>(pick(0, 2));
    if (layout_ == PointLayout::kCloud) {
      fillCloud();
    } else if (layout_ == PointLayout::kDepthMetres) {
      fillDepth<float>([this] { return coordinate(0.0F, 4.0F); });
    } else {
      fillDepth<std::uint16_t>([this] {
        return static_cast<std::uint16_t>(pick(0, 9) == 0 ? 65535 * pick(0, 1) : pick(1, 4000));
      });
    }
  }

  PointView view() const
  {
    const std::uint8_t* const first = bytes_.data() + misalignment_;
    if (layout_ == PointLayout::kCloud) return PointView::cloud(first, width_, height_, strides_);
    if (layout_ == PointLayout::kDepthMetres) {
      return PointView::depth(reinterpret_cast<const float*>(first), strides_.row_step, rays_);
    }
    return PointView::depth(reinterpret_cast<const std::uint16_t*>(first), strides_.row_step, rays_);
  }

private:
  template <class Integer>
  Integer pick(Integer low, Integer high)
  {
    return std::uniform_int_distribution<Integer>(low, high)(*random_);
  }

  float coordinate(float low, float high)
  {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    constexpr float kOdd[] = {0.0F,
                              -0.0F,
                              1e-40F,
                              -1e-40F,
                              3e38F,
                              -3e38F,
                              1e10F,
                              -1e10F,
                              2147483648.0F,
                              -2147483904.0F,
                              kInfinity,
                              -kInfinity,
                              std::numeric_limits<float>::quiet_NaN()};
    if (pick(0, 19) == 0) return kOdd[pick(std::size_t{0}, std::size(kOdd) - 1)];
    return std::uniform_real_distribution<float>(low, high)(*random_);
  }

  template <class T>
  void put(std::size_t at, T value)
  {
    std::memcpy(bytes_.data() + misalignment_ + at, &value, sizeof value);
  }

  /// Makes room for rows that may have a gap between them; the last one ends with the memory.
  void makeRoom(std::size_t row_bytes)
  {
    const auto gap = 5 * pick(std::size_t{0}, std::size_t{2});
    strides_.row_step = row_bytes + gap;
    bytes_.assign(misalignment_ + strides_.row_step * height_ - gap, 0xFF);
  }

  void fillCloud()
  {
    constexpr PointView::CloudStrides kKinds[] = {{0, 16, 0, 4, 8},  {0, 32, 0, 4, 8}, {0, 12, 0, 4, 8},
                                                  {0, 16, 4, 8, 12}, {0, 20, 8, 0, 4}, {0, 27, 13, 3, 20}};
    strides_ = kKinds[pick(std::size_t{0}, std::size(kKinds) - 1)];
    misalignment_ = pick(std::size_t{0}, std::size_t{3});
    makeRoom(width_ * strides_.point_step);
    for (std::uint32_t v = 0; v < height_; ++v) {
      for (std::uint32_t u = 0; u < width_; ++u) {
        const std::size_t at = v * strides_.row_step + u * strides_.point_step;
        put(at + strides_.x_offset, coordinate(-2.0F, 2.0F));
        put(at + strides_.y_offset, coordinate(-0.5F, 1.0F));
        put(at + strides_.z_offset, coordinate(0.0F, 4.0F));
      }
    }
  }

  template <class T, class Value>
  void fillDepth(Value value)
  {
    makeRoom(width_ * sizeof(T));
    for (std::uint32_t v = 0; v < height_; ++v) {
      for (std::uint32_t u = 0; u < width_; ++u) put<T>(v * strides_.row_step + u * sizeof(T), value());
    }
  }

  std::mt19937* random_;
  std::uint32_t width_, height_;
  PinholeRays rays_;
  PointLayout layout_;
  PointView::CloudStrides strides_;
  std::size_t misalignment_ = 0;
  std::vector<std::uint8_t> bytes_;
};

Eigen::Isometry3d randomTransform(std::mt19937& random)
{
  std::uniform_real_distribution<double> number(-0.4, 0.4);
  const auto turn = [&](const Eigen::Vector3d& axis) { return Eigen::AngleAxisd(number(random), axis); };
  Eigen::Isometry3d transform = tiltedCamera(0.5 + number(random));
  transform.rotate(turn(Eigen::Vector3d::UnitX()) * turn(Eigen::Vector3d::UnitY()));
  transform.pretranslate(Eigen::Vector3d(number(random), number(random), 0.0));
  return transform;
}

GridParameters randomGrid(std::mt19937& random)
{
  std::uniform_real_distribution<double> number(0.0, 1.0);
  GridParameters grid;
  grid.grid_length = 1.0 + 5.0 * number(random);
  grid.grid_width = 1.0 + 5.0 * number(random);
  grid.grid_resolution = 0.02 + 0.2 * number(random);
  return grid;
}

/// Each of the kernels that this processor can run.
class EveryKernel : public testing::TestWithParam<ProjectionKernel>
{
};

TEST_P(EveryKernel, FindsTheCellsOfTheReferenceBitForBit)
{
  std::mt19937 random(20201024);
  std::size_t occupied = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const RandomFrame frame(random);
    const Eigen::Isometry3d to_floor = randomTransform(random);
    const GridGeometry geometry(randomGrid(random));
    Projection::Parameters parameters;
    parameters.min_points_per_cell = std::uniform_int_distribution<>(1, 3)(random);

    BinaryGrid grid(geometry);
    Projection(parameters, GetParam()).project(frame.view(), to_floor, grid);
    const BinaryGrid expected = ReferenceProjection(parameters, to_floor, geometry).project(frame.view());
    ASSERT_EQ(grid.cells(), expected.cells())
        << "trial " << trial << ": " << grid.count() << " cells, expected " << expected.count();
    occupied += grid.count();
  }
  EXPECT_GT(occupied, 30000U) << "too few cells to compare anything";
}

TEST_P(EveryKernel, CollectsThePointsThatStandInTheGrid)
{
  std::mt19937 random(7);
  std::vector<Eigen::Vector3f> collected;
  for (int trial = 0; trial < 300; ++trial) {
    const RandomFrame frame(random);
    const PointView view = frame.view();
    const Eigen::Isometry3d to_floor = randomTransform(random);
    const GridGeometry geometry(randomGrid(random));
    const Projection::Parameters parameters;
    Projection(parameters, GetParam()).collect(view, to_floor, geometry, collected);

    const ReferenceProjection reference(parameters, to_floor, geometry);
    std::vector<Eigen::Vector3f> expected;
    for (std::uint32_t v = 0; v < view.height(); ++v) {
      for (std::uint32_t u = 0; u < view.width(); ++u) {
        if (reference.cell(view, u, v)) expected.emplace_back(to_floor.cast<float>() * view.point(u, v));
      }
    }
    const auto before = [](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
      return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    };
    std::sort(collected.begin(), collected.end(), before);
    std::sort(expected.begin(), expected.end(), before);
    ASSERT_EQ(collected, expected) << "trial " << trial;
  }
}

TEST_P(EveryKernel, RoundsAsTheReferenceDoesWherePointsLieOnTheEdgesOfCells)
{
  std::mt19937 random(11);
  const Projection::Parameters parameters;
  const GridGeometry geometry{GridParameters{}};
  const PinholeRays rays = PinholeRays::make(160, 120, 130.0, 130.0, 80.0, 60.0);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Isometry3d to_floor = randomTransform(random);
    std::vector<PackedPoint> cloud(rays.column_slope.size() * rays.row_slope.size());
    std::vector<float> depth(cloud.size());
    for (std::size_t k = 0; k < cloud.size(); ++k) {
      const auto i = static_cast<double>(k % 100);
      const auto j = static_cast<double>(k / 100 % 100);
      const Eigen::Vector3d corner(i * geometry.resolution, geometry.origin_y + j * geometry.resolution,
                                   k % 3 == 0 ? parameters.min_height : parameters.max_height);
      const Eigen::Vector3f p = (to_floor.inverse() * corner).cast<float>();
      cloud[k] = {p.x(), p.y(), p.z(), 0.0F};
      const Eigen::Vector3d ray(rays.column_slope[k % 160], rays.row_slope[k / 160], 1.0);
      const double edge = corner.x() - to_floor.translation().x();
      depth[k] = static_cast<float>(edge / to_floor.linear().row(0).dot(ray));
    }
    const ReferenceProjection reference(parameters, to_floor, geometry);
    for (const PointView& view :
         {PointView::points(cloud.data(), 160, 120), PointView::depth(depth.data(), 640, rays)}) {
      BinaryGrid grid(geometry);
      Projection(parameters, GetParam()).project(view, to_floor, grid);
      ASSERT_EQ(grid.cells(), reference.project(view).cells()) << "trial " << trial;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfThisProcessor, EveryKernel, testing::ValuesIn(projectionKernels()),
                         [](const testing::TestParamInfo<ProjectionKernel>& kernel) {
                           std::string name = kernel.param.name;
                           name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                           return name;
                         });

TEST(Projection, AgreesWithDoublePrecisionAwayFromTheEdges)
{
  constexpr double kRounding = 2e-6;  // [m]
  std::mt19937 random(3);
  const Projection::Parameters parameters;
  const GridGeometry geometry{GridParameters{}};
  int compared = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const RandomFrame frame(random);
    const PointView view = frame.view();
    const Eigen::Isometry3d to_floor = randomTransform(random);
    const ReferenceProjection reference(parameters, to_floor, geometry);
    for (std::uint32_t v = 0; v < view.height(); ++v) {
      for (std::uint32_t u = 0; u < view.width(); ++u) {
        const Eigen::Vector3d p = to_floor * view.point(u, v).cast<double>();
        if (!p.allFinite() || p.norm() > 10.0) continue;
        const double x = (p.x() - geometry.origin_x) / geometry.resolution;
        const double y = (p.y() - geometry.origin_y) / geometry.resolution;
        const double slack = kRounding / geometry.resolution;
        if (std::abs(p.z() - parameters.min_height) < kRounding ||
            std::abs(p.z() - parameters.max_height) < kRounding || std::abs(x - std::round(x)) < slack ||
            std::abs(y - std::round(y)) < slack) {
          continue;
        }
        const bool inside = p.z() >= parameters.min_height && p.z() <= parameters.max_height && x >= 0.0 &&
                            x < geometry.cells_x && y >= 0.0 && y < geometry.cells_y;
        const auto cell = reference.cell(view, u, v);
        ASSERT_EQ(cell.has_value(), inside) << p.transpose();
        if (cell) {
          ASSERT_EQ(*cell, static_cast<std::size_t>(y) * 100 + static_cast<std::size_t>(x)) << p.transpose();
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 3000);
}

}  // namespace
}  // namespace polygonal_perception
