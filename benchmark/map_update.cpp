// Measures what the map costs: one frame's observed cells into a map of 12 x 12 m with cells of 5 cm, and its polygons,
// over a drive through an office that goes round and round. It must not grow with the run.

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "polygonal_perception/mapping/polygon_map.hpp"
#include "reference/observed_drive.hpp"

namespace polygonal_perception::benchmarks {
namespace {

constexpr int kRounds = 540;  // 30 minutes at 30 Hz

/// [us] Medians of an update's stages.
struct Medians
{
  double update, grids, inflation, polygons, all;
};

Medians mediansOf(const std::vector<mapping::PolygonMap::StageTimes>& times)
{
  using Times = mapping::PolygonMap::StageTimes;
  const auto median = [&](auto&& pick) {
    std::vector<double> values;
    for (const Times& t : times) values.push_back(1e-3 * static_cast<double>(pick(t).count()));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
  };
  return {median([](const Times& t) { return t.update; }), median([](const Times& t) { return t.grids; }),
          median([](const Times& t) { return t.inflation; }),
          median([](const Times& t) { return t.polygons; }),
          median([](const Times& t) { return t.update + t.grids + t.inflation + t.polygons; })};
}

/// [MB] Memory that is in use.
double residentMemory()
{
  std::ifstream file("/proc/self/statm");
  double all = 0.0;
  double resident = 0.0;
  file >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

int measure()
{
  const std::vector<reference::ObservedFrame> recorded = reference::observedDrive();
  mapping::PolygonMap map{mapping::PolygonMap::Parameters{}};
  mapping::PolygonMap::Products products;
  products.polygons = true;
  double stamp = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<mapping::PolygonMap::StageTimes> times;
    std::size_t vertices = 0;
    for (const reference::ObservedFrame& one : recorded) {
      map.update({one.geometry, one.pose, one.cells.hit.data(), one.cells.free.data(), one.cells.floor.data(),
                  true, stamp += 1.0 / 30.0},
                 one.robot);
      const auto& result = map.make(products);
      times.push_back(result.times);
      vertices = result.polygons.vertices.size();
    }
    if (round != 1 && round != kRounds - 1) continue;  // the first one grows into its memory
    const Medians m = mediansOf(times);
    std::printf(
        "round %3d: update %.0f us, grids %.0f us, inflation %.0f us, polygons %.0f us; all %.0f us, "
        "%zu vertices, %.1f MB\n",
        round + 1, m.update, m.grids, m.inflation, m.polygons, m.all, vertices, residentMemory());
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace polygonal_perception::benchmarks

int main()
{
  return polygonal_perception::benchmarks::measure();
}
