#include "reference/course_run.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/error_statistics.hpp"

namespace polygonal_perception::reference {
namespace {

using occupancy::BinaryGrid;
using simulation::Surface;

simulation::SimulatedCamera::Options cameraOptions(const CourseRun::Options& options)
{
  simulation::SimulatedCamera::Options camera;
  camera.scene = options.course;
  camera.seed = options.seed;
  camera.rate = options.rate;
  camera.camera = simulation::PinholeCamera::ofSize(320, 240);
  return camera;
}

/// The greatest value of a cell and its eight neighbours.
template <class ValueOf>
int greatestAround(const BinaryGrid& grid, int i, int j, ValueOf&& valueOf)
{
  int greatest = 0;
  for (int y = std::max(0, j - 1); y <= std::min(grid.cellsY() - 1, j + 1); ++y) {
    for (int x = std::max(0, i - 1); x <= std::min(grid.cellsX() - 1, i + 1); ++x)
      greatest = std::max(greatest, valueOf(static_cast<std::size_t>(y * grid.cellsX() + x)));
  }
  return greatest;
}

}  // namespace

CourseRun::CourseRun(const Options& options)
    : camera_(cameraOptions(options)),
      rays_([this] {
        const simulation::PinholeCamera& camera = camera_.options().camera;
        return perception::PinholeRays::make(camera.width, camera.height, camera.fx, camera.fy, camera.cx,
                                             camera.cy);
      }()),
      pipeline_(options.parameters)
{
  if (!options.has_mount) return;
  const Eigen::Isometry3d camera_to_base = camera_.base(0).inverse() * camera_.pose(0);
  hints_.mount = geometry::Plane{camera_to_base.linear().row(2), camera_to_base.translation().z()};
}

CourseFrame CourseRun::next()
{
  camera_.render(index_++, frame_);
  const std::uint32_t width = camera_.options().camera.width;
  pipeline_.process(
      {perception::PointView::depth(frame_.depth.data(), width * sizeof(float), rays_), frame_.time, hints_});
  CourseFrame rating;
  rating.x = frame_.base_to_world.translation().x();
  rating.status = result().floor.status;
  if (rating.status == perception::FloorStatus::kNotFound) return rating;
  rateFloor(rating);
  findObstacles();
  rateCells(rating);
  return rating;
}

void CourseRun::rateFloor(CourseFrame& rating) const
{
  const geometry::Plane& found = result().floor.floor.plane;
  rating.degrees = normalError(found, frame_.floor);
  rating.millimetres = heightError(found, frame_.floor);
  const Eigen::Vector3d up = frame_.base_to_world.linear().col(2);
  const auto standsOn = [&up](const Eigen::Vector3d& normal) { return up.dot(normal) > 1.0 - 1e-9; };
  const bool is_on_floor = standsOn(Eigen::Vector3d::UnitZ());
  const auto& grounds = scene().grounds;
  rating.is_on_edge = !is_on_floor && std::none_of(grounds.begin(), grounds.end(), [&](const auto& ground) {
    return standsOn(ground.plane.normal);
  });
}

void CourseRun::findObstacles()
{
  constexpr double kHeightMargin = 0.02;  // [m] of noise and of the floor's error
  const occupancy::GridGeometry& grid = result().occupancy.geometry();
  const auto& heights = pipeline_.parameters().projection;
  const std::size_t columns = rays_.column_slope.size();
  possible_.assign(grid.size(), 0);
  plain_.assign(grid.size(), 0);
  for (std::size_t k = 0; k < frame_.depth.size(); ++k) {
    // Where the sensor has nothing to say there is nothing to hold it against.
    if (frame_.truth.surface[k] != Surface::kObstacle || !(frame_.depth[k] > 0.0F)) continue;
    const Eigen::Vector3d point = frame_.truth.depth[k] * Eigen::Vector3d(rays_.column_slope[k % columns],
                                                                          rays_.row_slope[k / columns], 1.0);
    const Eigen::Vector3d in_world = frame_.camera_to_world * point;
    const double height = in_world.z() - scene().groundHeight(in_world.head<2>());
    const double slack = std::min(height - heights.min_height, heights.max_height - height);
    if (slack < -kHeightMargin) continue;
    const Eigen::Vector3d on_floor = result().to_floor_frame * point;
    const int i = static_cast<int>(std::floor((on_floor.x() - grid.origin_x) / grid.resolution));
    const int j = static_cast<int>(std::floor((on_floor.y() - grid.origin_y) / grid.resolution));
    if (i < 0 || i >= grid.cells_x || j < 0 || j >= grid.cells_y) continue;
    const auto cell = static_cast<std::size_t>(j * grid.cells_x + i);
    possible_[cell] = 1;
    plain_[cell] += slack > kHeightMargin ? 1 : 0;
  }
}

bool CourseRun::isFalse(int i, int j) const
{
  return greatestAround(result().occupancy, i, j, [this](std::size_t cell) { return possible_[cell]; }) == 0;
}

void CourseRun::rateCells(CourseFrame& rating) const
{
  constexpr int kPlainly = 4;  // points in a cell
  const BinaryGrid& grid = result().occupancy;
  const occupancy::GridGeometry& geometry = grid.geometry();
  for (int j = 0; j < geometry.cells_y; ++j) {
    for (int i = 0; i < geometry.cells_x; ++i) {
      const double x = geometry.origin_x + (i + 0.5) * geometry.resolution;
      if (grid.occupied(i, j) && isFalse(i, j))
        ++(x < CourseFrame::kNear ? rating.false_cells : rating.false_far_cells);
      if (plain_[static_cast<std::size_t>(j * geometry.cells_x + i)] < kPlainly || x > CourseFrame::kFar)
        continue;
      ++rating.obstacle_cells;
      const int seen =
          greatestAround(grid, i, j, [&grid](std::size_t cell) { return int{grid.cells()[cell]}; });
      rating.missed_cells += seen == 0 ? 1 : 0;
    }
  }
}

}  // namespace polygonal_perception::reference
