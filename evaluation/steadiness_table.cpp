#include "steadiness_table.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "error_statistics.hpp"
#include "hausdorff.hpp"
#include "still_view.hpp"

namespace polygonal_perception {
namespace evaluation {
namespace {

constexpr int kMinPoints[] = {1, 2, 3, 5, 8};
constexpr std::uint64_t kViews = 3;

bool anyNeighbourOccupied(const BinaryGrid& grid, int i, int j)
{
  for (int y = std::max(0, j - 1); y <= std::min(grid.cellsY() - 1, j + 1); ++y) {
    for (int x = std::max(0, i - 1); x <= std::min(grid.cellsX() - 1, i + 1); ++x) {
      if (grid.occupied(x, y)) return true;
    }
  }
  return false;
}

class Losses
{
public:
  void add(const BinaryGrid& truth, const BinaryGrid& seen)
  {
    for (int j = 0; j < truth.cellsY(); ++j) {
      for (int i = 0; i < truth.cellsX(); ++i) {
        if (!truth.occupied(i, j)) continue;
        ++cells_;
        free_ += seen.occupied(i, j) ? 0 : 1;
        missed_ += anyNeighbourOccupied(seen, i, j) ? 0 : 1;
      }
    }
  }
  void add(const Losses& other)
  {
    cells_ += other.cells_;
    free_ += other.free_;
    missed_ += other.missed_;
  }
  double freeShare() const { return share(free_); }
  double missedShare() const { return share(missed_); }

private:
  double share(std::size_t count) const
  {
    return cells_ > 0 ? static_cast<double>(count) / static_cast<double>(cells_) : 0.0;
  }

  std::size_t cells_ = 0;
  std::size_t free_ = 0;
  std::size_t missed_ = 0;  // free, and all cells around, too
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
    std::printf("| %s | %d | %.3f | %.3f | %.3f | %.1f %% | %.2f %% |\n", name.c_str(), min_points,
                quantile(moves, 0.5), quantile(moves, 0.95), quantile(moves, 1.0), 100.0 * losses.freeShare(),
                100.0 * losses.missedShare());
    std::fflush(stdout);
  }
};

/// Of the same frames for each of kMinPoints.
std::vector<Steadiness> measure(StillView& view, int frames)
{
  const BinaryGrid truth = Pipeline(Pipeline::Parameters{}).process(view.ideal()).occupancy;
  std::vector<Pipeline> pipelines;
  for (const int min_points : kMinPoints) {
    Pipeline::Parameters parameters;
    parameters.projection.min_points_per_cell = min_points;
    pipelines.emplace_back(parameters);
  }
  std::vector<Steadiness> measured(pipelines.size());
  std::vector<PolygonSet> last(pipelines.size());
  for (int k = 0; k < frames; ++k) {
    const Frame frame = view.frame(static_cast<std::uint32_t>(k));
    for (std::size_t n = 0; n < pipelines.size(); ++n) {
      const Pipeline::Result& result = pipelines[n].process(frame);
      if (k > 0) measured[n].moves.push_back(hausdorffDistance(last[n], result.polygons));
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
      "\n| scene | min_points_per_cell | moved [m]: median | 95 %% | max | cells free | cells missed |\n"
      "| --- | --: | --: | --: | --: | --: | --: |\n");
  std::vector<Steadiness> all(std::size(kMinPoints));
  for (const char* const scene : {"office", "busy_office", "person", "doorway", "corridor"}) {
    std::vector<Steadiness> of_scene(std::size(kMinPoints));
    for (std::uint64_t seed = 1; seed <= kViews; ++seed) {
      StillView view(scene, seed);
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

}  // namespace evaluation
}  // namespace polygonal_perception
