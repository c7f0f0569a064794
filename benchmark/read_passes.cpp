// Measures the speed contract: how long a 640 x 480 frame of an office takes from its points to its polygons,
// in units of one read pass over the same frame's cloud. All of it is measured in turns, so that whatever
// slows the machine down slows all of it down.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "camera_frames.hpp"
#include "polygonal_perception/perception/pipeline.hpp"
#include "read_pass.hpp"

namespace polygonal_perception::benchmarks {
namespace {

constexpr int kRuns = 9;
constexpr int kTurns = 15;  // in each run, over all the frames
constexpr std::uint32_t kFrames = 4;

using Microseconds = std::chrono::duration<double, std::micro>;

double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <class Work>
double timeOf(Work&& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return Microseconds(std::chrono::steady_clock::now() - start).count();
}

/// The pipeline with one kind of input, driving round and round.
class Subject
{
public:
  Subject(Input input, perception::Products products)
      : input_(input), products_(products), pipeline_(perception::Pipeline::Parameters{})
  {
  }

  /// Processes a frame and says how long that took.
  double operator()(const CameraFrame& camera_frame)
  {
    perception::Frame frame;
    frame.points = camera_frame.view(input_);
    frame.stamp = stamp_ += kFramePeriod;
    const double time = timeOf([&] { pipeline_.process(frame, products_); });
    const perception::Pipeline::Result& result = pipeline_.result();
    if (result.floor.status != perception::FloorStatus::kFound || result.polygons.rings.empty()) {
      std::fprintf(stderr, "%s: a frame without floor or polygons: there is nothing to measure\n",
                   nameOf(input_));
      std::exit(EXIT_FAILURE);
    }
    times_.push_back(result.times);
    return time;
  }

  void printStages() const
  {
    const auto stage = [&](perception::StageTimes::Duration perception::StageTimes::*member) {
      std::vector<double> times;
      for (const perception::StageTimes& t : times_) times.push_back(Microseconds(t.*member).count());
      return median(times);
    };
    std::printf(
        "%-12s samples %5.1f us, floor %5.1f us, projection %5.1f us, inflation %5.1f us, polygons %5.1f "
        "us, planes %5.1f us, looked through %5.1f us\n",
        nameOf(input_), stage(&perception::StageTimes::samples), stage(&perception::StageTimes::floor),
        stage(&perception::StageTimes::projection), stage(&perception::StageTimes::inflation),
        stage(&perception::StageTimes::polygons), stage(&perception::StageTimes::planes),
        stage(&perception::StageTimes::looked_through));
  }

private:
  Input input_;
  perception::Products products_;
  perception::Pipeline pipeline_;
  double stamp_ = 0.0;
  std::vector<perception::StageTimes> times_;
};

/// Each frame's median over the turns of a run, summed over the frames.
class Run
{
public:
  void add(std::size_t frame, double time) { times_[frame].push_back(time); }
  double total() const
  {
    double sum = 0.0;
    for (const auto& times : times_) sum += median(times);
    return sum;
  }

private:
  std::vector<double> times_[kFrames];
};

int measure()
{
  const auto frames = drive(Surroundings::kOffice, 640, 480, kFrames);
  using perception::Product;
  Subject cloud(Input::kCloud16, Product::kPolygons);
  Subject depth(Input::kDepthMillimetres, Product::kPolygons);
  // What is given only where somebody reads it.
  Subject cloud_planes(Input::kCloud16, {Product::kPolygons, Product::kPlanes});
  Subject depth_planes(Input::kDepthMillimetres, {Product::kPolygons, Product::kPlanes});
  Subject cloud_observed(Input::kCloud16, {Product::kPolygons, Product::kObserved});
  Subject cloud_cells(Input::kCloud16, {Product::kPolygons, Product::kLookedThrough});
  Subject depth_cells(Input::kDepthMillimetres, {Product::kPolygons, Product::kLookedThrough});
  Subject depth_observed(Input::kDepthMillimetres, {Product::kPolygons, Product::kObserved});
  std::vector<double> cloud_passes;
  std::vector<double> depth_passes;
  std::vector<double> cloud_observed_passes;
  std::vector<double> depth_observed_passes;
  std::vector<double> cloud_cells_passes;
  std::vector<double> depth_cells_passes;
  volatile std::uint64_t sum = 0;

  for (int run = 0; run < kRuns; ++run) {
    Run reads;
    Run clouds;
    Run depths;
    Run clouds_observed;
    Run depths_observed;
    Run clouds_cells;
    Run depths_cells;
    for (int turn = 0; turn < kTurns; ++turn) {
      for (std::size_t k = 0; k < frames.size(); ++k) {
        const std::vector<float>& bytes = frames[k]->cloud16();
        reads.add(k, timeOf([&] { sum = readPass(bytes.data(), bytes.size() * sizeof(float)); }));
        clouds.add(k, cloud(*frames[k]));
        depths.add(k, depth(*frames[k]));
        cloud_planes(*frames[k]);
        depth_planes(*frames[k]);
        clouds_observed.add(k, cloud_observed(*frames[k]));
        depths_observed.add(k, depth_observed(*frames[k]));
        clouds_cells.add(k, cloud_cells(*frames[k]));
        depths_cells.add(k, depth_cells(*frames[k]));
      }
    }
    cloud_observed_passes.push_back((clouds_observed.total() - clouds.total()) / reads.total());
    depth_observed_passes.push_back((depths_observed.total() - depths.total()) / reads.total());
    cloud_cells_passes.push_back((clouds_cells.total() - clouds.total()) / reads.total());
    depth_cells_passes.push_back((depths_cells.total() - depths.total()) / reads.total());
    cloud_passes.push_back(clouds.total() / reads.total());
    depth_passes.push_back(depths.total() / reads.total());
    std::printf("run %d: a read pass %.1f us, cloud %.1f us (%.2f), depth %.1f us (%.2f)\n", run + 1,
                reads.total() / kFrames, clouds.total() / kFrames, cloud_passes.back(),
                depths.total() / kFrames, depth_passes.back());
  }
  for (const Subject* subject : {&cloud, &depth, &cloud_planes, &depth_planes, &cloud_observed,
                                 &depth_observed, &cloud_cells, &depth_cells})
    subject->printStages();
  std::printf(
      "read passes: cloud %.2f, depth %.2f; more for the observed grid: cloud %.2f, depth %.2f; for the "
      "observed "
      "cells: cloud %.2f, depth %.2f\n",
      median(cloud_passes), median(depth_passes), median(cloud_observed_passes),
      median(depth_observed_passes), median(cloud_cells_passes), median(depth_cells_passes));
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace polygonal_perception::benchmarks

int main()
{
  return polygonal_perception::benchmarks::measure();
}
