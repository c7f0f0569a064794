#include "polygonal_perception/perception/grid/projection.hpp"

#include <algorithm>
#include <cmath>

#include "perception/grid/cell_scanner.hpp"
#include "perception/grid/floor_gaps.hpp"
#include "perception/grid/nearest_standing.hpp"

namespace polygonal_perception::perception {

namespace {

CellTransform cellTransform(const Eigen::Isometry3d& to_floor_frame, const occupancy::GridGeometry& geometry,
                            const Projection::Parameters& parameters)
{
  const auto& rotation = to_floor_frame.linear();
  const Eigen::Vector3d& origin = to_floor_frame.translation();
  const auto coefficients = [&](Eigen::Index axis, double scale) {
    const Eigen::Vector3f c = (scale * rotation.row(axis)).cast<float>();
    return CellTransform::Coefficients{c.x(), c.y(), c.z()};
  };
  const double cells_per_metre = 1.0 / geometry.resolution;
  CellTransform transform{};
  transform.height = coefficients(2, 1.0);
  transform.column = coefficients(0, cells_per_metre);
  transform.row = coefficients(1, cells_per_metre);
  transform.column_offset = static_cast<float>((origin.x() - geometry.origin_x) * cells_per_metre);
  transform.row_offset = static_cast<float>((origin.y() - geometry.origin_y) * cells_per_metre);
  transform.lowest = static_cast<float>(parameters.min_height - origin.z());
  transform.highest = static_cast<float>(parameters.max_height - origin.z());
  transform.standing = transform.lowest;
  transform.metres_per_cell = static_cast<float>(geometry.resolution);
  transform.columns = static_cast<float>(geometry.cells_x);
  transform.rows = static_cast<float>(geometry.cells_y);
  return transform;
}

/// The floor's points, too, and the points that stand by slabs of their heights.
void addLayers(const occupancy::GridGeometry& geometry, const Projection::Parameters& parameters,
               CellTransform& transform)
{
  const double height = parameters.slabHeight();
  transform.lowest =
      transform.standing - static_cast<float>(parameters.min_height + std::abs(parameters.min_height));
  transform.slabs_per_metre = height > 0.0 ? static_cast<float>(1.0 / height) : 0.0F;
  transform.last_slab = occupancy::ObservedCells::kSlabs - 1;
  transform.layer_size = static_cast<std::int32_t>(geometry.size());
}

/// Points that fall in one cell mostly come one after the other. Counting them in turns, here or there,
/// spares each of them the wait for the last one's count to be written.
constexpr std::size_t kTurns = 4;

/// Counts what stands in each cell, whatever its layer, up to `enough`.
void countPoints(const CellScanner::Row& row, std::size_t cells, int enough, std::uint8_t* counts)
{
  for (const CellBlock& block : row) {
    for (const std::uint32_t cell : block.cell) {
      if (cell <= cells) continue;  // none, or the floor
      std::uint8_t& count = counts[(cell - 1) % cells];
      count = static_cast<std::uint8_t>(count + (count < enough ? 1 : 0));
    }
  }
}

}  // namespace

struct Projection::Workspace
{
  explicit Workspace(const ProjectionKernel& kernel) : scanner(kernel) {}

  CellScanner scanner;
  StandingRule rule;
  // The cells as the kernel numbers them: 0 takes what stands in none.
  std::vector<std::uint8_t> marks;  // whether anything is there, by layer
  FloorGaps gaps;
  std::vector<std::uint8_t> counts;  // how much, kTurns numbers a cell, none beyond min_points_per_cell
};

Projection::Projection(const Parameters& parameters) : Projection(parameters, projectionKernels().back()) {}

Projection::Projection(const Parameters& parameters, const ProjectionKernel& kernel)
    : parameters_(parameters), workspace_(std::make_unique<Workspace>(kernel))
{
}

Projection::Projection(Projection&& other) noexcept = default;
Projection& Projection::operator=(Projection&& other) noexcept = default;
Projection::~Projection() = default;

void Projection::project(const PointView& points, const Eigen::Isometry3d& to_floor_frame,
                         occupancy::BinaryGrid& occupancy, const HeightRules& rules,
                         const Observation& wanted)
{
  if (wanted.nearest != nullptr)
    wanted.nearest->countIn(parameters_.min_points_per_cell > 1 ? &occupancy : nullptr);
  begin(points, to_floor_frame, occupancy.geometry(), rules, wanted);
  if (wanted.cells != nullptr) {
    markLayers(points.height(), occupancy, wanted);
  } else if (parameters_.min_points_per_cell <= 1) {
    markAny(points.height(), occupancy);
  } else {
    markMany(points.height(), occupancy);
  }
}

void Projection::begin(const PointView& points, const Eigen::Isometry3d& to_floor_frame,
                       const occupancy::GridGeometry& geometry, const HeightRules& rules,
                       const Observation& wanted)
{
  CellTransform transform = cellTransform(to_floor_frame, geometry, parameters_);
  NearestLanes nearest{};
  if (wanted.nearest != nullptr) nearest = wanted.nearest->begin(workspace_->scanner.kernel(), points);
  if (wanted.cells != nullptr) addLayers(geometry, parameters_, transform);
  if (rules.ground != nullptr) {
    transform.lowest += rules.ground->lowest();
    transform.standing += rules.ground->lowest();
    transform.highest += rules.ground->highest();
  }
  const bool asks_noise = rules.noise != nullptr && parameters_.height_sigmas > 0.0;
  const bool asks_places = points.leavesOut() && wanted.nearest != nullptr;
  if (!asks_noise && !asks_places && rules.ground == nullptr) {
    workspace_->scanner.begin(points, transform, nullptr, nearest);
    return;
  }
  workspace_->rule = {to_floor_frame.cast<float>(),
                      rules.ground,
                      static_cast<float>(parameters_.min_height),
                      static_cast<float>(parameters_.max_height),
                      asks_noise ? rules.noise : nullptr,
                      static_cast<float>(parameters_.height_sigmas),
                      transform.slabs_per_metre,
                      transform.last_slab};
  workspace_->scanner.begin(points, transform, &workspace_->rule, nearest);
}

void Projection::markAny(std::uint32_t rows, occupancy::BinaryGrid& occupancy)
{
  const std::size_t cells = occupancy.geometry().size();
  workspace_->marks.assign(1 + cells, 0);
  std::uint8_t* const marks = workspace_->marks.data();
  for (std::uint32_t v = 0; v < rows; ++v) {
    for (const CellBlock& block : workspace_->scanner.row(v)) {
// A load and a store for each point: counting the loop would double that.
#pragma GCC unroll 8
      for (const std::uint32_t cell : block.cell) marks[cell] = 1;
    }
  }
  std::copy_n(marks + 1, cells, occupancy.row(0));
}

void Projection::markLayers(std::uint32_t rows, occupancy::BinaryGrid& occupancy, const Observation& wanted)
{
  occupancy::ObservedCells& observed = *wanted.cells;
  constexpr std::size_t kLayers = 1 + occupancy::ObservedCells::kSlabs;
  const occupancy::GridGeometry& geometry = occupancy.geometry();
  const std::size_t cells = geometry.size();
  const bool counts_points = parameters_.min_points_per_cell > 1;
  workspace_->marks.assign(1 + kLayers * cells, 0);
  workspace_->counts.assign(counts_points ? cells : 0, 0);
  workspace_->gaps.begin(geometry);
  std::uint8_t* const marks = workspace_->marks.data();
  std::uint32_t next_floor = 0;  // the next row in which the floor is looked for
  for (std::uint32_t v = 0; v < rows; ++v) {
    const bool has_floor = v >= next_floor;
    const CellScanner::Row row =
        has_floor ? workspace_->scanner.row(v) : workspace_->scanner.rowAboveFloor(v);
    for (const CellBlock& block : row) {
#pragma GCC unroll 8
      for (const std::uint32_t cell : block.cell) marks[cell] = 1;
    }
    if (has_floor) {
      workspace_->gaps.fill(v, row, marks + 1);
      next_floor = v + 1 + workspace_->gaps.rowsAlike();
    }
    if (counts_points) countPoints(row, cells, parameters_.min_points_per_cell, workspace_->counts.data());
    if (wanted.nearest != nullptr) wanted.nearest->endRow(v);
  }
  observed.floor.assign(marks + 1, marks + 1 + cells);
  observed.hit.assign(cells, 0);
  for (std::size_t slab = 0; slab < occupancy::ObservedCells::kSlabs; ++slab) {
    const std::uint8_t* const layer = marks + 1 + (1 + slab) * cells;
    for (std::size_t cell = 0; cell < cells; ++cell)
      observed.hit[cell] = static_cast<std::uint8_t>(observed.hit[cell] | layer[cell] << slab);
  }
  std::uint8_t* const occupied = occupancy.row(0);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    if (counts_points && workspace_->counts[cell] < parameters_.min_points_per_cell) observed.hit[cell] = 0;
    occupied[cell] = observed.hit[cell] != 0 ? 1 : 0;
  }
  if (wanted.nearest != nullptr) wanted.nearest->finish();
}

void Projection::markMany(std::uint32_t rows, occupancy::BinaryGrid& occupancy)
{
  const std::size_t cells = occupancy.geometry().size();
  workspace_->counts.assign(kTurns * (1 + cells), 0);
  std::uint8_t* const counts = workspace_->counts.data();
  const int enough = parameters_.min_points_per_cell;
  for (std::uint32_t v = 0; v < rows; ++v) {
    for (const CellBlock& block : workspace_->scanner.row(v)) {
#pragma GCC unroll 8
      for (std::size_t lane = 0; lane < kBlock; ++lane) {
        std::uint8_t& count = counts[kTurns * block.cell[lane] + lane % kTurns];
        count = static_cast<std::uint8_t>(count + (count < enough ? 1 : 0));
      }
    }
  }
  std::uint8_t* const occupied = occupancy.row(0);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    int sum = 0;
    for (std::size_t turn = 0; turn < kTurns; ++turn) sum += counts[kTurns * (1 + cell) + turn];
    occupied[cell] = sum >= enough ? 1 : 0;
  }
}

void Projection::collect(const PointView& points, const Eigen::Isometry3d& to_floor_frame,
                         const occupancy::GridGeometry& geometry, std::vector<Eigen::Vector3f>& standing,
                         const HeightRules& rules)
{
  standing.clear();
  CellScanner& scanner = workspace_->scanner;
  begin(points, to_floor_frame, geometry, rules, {});
  const Eigen::Isometry3f transform = to_floor_frame.cast<float>();
  for (std::uint32_t v = 0; v < points.height(); ++v) {
    for (const CellBlock& block : scanner.row(v)) {
      for (std::uint32_t lane = 0; lane < kBlock; ++lane) {
        if (block.cell[lane] == 0) continue;
        standing.emplace_back(transform * points.point(scanner.column(block, lane), v));
      }
    }
  }
}

}  // namespace polygonal_perception::perception
