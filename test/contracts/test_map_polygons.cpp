// The contract of polygons holds for the map at every moment of random runs: sensors whose grids lie in any place and at any
// angle, a robot that drives and jumps, parameters that change under way.
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "polygonal_perception/geometry/location.hpp"
#include "polygonal_perception/geometry/validity.hpp"
#include "polygonal_perception/mapping/polygon_map.hpp"
#include "reference/douglas_peucker.hpp"
#include "reference/polygon_checker.hpp"
#include "reference/random_grids.hpp"
#include "support/map_lengths.hpp"

namespace polygonal_perception::test {
namespace {

using mapping::PolygonMap;

/// A frame of one of the sensors.
struct Frame
{
  occupancy::GridGeometry geometry;
  Eigen::Isometry2d pose;
  std::vector<std::uint8_t> hit, free, floor;

  mapping::Observation observation(bool may_clear, double stamp) const
  {
    return {geometry, pose, hit.data(), free.data(), floor.data(), may_clear, stamp};
  }
};

class Draw
{
public:
  explicit Draw(std::uint32_t seed) : random(seed) {}
  double between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(random);
  }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }
  bool oneIn(int times) { return whole(1, times) == 1; }
  Eigen::Vector2d step(double size) { return {between(-size, size), between(-size, size)}; }

  std::mt19937 random;
};

/// A robot that sees any shapes around itself.
class RandomRun
{
public:
  /// @param cells  of a side of the map
  RandomRun(std::uint32_t seed, int cells) : draw_(seed), cells_(cells), map_(parameters_)
  {
    constexpr double kResolutions[] = {0.05, 0.1, 0.04, 0.025, 0.2};
    resolution_ = kResolutions[draw_.random() % std::size(kResolutions)];
    drawParameters();
  }

  /// Takes in a frame more.
  void update()
  {
    if (draw_.oneIn(30)) drawParameters();
    robot_ += draw_.oneIn(40) ? draw_.step(2.0 * cells_ * resolution_) : draw_.step(2.0 * resolution_);
    drawFrame();
    map_.update(frame_.observation(!draw_.oneIn(5), stamp_ += draw_.between(0.0, 0.1)), robot_);
    PolygonMap::Products products;
    products.polygons = true;
    result_ = &map_.make(products);
  }

  /// What does not hold, or nothing.
  std::string fault()
  {
    const auto broken = reference::PolygonChecker(result_->occupied, result_->polygons,
                                                  lengths_.radiusInCells(), lengths_.limitInCells())
                            .fault();
    if (broken) return *broken;
    if (const auto defect = geometry::findDefect(rounded())) return "as a message: " + defect->text;
    return uncoveredHit();
  }

  std::string text() const
  {
    std::ostringstream text;
    text << "radius " << 1e-3 * lengths_.radius << ", tolerance " << 1e-3 * lengths_.tolerance << " cells of "
         << resolution_ << " m\n"
         << reference::toText(result_->occupied);
    return text.str();
  }

  std::size_t vertices() const { return result_->polygons.vertices.size(); }
  std::size_t verticesOfDouglasPeucker() const
  {
    constexpr std::size_t kCorners = 4;  // of a cell
    return reference::verticesOfDouglasPeucker(result_->inflated, 1e-3 * lengths_.tolerance, kCorners);
  }

private:
  /// Radii from 0 to 1 m, tolerances from 0 to 0.2 m, half of them of few cells.
  void drawParameters()
  {
    const double unit = 1e-3 * resolution_;
    const int most = draw_.oneIn(2) ? 4000 : static_cast<int>(1.0 / unit);
    lengths_.radius = draw_.oneIn(6) ? 0 : draw_.whole(0, most);
    lengths_.tolerance = draw_.oneIn(6) ? 0 : draw_.whole(0, static_cast<int>(0.2 / unit));
    lengths_.setIn(parameters_, resolution_);
    parameters_.map.map_size = (cells_ - draw_.whole(0, cells_ / 4)) * resolution_;
    parameters_.map.clear_views = draw_.whole(1, 4);
    parameters_.map.remember = draw_.oneIn(4) ? 1.0 : std::numeric_limits<double>::infinity();
    map_.configure(parameters_);
  }

  void drawFrame()
  {
    // The first one gives the map its resolution.
    const double resolution = stamp_ == 0.0 ? resolution_ : resolution_ * draw_.between(0.4, 2.5);
    const int width = draw_.whole(1, cells_);
    const int height = draw_.whole(1, cells_);
    const auto shapes = reference::randomGrid(draw_.random(), width, height, resolution, draw_.random);
    frame_.geometry = shapes.geometry();
    frame_.pose =
        Eigen::Translation2d(robot_ + draw_.step(0.5 * cells_ * resolution_)) *
        Eigen::Rotation2Dd(draw_.oneIn(3) ? 0.5 * M_PI * draw_.whole(0, 3) : draw_.between(-3.2, 3.2));
    const auto heights = static_cast<std::uint8_t>(1U << draw_.whole(0, 7) | 1U << draw_.whole(0, 7));
    const bool sees_all = draw_.oneIn(2);
    const std::size_t size = frame_.geometry.size();
    frame_.hit.assign(size, 0);
    frame_.free.assign(size, sees_all ? 0xFF : 0);
    frame_.floor.assign(size, sees_all ? 1 : 0);
    for (std::size_t cell = 0; cell < size; ++cell) {
      if (shapes.cells()[cell] != 0 && !draw_.oneIn(4)) frame_.hit[cell] = heights;
      if (!draw_.oneIn(4)) continue;
      frame_.free[cell] = static_cast<std::uint8_t>(draw_.random());
      frame_.floor[cell] = static_cast<std::uint8_t>(draw_.whole(0, 2));
    }
  }

  /// The polygons as a message has them: in single precision.
  geometry::PolygonSet rounded() const
  {
    geometry::PolygonSet polygons = result_->polygons;
    for (Eigen::Vector2d& vertex : polygons.vertices) vertex = vertex.cast<float>().cast<double>();
    return polygons;
  }

  /// A place near to a point that this frame has hit, but for what is beyond the map, that is not in the polygons.
  std::string uncoveredHit()
  {
    const Eigen::AlignedBox2d bounds = map_.map().geometry().bounds();
    const double radius = 1e-3 * lengths_.radius * resolution_;
    for (std::size_t cell = 0; cell < frame_.hit.size(); ++cell) {
      if (frame_.hit[cell] == 0 || !draw_.oneIn(8)) continue;
      const auto columns = static_cast<std::size_t>(frame_.geometry.cells_x);
      const Eigen::Vector2d corner(frame_.geometry.origin_x, frame_.geometry.origin_y);
      const Eigen::Vector2d in_cells(static_cast<double>(cell % columns) + draw_.between(0.001, 0.999),
                                     static_cast<double>(cell / columns) + draw_.between(0.001, 0.999));
      const Eigen::Vector2d point = frame_.pose * (corner + frame_.geometry.resolution * in_cells);
      if (!bounds.contains(point)) continue;
      const Eigen::Vector2d near =
          point + draw_.between(0.0, 0.999 * radius) *
                      Eigen::Rotation2Dd(draw_.between(0.0, 6.3)).toRotationMatrix().col(0);
      if (!bounds.contains(near) || geometry::locate(near, result_->polygons) != geometry::Location::kOutside)
        continue;
      std::ostringstream text;
      text << "the place (" << near.transpose() << ") beside the hit (" << point.transpose()
           << ") is outside of all polygons";
      return text.str();
    }
    return {};
  }

  Draw draw_;
  int cells_;
  double resolution_ = 0.0;
  PolygonMap::Parameters parameters_;
  MapLengths lengths_;
  PolygonMap map_;
  Frame frame_;
  Eigen::Vector2d robot_ = Eigen::Vector2d::Zero();
  double stamp_ = 0.0;
  const PolygonMap::Result* result_ = nullptr;
};

/// @param checked  so many of a run's last updates are held against the contract
void checkRuns(std::uint32_t first_seed, int runs, int updates, int checked, int least_cells, int most_cells)
{
  std::size_t vertices = 0;
  std::size_t vertices_of_douglas_peucker = 0;
  for (int n = 0; n < runs; ++n) {
    const std::uint32_t seed = first_seed + static_cast<std::uint32_t>(n);
    RandomRun run(seed, least_cells + n % (most_cells - least_cells + 1));
    for (int k = 0; k < updates; ++k) {
      run.update();
      if (k < updates - checked) continue;
      const std::string fault = run.fault();
      ASSERT_EQ(fault, "") << "run " << seed << ", update " << k << ": " << run.text();
      vertices += run.vertices();
      vertices_of_douglas_peucker += run.verticesOfDouglasPeucker();
    }
  }
  EXPECT_GT(vertices, 0U);
  EXPECT_LE(static_cast<double>(vertices), 1.2 * static_cast<double>(vertices_of_douglas_peucker));
}

TEST(MapPolygons, KeepTheContractInSmallMaps)
{
  checkRuns(1, 120, 60, 60, 4, 20);
}

TEST(MapPolygons, KeepTheContractInLargerMaps)
{
  checkRuns(1001, 12, 60, 30, 30, 50);
}

TEST(MapPolygons, KeepTheContractInAMapOfTheUsualSize)
{
  checkRuns(2001, 2, 60, 1, 240, 241);
}

}  // namespace
}  // namespace polygonal_perception::test
