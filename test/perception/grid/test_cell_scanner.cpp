#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "perception/grid/cell_scanner.hpp"
#include "support/every_kernel.hpp"

namespace polygonal_perception::perception {
namespace {

/// How a frame lies in memory.
struct Layout
{
  const char* name;
  PointLayout kind;
  PointView::CloudStrides strides;  // of a cloud
  std::size_t misalignment;
  std::size_t gap;  // [bytes] between rows
};

const Layout kLayouts[] = {
    {"cloud as kernels take it", PointLayout::kCloud, {0, 16, 0, 4, 8}, 0, 0},
    {"cloud, not aligned, rows apart", PointLayout::kCloud, {0, 16, 0, 4, 8}, 3, 7},
    {"cloud of 12 bytes", PointLayout::kCloud, {0, 12, 0, 4, 8}, 0, 0},
    {"cloud with colours", PointLayout::kCloud, {0, 32, 0, 4, 8}, 1, 0},
    {"cloud with z first", PointLayout::kCloud, {0, 21, 8, 15, 1}, 0, 5},
    {"cloud with y last", PointLayout::kCloud, {0, 18, 1, 13, 9}, 2, 0},
    {"millimetres", PointLayout::kDepthUnits, {}, 0, 0},
    {"millimetres, not aligned, rows apart", PointLayout::kDepthUnits, {}, 1, 3},
    {"metres", PointLayout::kDepthMetres, {}, 0, 0},
    {"metres, not aligned, rows apart", PointLayout::kDepthMetres, {}, 3, 6},
};

constexpr std::uint32_t kRows = 3;

/// A frame in which the point of pixel (u, v) stands in cell (u, v), or of which the pixel has no return.
class NumberedFrame
{
public:
  template <class HasPoint>
  NumberedFrame(const Layout& layout, std::uint32_t width, const HasPoint& has_point)
      : layout_(layout), width_(width), rays_(PinholeRays::make(width, kRows, 1.0, 1.0, -0.5, -0.5))
  {
    const std::size_t pixel = layout.kind == PointLayout::kCloud         ? layout.strides.point_step
                              : layout.kind == PointLayout::kDepthMetres ? sizeof(float)
                                                                         : sizeof(std::uint16_t);
    row_step_ = pixel * width + layout.gap;
    // The last row ends with the memory: a sanitizer sees who reads on.
    bytes_.assign(layout.misalignment + row_step_ * kRows - layout.gap, 0x11);
    for (std::uint32_t v = 0; v < kRows; ++v) {
      for (std::uint32_t u = 0; u < width; ++u)
        put(bytes_.data() + layout.misalignment + v * row_step_ + u * pixel, u, v, has_point(u, v));
    }
  }

  PointView view() const
  {
    const std::uint8_t* const first = bytes_.data() + layout_.misalignment;
    if (layout_.kind == PointLayout::kDepthMetres)
      return PointView::depth(reinterpret_cast<const float*>(first), row_step_, rays_);
    if (layout_.kind == PointLayout::kDepthUnits)
      return PointView::depth(reinterpret_cast<const std::uint16_t*>(first), row_step_, rays_);
    PointView::CloudStrides strides = layout_.strides;
    strides.row_step = row_step_;
    return PointView::cloud(first, width_, kRows, strides);
  }

  /// Points are 1 m high.
  CellTransform transform() const
  {
    CellTransform transform{};
    transform.height = {0.0F, 0.0F, 1.0F};
    transform.column = {1.0F, 0.0F, 0.0F};
    transform.row = {0.0F, 1.0F, 0.0F};
    transform.lowest = 0.5F;
    transform.highest = 1.5F;
    transform.columns = static_cast<float>(width_);
    transform.rows = static_cast<float>(kRows);
    return transform;
  }

private:
  void put(std::uint8_t* at, std::uint32_t u, std::uint32_t v, bool has_point) const
  {
    const float z = has_point ? 1.0F : NAN;
    const auto millimetres = static_cast<std::uint16_t>(has_point ? 1000 : 0);
    if (layout_.kind == PointLayout::kDepthMetres) {
      std::memcpy(at, &z, sizeof z);
    } else if (layout_.kind == PointLayout::kDepthUnits) {
      std::memcpy(at, &millimetres, sizeof millimetres);
    } else {
      const float x = static_cast<float>(u) + 0.5F;
      const float y = static_cast<float>(v) + 0.5F;
      std::memcpy(at + layout_.strides.x_offset, &x, sizeof x);
      std::memcpy(at + layout_.strides.y_offset, &y, sizeof y);
      std::memcpy(at + layout_.strides.z_offset, &z, sizeof z);
    }
  }

  Layout layout_;
  std::uint32_t width_;
  PinholeRays rays_;
  std::size_t row_step_ = 0;
  std::vector<std::uint8_t> bytes_;
};

/// The cell of each pixel of a row, numbered from 1; 0: none.
std::vector<std::uint32_t> cellsOfRow(CellScanner& scanner, std::uint32_t v, std::uint32_t width)
{
  std::vector<std::uint32_t> cells(width, 0);
  for (const CellBlock& block : scanner.row(v)) {
    for (std::uint32_t lane = 0; lane < kBlock; ++lane) {
      if (block.cell[lane] == 0) continue;
      const std::uint32_t u = scanner.column(block, lane);
      EXPECT_LT(u, width) << "a lane beyond the image stands in cell " << block.cell[lane];
      if (u >= width) continue;
      EXPECT_EQ(cells[u], 0U) << "pixel " << u << " came twice";
      cells[u] = block.cell[lane];
    }
  }
  return cells;
}

using CellScanning = test::EveryKernel;

TEST_P(CellScanning, GivesEveryPixelItsCellInAnyWidthAndLayout)
{
  const auto twoOfThree = [](std::uint32_t u, std::uint32_t v) { return (u + v) % 3 != 0; };
  CellScanner scanner(kernel());  // the same for all: nothing of a wider frame may be left
  for (const Layout& layout : kLayouts) {
    for (const std::uint32_t width : {160U, 97U, 65U, 64U, 63U, 33U, 32U, 31U, 2U, 1U}) {
      const NumberedFrame frame(layout, width, twoOfThree);
      const PointView view = frame.view();
      scanner.begin(view, frame.transform());
      for (std::uint32_t v = 0; v < kRows; ++v) {
        std::vector<std::uint32_t> expected(width, 0);
        for (std::uint32_t u = 0; u < width; ++u) expected[u] = twoOfThree(u, v) ? 1 + v * width + u : 0;
        ASSERT_EQ(cellsOfRow(scanner, v, width), expected)
            << layout.name << ", width " << width << ", row " << v;
      }
    }
  }
}

TEST_P(CellScanning, APixelsColumnCountsInItsHeightToo)
{
  // Heights that grow along the row: only the last pixel is high enough.
  for (const Layout& layout : kLayouts) {
    for (const std::uint32_t width : {64U, 65U, 95U}) {
      const NumberedFrame frame(layout, width, [](std::uint32_t, std::uint32_t) { return true; });
      const PointView view = frame.view();
      CellTransform transform = frame.transform();
      transform.height = {1.0F, 0.0F, 0.0F};
      transform.lowest = static_cast<float>(width - 1);
      transform.highest = static_cast<float>(width);
      CellScanner scanner(kernel());
      scanner.begin(view, transform);
      std::vector<std::uint32_t> expected(width, 0);
      expected.back() = width;
      EXPECT_EQ(cellsOfRow(scanner, 0, width), expected) << layout.name << ", width " << width;
    }
  }
}

TEST_P(CellScanning, RowsMayComeInAnyOrder)
{
  for (const Layout& layout : kLayouts) {
    const NumberedFrame frame(layout, 40, [](std::uint32_t u, std::uint32_t) { return u == 35; });
    const PointView view = frame.view();
    CellScanner scanner(kernel());
    scanner.begin(view, frame.transform());
    for (const std::uint32_t v : {2U, 0U, 2U, 1U})
      EXPECT_EQ(cellsOfRow(scanner, v, 40)[35], 1 + v * 40 + 35) << layout.name;
  }
}

TEST_P(CellScanning, LeavesOutBlocksInWhichNothingStands)
{
  for (const Layout& layout : kLayouts) {
    const NumberedFrame frame(layout, 100, [](std::uint32_t u, std::uint32_t) { return u == 70 || u == 98; });
    const PointView view = frame.view();
    CellScanner scanner(kernel());
    scanner.begin(view, frame.transform());
    const CellScanner::Row row = scanner.row(1);
    ASSERT_EQ(row.end() - row.begin(), 2) << layout.name;
    EXPECT_EQ(row.begin()[0].first, 64U) << layout.name;
    EXPECT_EQ(row.begin()[1].first, 96U) << layout.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Kernel, CellScanning, testing::ValuesIn(test::kKernelNames), test::nameOfKernel);

}  // namespace
}  // namespace polygonal_perception::perception
