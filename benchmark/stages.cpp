// Each stage and the whole pipeline, over inputs, image sizes, numbers of samples and surroundings.

#include <benchmark/benchmark.h>

#include <cstring>
#include <initializer_list>
#include <map>
#include <string>
#include <tuple>

#include "camera_frames.hpp"
#include "polygonal_perception/floor_frame.hpp"
#include "polygonal_perception/pipeline.hpp"
#include "projection_kernel.hpp"
#include "read_pass.hpp"

namespace polygonal_perception {
namespace benchmarks {
namespace {

struct Size
{
  const char* name;
  std::uint32_t width;
  std::uint32_t height;
};

constexpr Size kSizes[] = {
    {"QQVGA", 160, 120}, {"QVGA", 320, 240}, {"VGA", 640, 480}, {"720p", 1280, 720}, {"1080p", 1920, 1080}};
constexpr Size kVga = kSizes[2];
constexpr Input kInputs[] = {Input::kCloud16, Input::kCloud32, Input::kDepthMillimetres, Input::kDepthMetres};
constexpr Surroundings kSurroundings[] = {Surroundings::kOffice, Surroundings::kEmpty};

std::string nameOf(Surroundings surroundings)
{
  return surroundings == Surroundings::kOffice ? "office" : "empty";
}

std::string joined(std::initializer_list<std::string> parts)
{
  std::string name;
  for (const std::string& part : parts) name += (name.empty() ? "" : "/") + part;
  return name;
}

/// The first frame of a drive, rendered when it is first asked for.
const CameraFrame& frameOf(Surroundings surroundings, const Size& size)
{
  static std::map<std::tuple<Surroundings, std::string>, std::vector<std::unique_ptr<CameraFrame>>> drives;
  auto& frames = drives[{surroundings, size.name}];
  if (frames.empty()) frames = drive(surroundings, size.width, size.height, 1);
  return *frames.front();
}

Eigen::Isometry3d toFloorFrame(const CameraFrame& frame)
{
  return floorFrame(frame.floor(), Eigen::Vector3d::UnitZ());
}

void countPixels(benchmark::State& state, const Size& size)
{
  state.counters["pixels"] = static_cast<double>(size.width) * size.height;
}

void readPassOf(benchmark::State& state, const Size& size)
{
  const std::vector<float>& cloud = frameOf(Surroundings::kOffice, size).cloud16();
  for (auto _ : state) benchmark::DoNotOptimize(readPass(cloud.data(), cloud.size() * sizeof(float)));
  countPixels(state, size);
}

void copyOf(benchmark::State& state, const Size& size)
{
  const std::vector<float>& cloud = frameOf(Surroundings::kOffice, size).cloud16();
  std::vector<float> copy(cloud.size());
  for (auto _ : state) {
    std::memcpy(copy.data(), cloud.data(), cloud.size() * sizeof(float));
    benchmark::ClobberMemory();
  }
  countPixels(state, size);
}

void samplesOf(benchmark::State& state, Input input, int samples)
{
  SampleGrid grid(SampleGrid::Parameters{samples, samples});
  const PointView points = frameOf(Surroundings::kOffice, kVga).view(input);
  for (auto _ : state) grid.update(points);
  state.counters["samples"] = samples * samples;
}

void floorOf(benchmark::State& state, Input input, int samples)
{
  SampleGrid grid(SampleGrid::Parameters{samples, samples});
  FloorTracker tracker(FloorTracker::Parameters{}, FloorDetector::Parameters{});
  const PointView points = frameOf(Surroundings::kOffice, kVga).view(input);
  grid.update(points);
  double stamp = 0.0;
  for (auto _ : state) tracker.update(points, grid, stamp += kFramePeriod, std::nullopt);
  if (tracker.state().status != FloorStatus::kFound) state.SkipWithError("no floor");
  state.counters["samples"] = samples * samples;
}

void projectionOf(benchmark::State& state, Input input, Surroundings surroundings, const Size& size,
                  const ProjectionKernel& kernel, int min_points_per_cell)
{
  Projection::Parameters parameters;
  parameters.min_points_per_cell = min_points_per_cell;
  Projection projection(parameters, kernel);
  const CameraFrame& frame = frameOf(surroundings, size);
  const PointView points = frame.view(input);
  const Eigen::Isometry3d to_floor = toFloorFrame(frame);
  BinaryGrid grid{GridGeometry(GridParameters{})};
  for (auto _ : state) projection.project(points, to_floor, grid);
  countPixels(state, size);
}

void collectionOf(benchmark::State& state, Input input)
{
  Projection projection{Projection::Parameters{}};
  const CameraFrame& frame = frameOf(Surroundings::kOffice, kVga);
  const PointView points = frame.view(input);
  const Eigen::Isometry3d to_floor = toFloorFrame(frame);
  std::vector<Eigen::Vector3f> standing;
  for (auto _ : state) projection.collect(points, to_floor, GridGeometry(GridParameters{}), standing);
  state.counters["points"] = static_cast<double>(standing.size());
}

/// The office's occupied cells.
BinaryGrid occupancyOf(const CameraFrame& frame)
{
  BinaryGrid grid{GridGeometry(GridParameters{})};
  Projection(Projection::Parameters{}).project(frame.view(Input::kCloud16), toFloorFrame(frame), grid);
  return grid;
}

void inflationOf(benchmark::State& state)
{
  const BinaryGrid occupancy = occupancyOf(frameOf(Surroundings::kOffice, kVga));
  Inflation inflation{Inflation::Parameters{}};
  BinaryGrid inflated(occupancy.geometry());
  for (auto _ : state) inflation.inflate(occupancy, inflated);
}

void polygonsOf(benchmark::State& state)
{
  const BinaryGrid occupancy = occupancyOf(frameOf(Surroundings::kOffice, kVga));
  const Inflation::Parameters inflation;
  BinaryGrid inflated(occupancy.geometry());
  Inflation(inflation).inflate(occupancy, inflated);
  Polygonizer polygonizer{Polygonizer::Parameters{}};
  PolygonSet polygons;
  for (auto _ : state) polygonizer.polygonize(occupancy, inflated, inflation.robot_radius, polygons);
  state.counters["vertices"] = static_cast<double>(polygons.vertices.size());
}

void pipelineOf(benchmark::State& state, Input input, Surroundings surroundings, const Size& size,
                int samples)
{
  Pipeline::Parameters parameters;
  parameters.samples = SampleGrid::Parameters{samples, samples};
  Pipeline pipeline(parameters);
  Frame frame;
  frame.points = frameOf(surroundings, size).view(input);
  for (auto _ : state) {
    frame.stamp += kFramePeriod;
    pipeline.process(frame);
  }
  if (pipeline.result().floor.status != FloorStatus::kFound) state.SkipWithError("no floor");
  countPixels(state, size);
  state.counters["samples"] = samples * samples;
}

template <class... Arguments>
void add(std::initializer_list<std::string> name, Arguments&&... arguments)
{
  benchmark::RegisterBenchmark(joined(name).c_str(), std::forward<Arguments>(arguments)...)
      ->Unit(benchmark::kMicrosecond);
}

void registerAll()
{
  const ProjectionKernel& widest = projectionKernels().back();
  for (const Size& size : kSizes) {
    add({"read_pass", size.name}, readPassOf, size);
    add({"memcpy", size.name}, copyOf, size);
  }
  for (const Input input : kInputs) {
    const std::string of = nameOf(input);
    for (const int samples : {16, 32, 64, 128}) {
      const std::string grid = std::to_string(samples) + "x" + std::to_string(samples);
      add({"samples", of, grid}, samplesOf, input, samples);
      add({"floor", of, grid}, floorOf, input, samples);
      add({"pipeline", of, "office", "VGA", grid}, pipelineOf, input, Surroundings::kOffice, kVga, samples);
    }
    for (const Surroundings surroundings : kSurroundings) {
      for (const Size& size : kSizes) {
        add({"projection", of, nameOf(surroundings), size.name}, projectionOf, input, surroundings, size,
            widest, 1);
        add({"pipeline", of, nameOf(surroundings), size.name}, pipelineOf, input, surroundings, size, 32);
      }
    }
    for (const ProjectionKernel& kernel : projectionKernels()) {
      add({"projection", of, "office", "VGA", kernel.name}, projectionOf, input, Surroundings::kOffice, kVga,
          kernel, 1);
    }
    add({"projection", of, "office", "VGA", "min_points_per_cell:3"}, projectionOf, input,
        Surroundings::kOffice, kVga, widest, 3);
    add({"obstacle_points", of}, collectionOf, input);
  }
  add({"inflation"}, inflationOf);
  add({"polygons"}, polygonsOf);
}

}  // namespace
}  // namespace benchmarks
}  // namespace polygonal_perception

int main(int argc, char** argv)
{
  polygonal_perception::benchmarks::registerAll();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
