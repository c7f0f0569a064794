#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "perception/grid/projection_kernel.hpp"
#include "polygonal_perception/perception/grid/projection.hpp"
#include "support/every_kernel.hpp"
#include "support/projection_scene.hpp"
#include "support/random_frame.hpp"
#include "support/reference_projection.hpp"

namespace polygonal_perception::perception {

namespace {

using test::EveryKernel;

Eigen::Isometry3d randomTransform(std::mt19937& random)
{
  std::uniform_real_distribution<double> number(-0.4, 0.4);
  const auto turn = [&](const Eigen::Vector3d& axis) { return Eigen::AngleAxisd(number(random), axis); };
  Eigen::Isometry3d transform = test::tiltedCamera(0.5 + number(random));
  transform.rotate(turn(Eigen::Vector3d::UnitX()) * turn(Eigen::Vector3d::UnitY()));
  transform.pretranslate(Eigen::Vector3d(number(random), number(random), 0.0));
  return transform;
}

occupancy::GridParameters randomGrid(std::mt19937& random)
{
  std::uniform_real_distribution<double> number(0.0, 1.0);
  occupancy::GridParameters grid;
  grid.grid_length = 1.0 + 5.0 * number(random);
  grid.grid_width = 1.0 + 5.0 * number(random);
  grid.grid_resolution = 0.02 + 0.2 * number(random);
  return grid;
}

TEST_P(EveryKernel, FindsTheCellsOfTheReferenceBitForBit)
{
  std::mt19937 random(20201024);
  std::size_t occupied = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const test::RandomFrame frame(random);
    const Eigen::Isometry3d to_floor = randomTransform(random);
    const occupancy::GridGeometry geometry(randomGrid(random));
    Projection::Parameters parameters;
    parameters.min_points_per_cell = std::uniform_int_distribution<>(1, 3)(random);

    occupancy::BinaryGrid grid(geometry);
    Projection(parameters, kernel()).project(frame.view(), to_floor, grid);
    const occupancy::BinaryGrid expected =
        test::ReferenceProjection(parameters, to_floor, geometry).project(frame.view());
    ASSERT_EQ(grid.cells(), expected.cells())
        << "trial " << trial << ": " << grid.count() << " cells, expected " << expected.count();
    occupied += grid.count();
  }
  EXPECT_GT(occupied, 30000U) << "too few cells to compare anything";
}

/// Whether any of a cell and its eight neighbours is set.
bool isSetAround(const std::vector<std::uint8_t>& cells, const occupancy::GridGeometry& geometry,
                 std::size_t cell)
{
  const auto columns = static_cast<std::size_t>(geometry.cells_x);
  const int i = static_cast<int>(cell % columns);
  const int j = static_cast<int>(cell / columns);
  for (int y = std::max(0, j - 1); y <= std::min(geometry.cells_y - 1, j + 1); ++y) {
    for (int x = std::max(0, i - 1); x <= std::min(geometry.cells_x - 1, i + 1); ++x) {
      if (cells[static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x)] != 0) return true;
    }
  }
  return false;
}

TEST_P(EveryKernel, ObservesTheFloorAndTheSlabsOfTheReference)
{
  std::mt19937 random(16);
  std::size_t floor_cells = 0;
  std::size_t left_out = 0;  // of rows that were taken to show the same cells as the one before
  std::size_t hits = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const test::RandomFrame frame(random);
    const PointView view = frame.view();
    const Eigen::Isometry3d to_floor = randomTransform(random);
    occupancy::BinaryGrid grid{occupancy::GridGeometry(randomGrid(random))};
    Projection::Parameters parameters;
    parameters.min_height = std::uniform_real_distribution<>(-0.1, 0.3)(random);
    parameters.max_height = parameters.min_height + std::uniform_real_distribution<>(0.1, 1.0)(random);
    occupancy::ObservedCells observed;
    Projection(parameters, kernel()).project(view, to_floor, grid, {}, {&observed});

    const test::ReferenceProjection reference(parameters, to_floor, grid.geometry());
    std::vector<std::uint8_t> floor(grid.geometry().size(), 0);
    std::vector<std::uint8_t> hit(floor.size(), 0);
    for (std::uint32_t v = 0; v < view.height(); ++v) {
      for (std::uint32_t u = 0; u < view.width(); ++u) {
        const auto place = reference.place(view, u, v);
        if (!place) continue;
        if (place->slab < 0) {
          floor[place->cell] = 1;
        } else {
          hit[place->cell] =
              static_cast<std::uint8_t>(hit[place->cell] | 1U << static_cast<unsigned>(place->slab));
        }
      }
    }
    ASSERT_EQ(observed.hit, hit) << "trial " << trial;
    for (std::size_t cell = 0; cell < floor.size(); ++cell) {
      ASSERT_EQ(grid.cells()[cell] != 0, hit[cell] != 0) << "trial " << trial << ", cell " << cell;
      if (floor[cell] != 0) {
        ASSERT_TRUE(observed.floor[cell] == 1 || view.height() > 2) << "trial " << trial << ", cell " << cell;
        left_out += observed.floor[cell] == 0 ? 1 : 0;
      } else if (observed.floor[cell] != 0) {
        // Between two that were seen.
        ASSERT_TRUE(isSetAround(floor, grid.geometry(), cell)) << "trial " << trial << ", cell " << cell;
      }
      floor_cells += floor[cell];
      hits += hit[cell] != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(floor_cells, 10000U);
  EXPECT_LT(left_out, floor_cells / 30);
  EXPECT_GT(hits, 10000U);
}

TEST_P(EveryKernel, ACellWithTooFewPointsHasNoHits)
{
  std::mt19937 random(17);
  for (int trial = 0; trial < 300; ++trial) {
    const test::RandomFrame frame(random);
    const Eigen::Isometry3d to_floor = randomTransform(random);
    const occupancy::GridGeometry geometry(randomGrid(random));
    Projection::Parameters parameters;
    parameters.min_points_per_cell = 3;
    occupancy::BinaryGrid plain(geometry);
    occupancy::BinaryGrid with_layers(geometry);
    occupancy::ObservedCells observed;
    Projection(parameters, kernel()).project(frame.view(), to_floor, plain);
    Projection(parameters, kernel()).project(frame.view(), to_floor, with_layers, {}, {&observed});
    ASSERT_EQ(with_layers.cells(), plain.cells()) << "trial " << trial;
    for (std::size_t cell = 0; cell < geometry.size(); ++cell)
      ASSERT_EQ(observed.hit[cell] != 0, plain.cells()[cell] != 0) << "trial " << trial;
  }
}

TEST_P(EveryKernel, CollectsThePointsThatStandInTheGrid)
{
  std::mt19937 random(7);
  std::vector<Eigen::Vector3f> collected;
  for (int trial = 0; trial < 300; ++trial) {
    const test::RandomFrame frame(random);
    const PointView view = frame.view();
    const Eigen::Isometry3d to_floor = randomTransform(random);
    const occupancy::GridGeometry geometry(randomGrid(random));
    const Projection::Parameters parameters;
    Projection(parameters, kernel()).collect(view, to_floor, geometry, collected);

    const test::ReferenceProjection reference(parameters, to_floor, geometry);
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

TEST_P(EveryKernel, LeavesOutWhatLiesInTheIgnoredBoxes)
{
  std::mt19937 random(8);
  std::uniform_real_distribution<double> coordinate(-3.0, 3.0);
  std::size_t left_out = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const test::RandomFrame frame(random);
    const Eigen::Isometry3d to_floor = randomTransform(random);
    IgnoredBoxes boxes;
    for (int k = trial % 3; k >= 0; --k) {
      const Eigen::Vector3d corner(coordinate(random), coordinate(random), coordinate(random));
      boxes.add(randomTransform(random), {corner, corner + Eigen::Vector3d::Constant(2.0)});
    }
    const PointView view = frame.view();
    occupancy::BinaryGrid grid{occupancy::GridGeometry(randomGrid(random))};
    const Projection::Parameters parameters;
    Projection(parameters, kernel()).project(view.without(boxes), to_floor, grid);

    const test::ReferenceProjection reference(parameters, to_floor, grid.geometry());
    occupancy::BinaryGrid expected{grid.geometry()};
    for (std::uint32_t v = 0; v < view.height(); ++v) {
      for (std::uint32_t u = 0; u < view.width(); ++u) {
        const auto cell = reference.cell(view, u, v);
        if (!cell) continue;
        const bool is_ignored = boxes.contain(view.point(u, v));
        left_out += is_ignored ? 1 : 0;
        if (!is_ignored) expected.row(0)[*cell] = 1;
      }
    }
    ASSERT_EQ(grid.cells(), expected.cells()) << "trial " << trial;
  }
  EXPECT_GT(left_out, 1000U) << "too few points in boxes to tell anything";
}

TEST_P(EveryKernel, RoundsAsTheReferenceDoesWherePointsLieOnTheEdgesOfCells)
{
  std::mt19937 random(11);
  const Projection::Parameters parameters;
  const occupancy::GridGeometry geometry{occupancy::GridParameters{}};
  const PinholeRays rays = PinholeRays::make(160, 120, 130.0, 130.0, 80.0, 60.0);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Isometry3d to_floor = randomTransform(random);
    std::vector<test::PackedPoint> cloud(rays.column_slope.size() * rays.row_slope.size());
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
    const test::ReferenceProjection reference(parameters, to_floor, geometry);
    for (const PointView& view :
         {PointView::points(cloud.data(), 160, 120), PointView::depth(depth.data(), 640, rays)}) {
      occupancy::BinaryGrid grid(geometry);
      Projection(parameters, kernel()).project(view, to_floor, grid);
      ASSERT_EQ(grid.cells(), reference.project(view).cells()) << "trial " << trial;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kernel, EveryKernel, testing::ValuesIn(test::kKernelNames), test::nameOfKernel);

TEST(ProjectionKernels, EachIsTestedAndTheWidestIsTheLast)
{
  std::vector<std::string> names;
  for (const ProjectionKernel& kernel : projectionKernels()) names.emplace_back(kernel.name);
  ASSERT_FALSE(names.empty());
  EXPECT_EQ(names.front(), "baseline");
  auto tested = std::begin(test::kKernelNames);
  for (const std::string& name : names) {
    tested = std::find(tested, std::end(test::kKernelNames), name);
    EXPECT_NE(tested, std::end(test::kKernelNames)) << name << " in " << testing::PrintToString(names);
  }
}

TEST(ReferenceProjection, AgreesWithDoublePrecisionAwayFromTheEdges)
{
  constexpr double kRounding = 2e-6;  // [m]
  std::mt19937 random(3);
  const Projection::Parameters parameters;
  const occupancy::GridGeometry geometry{occupancy::GridParameters{}};
  int compared = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const test::RandomFrame frame(random);
    const PointView view = frame.view();
    const Eigen::Isometry3d to_floor = randomTransform(random);
    const test::ReferenceProjection reference(parameters, to_floor, geometry);
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
}  // namespace polygonal_perception::perception
