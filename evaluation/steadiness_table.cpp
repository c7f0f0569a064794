#include "steadiness_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "reference/error_statistics.hpp"
#include "reference/hausdorff.hpp"
#include "reference/still_view.hpp"

namespace polygonal_perception::evaluation {
namespace {

constexpr int kMinPoints[] = {1, 2, 3, 5, 8};
constexpr double kFar = 2.5;  // [m]
constexpr std::uint64_t kViews = 3;

bool anyNeighbourOccupied(const occupancy::BinaryGrid& grid, int i, int j)
{
  for (int y = std::max(0, j - 1); y <= std::min(grid.cellsY() - 1, j + 1); ++y) {
    for (int x = std::max(0, i - 1); x <= std::min(grid.cellsX() - 1, i + 1); ++x) {
      if (grid.occupied(x, y)) return true;
    }
  }
  return false;
}

/// Cells in which something is to be seen, but that are not occupied.
class Losses
{
public:
  void add(const occupancy::BinaryGrid& truth, const occupancy::BinaryGrid& seen)
  {
    const occupancy::GridGeometry& geometry = truth.geometry();
    for (int j = 0; j < truth.cellsY(); ++j) {
      for (int i = 0; i < truth.cellsX(); ++i) {
        if (!truth.occupied(i, j)) continue;
        const double range = std::hypot(geometry.origin_x + i * geometry.resolution,
                                        geometry.origin_y + j * geometry.resolution);
        Counts& counts = counts_[range < kFar ? 0 : 1];
        ++counts.cells;
        counts.free += seen.occupied(i, j) ? 0 : 1;
        counts.missed += anyNeighbourOccupied(seen, i, j) ? 0 : 1;
      }
    }
  }
  void add(const Losses& other)
  {
    for (std::size_t n = 0; n < std::size(counts_); ++n) {
      counts_[n].cells += other.counts_[n].cells;
      counts_[n].free += other.counts_[n].free;
      counts_[n].missed += other.counts_[n].missed;
    }
  }
  /// The rest of a row.
  std::string row() const
  {
    char text[80];
    std::snprintf(text, sizeof text, "%.1f %% | %.1f %% | %.2f %% | %.2f %% |", near().percent(near().free),
                  far().percent(far().free), near().percent(near().missed), far().percent(far().missed));
    return text;
  }

private:
  struct Counts
  {
    std::size_t cells = 0;
    std::size_t free = 0;
    std::size_t missed = 0;  // free, and all cells around, too

    double percent(std::size_t count) const
    {
      return 100.0 * static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(1, cells));
    }
  };
  const Counts& near() const { return counts_[0]; }
  const Counts& far() const { return counts_[1]; }

  Counts counts_[2];
};

struct Steadiness
{
  std::vector<double> moves;  // [m] Hausdorff distances between successive frames
  Losses losses;

  void add(const Steadiness& other)
  {
    moves.insert(moves.end(), other.moves.begin(), other.moves.end());
    losses.add(other.losses);
  }
  void print(const std::string& name, int min_points) const
  {
    std::printf("| %s | %d | %.3f | %.3f | %.3f | %s\n", name.c_str(), min_points,
                reference::quantile(moves, 0.5), reference::quantile(moves, 0.95),
                reference::quantile(moves, 1.0), losses.row().c_str());
    std::fflush(stdout);
  }
};

/// Of the same frames for each of kMinPoints.
std::vector<Steadiness> measure(reference::StillView& view, int frames)
{
  const occupancy::BinaryGrid truth =
      perception::Pipeline(perception::Pipeline::Parameters{}).process(view.ideal()).occupancy;
  std::vector<perception::Pipeline> pipelines;
  for (const int min_points : kMinPoints) {
    perception::Pipeline::Parameters parameters;
    parameters.projection.min_points_per_cell = min_points;
    pipelines.emplace_back(parameters);
  }
  std::vector<Steadiness> measured(pipelines.size());
  std::vector<geometry::PolygonSet> last(pipelines.size());
  for (int k = 0; k < frames; ++k) {
    const perception::Frame frame = view.frame(static_cast<std::uint32_t>(k));
    for (std::size_t n = 0; n < pipelines.size(); ++n) {
      const perception::Pipeline::Result& result = pipelines[n].process(frame);
      if (k > 0) measured[n].moves.push_back(reference::hausdorffDistance(last[n], result.polygons));
      last[n] = result.polygons;
      measured[n].losses.add(truth, result.occupancy);
    }
  }
  return measured;
}

}  // namespace

void printSteadiness(int frames)
{
  std::printf("\nA still camera over a still scene, %d frames of each of %d views:\n", frames,
              static_cast<int>(kViews));
  std::printf(
      "\n| scene | min_points_per_cell | moved [m]: median | 95 %% | max | free: < %.1f m | beyond | missed: "
      "< %.1f "
      "m | beyond |\n| --- | --: | --: | --: | --: | --: | --: | --: | --: |\n",
      kFar, kFar);
  std::vector<Steadiness> all(std::size(kMinPoints));
  for (const char* const scene : {"office", "busy_office", "person", "doorway", "corridor"}) {
    std::vector<Steadiness> of_scene(std::size(kMinPoints));
    for (std::uint64_t seed = 1; seed <= kViews; ++seed) {
      reference::StillView view(scene, seed);
      const std::vector<Steadiness> of_view = measure(view, frames);
      for (std::size_t n = 0; n < of_view.size(); ++n) of_scene[n].add(of_view[n]);
    }
    for (std::size_t n = 0; n < of_scene.size(); ++n) {
      of_scene[n].print(scene, kMinPoints[n]);
      all[n].add(of_scene[n]);
    }
  }
  for (std::size_t n = 0; n < std::size(kMinPoints); ++n) all[n].print("all", kMinPoints[n]);
}

}  // namespace polygonal_perception::evaluation
