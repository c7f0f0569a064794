#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace polygonal_perception::perception {

/// From a point (x, y, z) of the input's frame to its height and its place in the grid:
///
///     height = height.x x + height.y y + height.z z
///     column = column.x x + column.y y + column.z z + column_offset
///     row    = row.x x    + row.y y    + row.z z    + row_offset
///
/// A point stands in the cell (floor(column), floor(row)) when lowest <= height <= highest, 0 <= column <
/// columns, 0 <= row < rows and nearest_squared <= x x + y y + z z <= farthest_squared. The height is taken from the origin of the input's frame, not from the floor.
///
/// Its layer is 0, the floor's, below `standing`, and else
///
///     1 + min(last_slab, floor((height - standing) slabs_per_metre)).
///
/// All of this is done in single precision, from left to right, a product rounded before it is added: so
/// every kernel on every machine finds the same cells.
struct CellTransform
{
  struct Coefficients
  {
    float x, y, z;
  };
  Coefficients height;       ///< [m]
  Coefficients column, row;  ///< [cells]
  float column_offset, row_offset;
  float lowest, highest;  ///< [m]
  float standing, slabs_per_metre, last_slab;
  std::int32_t layer_size;  ///< by which the numbers of the cells of two layers differ; 0: one layer
  float columns, rows;      ///< size of the grid
  float nearest_squared, farthest_squared;  ///< [m^2] of the ranges at which points lie
};

/// A row of a depth image. As x and y are z times the slopes of the pixel's ray, pixel u is at
///
///     height = z (heights[u] + height)
///     column = z (columns[u] + column) + column_offset
///     row    = z (rows[u]    + row)    + row_offset
///     range^2 = z z (squares[u] + square)
///
/// and it is a point when 0 < z < none. z is the number in the image: the coefficients know its unit.
struct DepthRow
{
  const std::uint8_t* depth;  ///< uint16 or float; no alignment is assumed
  const float* heights;       ///< the share of each pixel's column, in the order of the kernel's lanes
  const float* columns;
  const float* rows;
  const float* squares;
  float height, column, row, square;  ///< the share of the image row
};

/// Pixels that a kernel takes at a time.
constexpr std::uint32_t kBlock = 32;

/// The cells in which the pixels of a block stand.
struct alignas(64) CellBlock
{
  /// For each lane 0 for none, or 1 + layer x layer_size + its row-major index.
  std::uint32_t cell[kBlock];
  std::uint32_t first;  ///< the block's first pixel
};

/// The inner loop of the package: in which cells do the points of a row of pixels stand? There is a kernel
/// for each width of the processors' vector registers, all compiled from one source.
///
/// Each function takes `count` pixels, a multiple of kBlock, and writes a CellBlock for every block of which
/// a pixel has the right height. It returns how many.
struct ProjectionKernel
{
  const char* name;

  /// Points 16 bytes apart that begin with x, y, z; what the fourth number is does not matter.
  std::uint32_t (*cloud)(const std::uint8_t* points, std::uint32_t count, const CellTransform&,
                         CellBlock* blocks);
  std::uint32_t (*units)(const DepthRow&, std::uint32_t count, const CellTransform&, CellBlock* blocks);
  std::uint32_t (*metres)(const DepthRow&, std::uint32_t count, const CellTransform&, CellBlock* blocks);

  /// Which pixel of a block each lane holds: pixels are taken in the order that is cheapest to load.
  std::uint8_t cloud_pixel[kBlock];
  std::uint8_t units_pixel[kBlock];
  std::uint8_t metres_pixel[kBlock];
};

/// The kernels that this processor can run, from the narrowest to the widest. There is at least one.
const std::vector<ProjectionKernel>& projectionKernels();

}  // namespace polygonal_perception::perception
