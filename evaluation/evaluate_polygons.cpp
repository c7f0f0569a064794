// Holds this package's inflation and polygons against others' and against the paper's, and prints tables in
// markdown. Run through scripts/evaluate_polygons.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "inflation_methods.hpp"
#include "occupancy_frames.hpp"
#include "polygon_methods.hpp"
#include "polygon_picture.hpp"
#include "polygon_score.hpp"
#include "polygonal_perception/occupancy/grid/inflation.hpp"
#include "polygonal_perception/occupancy/polygons/polygonizer.hpp"
#include "reference/error_statistics.hpp"
#include "steadiness_table.hpp"

namespace polygonal_perception::evaluation {
namespace {

const double kRadius = occupancy::Inflation::Parameters{}.robot_radius;
const double kTolerance = occupancy::Polygonizer::Parameters{}.simplification_tolerance;
constexpr int kTurns = 9;

struct Options
{
  int frames = 6;        // of each drive
  std::string recorded;  // a frames.json
  std::string picture;   // a .png
};

template <class Work>
double microsecondsOf(Work&& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

void printHead(const std::string& first, const std::string& head, const std::string& rule)
{
  std::cout << "\n| " << first << " | " << head << "\n| " << (first.empty() ? "" : "--- | ") << rule << "\n";
}

/// In turns, so that whatever slows the machine down slows all of it down.
template <class Subjects, class Work>
std::vector<double> mediansOf(Subjects& subjects, Work&& work)
{
  std::vector<std::vector<double>> times(subjects.size());
  for (int turn = 0; turn < kTurns; ++turn) {
    for (std::size_t m = 0; m < subjects.size(); ++m)
      times[m].push_back(microsecondsOf([&] { work(*subjects[m]); }));
  }
  std::vector<double> medians;
  medians.reserve(times.size());
  for (auto& values : times) medians.push_back(reference::quantile(values, 0.5));
  return medians;
}

void compareInflation(const std::vector<OccupancySet>& sets)
{
  std::cout << "\nInflation, robot_radius 0.30 m:\n";
  printHead("method", "cells missing | cells too many | µs |", "--: | --: | --: |");
  auto methods = makeInflationMethods(kRadius, 0.05);
  std::vector<std::size_t> missing(methods.size());
  std::vector<std::size_t> extra(methods.size());
  std::vector<std::vector<double>> times(methods.size());
  occupancy::BinaryGrid inflated;
  for (const OccupancySet& set : sets) {
    for (const occupancy::BinaryGrid& grid : set.grids) {
      occupancy::BinaryGrid expected;
      methods.front()->inflate(grid, expected);
      for (std::size_t m = 0; m < methods.size(); ++m) {
        methods[m]->inflate(grid, inflated);
        for (std::size_t k = 0; k < grid.cells().size(); ++k) {
          missing[m] += expected.cells()[k] > inflated.cells()[k] ? 1 : 0;
          extra[m] += expected.cells()[k] < inflated.cells()[k] ? 1 : 0;
        }
      }
      const auto medians =
          mediansOf(methods, [&](InflationMethod& method) { method.inflate(grid, inflated); });
      for (std::size_t m = 0; m < methods.size(); ++m) times[m].push_back(medians[m]);
    }
  }
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::printf("| %s | %zu | %zu | %.1f |\n", methods[m]->name().c_str(), missing[m], extra[m],
                reference::quantile(times[m], 0.5));
  }
  std::fflush(stdout);
}

void comparePolygons(const std::vector<OccupancySet>& sets)
{
  std::cout << "\nFrom the same inflated cells, robot_radius 0.30 m, simplification_tolerance 0.05 m:\n";
  printHead("frames of | method", PolygonScore::head(), "--- | " + PolygonScore::rule());
  auto methods = makePolygonMethods();
  geometry::PolygonSet polygons;
  for (const OccupancySet& set : sets) {
    std::vector<PolygonScore> scores(methods.size());
    for (const occupancy::BinaryGrid& grid : set.grids) {
      const PolygonTask task = makePolygonTask(grid, kRadius, kTolerance);
      const PolygonReference reference = makePolygonReference(task);
      const auto medians =
          mediansOf(methods, [&](PolygonMethod& method) { method.polygonize(task, polygons); });
      for (std::size_t m = 0; m < methods.size(); ++m) {
        methods[m]->polygonize(task, polygons);
        scores[m].add(task, reference, polygons, medians[m]);
      }
    }
    for (std::size_t m = 0; m < methods.size(); ++m)
      std::cout << "| " << set.name << " | " << methods[m]->name() << " | " << scores[m].row() << std::endl;
  }
}

/// Inflation and polygons of this package beside section IV of the paper.
void compareTimes(const std::vector<OccupancySet>& sets)
{
  std::cout << "\nInflation and polygons together:\n";
  printHead("frames of", "paper µs | this package µs | ratio: median | 95 % |", "--: | --: | --: | --: |");
  auto inflations = makeInflationMethods(kRadius, 0.05);
  auto methods = makePolygonMethods();
  const auto isPaper = [](const auto& method) { return method->name().find("paper") != std::string::npos; };
  const auto inflate = std::find_if(inflations.begin(), inflations.end(), isPaper);
  const auto outline = std::find_if(methods.begin(), methods.end(), isPaper);
  struct Way
  {
    InflationMethod& inflation;
    PolygonMethod& polygons;
  };
  Way paper{**inflate, **outline};
  Way own{*inflations.front(), *methods.front()};
  const std::vector<Way*> ways{&paper, &own};
  geometry::PolygonSet polygons;
  for (const OccupancySet& set : sets) {
    std::vector<double> times[2];
    std::vector<double> ratios;
    for (const occupancy::BinaryGrid& grid : set.grids) {
      PolygonTask task = makePolygonTask(grid, kRadius, kTolerance);
      const auto medians = mediansOf(ways, [&](Way& way) {
        way.inflation.inflate(task.occupancy, task.inflated);
        way.polygons.polygonize(task, polygons);
      });
      times[0].push_back(medians[0]);
      times[1].push_back(medians[1]);
      ratios.push_back(medians[1] / medians[0]);
    }
    std::printf("| %s | %.1f | %.1f | %.2f | %.2f |\n", set.name.c_str(), reference::quantile(times[0], 0.5),
                reference::quantile(times[1], 0.5), reference::quantile(ratios, 0.5),
                reference::quantile(ratios, 0.95));
  }
  std::fflush(stdout);
}

/// On a part of the frames, as there are many settings.
void scoreSettings(const std::vector<OccupancySet>& sets)
{
  constexpr std::size_t kEvery = 4;
  std::cout << "\nThis package, every fourth frame:\n";
  printHead("robot_radius | simplification_tolerance", PolygonScore::head(), "--: | " + PolygonScore::rule());
  auto methods = makePolygonMethods();
  geometry::PolygonSet polygons;
  for (const double radius : {0.0, 0.05, 0.11, 0.225, 0.30}) {
    for (const double tolerance : {0.0, 0.03, 0.05, 0.15}) {
      PolygonScore score;
      for (const OccupancySet& set : sets) {
        for (std::size_t k = 0; k < set.grids.size(); k += kEvery) {
          const PolygonTask task = makePolygonTask(set.grids[k], radius, tolerance);
          const double time = microsecondsOf([&] { methods.front()->polygonize(task, polygons); });
          score.add(task, makePolygonReference(task), polygons, time);
        }
      }
      std::cout << "| " << radius << " | " << tolerance << " | " << score.row() << std::endl;
    }
  }
}

int usage()
{
  std::cerr << "usage: evaluate_polygons [--frames N] [--recorded FRAMES.json] [--picture FILE.png]\n"
               "  --frames    of each drive (6)\n"
               "  --recorded  also recorded frames, in the form that README.md describes\n"
               "  --picture   only draws an office frame's cells and polygons, before and after\n";
  return 2;
}

bool parse(int argc, char** argv, Options& options)
{
  for (int k = 1; k < argc; k += 2) {
    const std::string argument = argv[k];
    if (k + 1 == argc) return false;
    const char* const value = argv[k + 1];
    if (argument == "--frames") {
      options.frames = std::atoi(value);
    } else if (argument == "--recorded") {
      options.recorded = value;
    } else if (argument == "--picture") {
      options.picture = value;
    } else {
      return false;
    }
  }
  return options.frames > 0;
}

void evaluate(const Options& options)
{
  constexpr int kDrives = 3;
  std::vector<OccupancySet> sets;
  for (const char* const scene : {"office", "busy_office", "doorway"})
    sets.push_back(renderOccupancy(scene, kDrives, options.frames));
  if (!options.recorded.empty()) sets.push_back(readOccupancy(options.recorded));
  const std::vector<OccupancySet> frames = sets;
  sets.push_back(randomOccupancy(4 * options.frames));
  compareInflation(sets);
  compareTimes(sets);
  comparePolygons(sets);
  scoreSettings(frames);
  printSteadiness(5 * options.frames);
}

}  // namespace
}  // namespace polygonal_perception::evaluation

int main(int argc, char** argv)
{
  using namespace polygonal_perception::evaluation;
  Options options;
  if (!parse(argc, argv, options)) return usage();
  try {
    if (options.picture.empty()) {
      evaluate(options);
    } else {
      drawBeforeAndAfter(options.picture);
    }
  } catch (const std::exception& error) {
    std::cerr << "evaluate_polygons: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
