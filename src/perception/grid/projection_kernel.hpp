#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace polygonal_perception::perception {

/// Pixels that a kernel takes at a time.
constexpr std::uint32_t kBlock = 32;

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
  float metres_per_cell;
  std::int32_t beside;      ///< -1: what is beside the grid is in the cell kBeside; 0: in none
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

/// The cell of what is beside the grid.
constexpr std::uint32_t kBeside = 0xFFFFFFFF;

/// The cells in which the pixels of a block stand.
struct alignas(64) CellBlock
{
  /// For each lane 0 for none, or 1 + layer x layer_size + its row-major index.
  std::uint32_t cell[kBlock];
  std::uint32_t first;  ///< the block's first pixel
};

/// The nearest of the points above the floor that each lane has held, in the grid or beside it: an entry for each pixel of
/// a row, in the order of the kernel's lanes.
struct NearestLanes
{
  float* squared;  ///< [m^2] of its distance from the sensor along the floor; infinite: none
  float* x;        ///< [m] from the sensor
  float* y;
  float* height;          ///< [m] from the sensor's
  std::uint8_t* changed;  ///< an entry a block: set to 1 where a nearer point was found

  /// From the first pixel of a block on.
  NearestLanes from(std::size_t first) const
  {
    return {squared + first, x + first, y + first, height + first, changed + first / kBlock};
  }
};

/// In which bin of directions points lie, and whether they are so high that no point of the floor could be seen there.
struct BinRule
{
  float first;  ///< [rad] where the first bin begins
  float bins_per_radian;
  float count;
  float sensor_height;                                  ///< [m] above the floor
  float sigmas;                                         ///< so many standard deviations is a point higher
  float noise_constant, noise_linear, noise_quadratic;  ///< of the sensor
  float floor_covariance[6];  ///< of the height of the floor: xx, 2 xy, 2 x, yy, 2 y, 1
};

/// The inner loop of the package: in which cells do the points of a row of pixels stand? There is a kernel
/// for each width of the processors' vector registers, all compiled from one source.
///
/// Each function takes `count` pixels, a multiple of kBlock, and writes a CellBlock for every block of which
/// a pixel has the right height. It returns how many. Unless squared is null, it keeps the nearest points.
struct ProjectionKernel
{
  const char* name;

  /// Points 16 bytes apart that begin with x, y, z; what the fourth number is does not matter.
  std::uint32_t (*cloud)(const std::uint8_t* points, std::uint32_t count, const CellTransform&,
                         CellBlock* blocks, NearestLanes nearest);
  std::uint32_t (*units)(const DepthRow&, std::uint32_t count, const CellTransform&, CellBlock* blocks,
                         NearestLanes nearest);
  std::uint32_t (*metres)(const DepthRow&, std::uint32_t count, const CellTransform&, CellBlock* blocks,
                          NearestLanes nearest);

  /// The bins of points (x, y, height) in the floor frame [m]; -1: none. Room is for a multiple of kBlock.
  void (*bins)(const BinRule&, const float* x, const float* y, const float* height, std::size_t count,
               std::int32_t* bins);

  /// Which pixel of a block each lane holds: pixels are taken in the order that is cheapest to load.
  std::uint8_t cloud_pixel[kBlock];
  std::uint8_t units_pixel[kBlock];
  std::uint8_t metres_pixel[kBlock];
};

/// The kernels that this processor can run, from the narrowest to the widest. There is at least one.
const std::vector<ProjectionKernel>& projectionKernels();

}  // namespace polygonal_perception::perception
