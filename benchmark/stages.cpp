// Each stage and the whole pipeline, over inputs, image sizes, numbers of samples and surroundings.

#include <benchmark/benchmark.h>

#include <cstring>
#include <initializer_list>
#include <map>
#include <string>
#include <tuple>

#include "camera_frames.hpp"
#include "perception/grid/projection_kernel.hpp"
#include "polygonal_perception/perception/floor/floor_frame.hpp"
#include "polygonal_perception/perception/pipeline.hpp"
#include "read_pass.hpp"

namespace polygonal_perception::benchmarks {
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
  return perception::floorFrame(frame.floor(), perception::ViewAxes{});
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
  perception::SampleGrid grid(perception::SampleGrid::Parameters{samples, samples});
  const perception::PointView points = frameOf(Surroundings::kOffice, kVga).view(input);
  for (auto _ : state) grid.update(points);
  state.counters["samples"] = samples * samples;
}

void floorOf(benchmark::State& state, Input input, int samples)
{
  perception::SampleGrid grid(perception::SampleGrid::Parameters{samples, samples});
  perception::FloorTracker tracker(perception::FloorTracker::Parameters{},
                                   perception::FloorDetector::Parameters{});
  const perception::PointView points = frameOf(Surroundings::kOffice, kVga).view(input);
  grid.update(points);
  double stamp = 0.0;
  for (auto _ : state) tracker.update(points, grid, stamp += kFramePeriod, {});
  if (tracker.state().status != perception::FloorStatus::kFound) state.SkipWithError("no floor");
  state.counters["samples"] = samples * samples;
}

void projectionOf(benchmark::State& state, Input input, Surroundings surroundings, const Size& size,
                  const perception::ProjectionKernel& kernel, int min_points_per_cell)
{
  perception::Projection::Parameters parameters;
  parameters.min_points_per_cell = min_points_per_cell;
  perception::Projection projection(parameters, kernel);
  const CameraFrame& frame = frameOf(surroundings, size);
  const perception::PointView points = frame.view(input);
  const Eigen::Isometry3d to_floor = toFloorFrame(frame);
  occupancy::BinaryGrid grid{occupancy::GridGeometry(occupancy::GridParameters{})};
  for (auto _ : state) projection.project(points, to_floor, grid);
  countPixels(state, size);
}

void collectionOf(benchmark::State& state, Input input)
{
  perception::Projection projection{perception::Projection::Parameters{}};
  const CameraFrame& frame = frameOf(Surroundings::kOffice, kVga);
  const perception::PointView points = frame.view(input);
  const Eigen::Isometry3d to_floor = toFloorFrame(frame);
  std::vector<Eigen::Vector3f> standing;
  for (auto _ : state)
    projection.collect(points, to_floor, occupancy::GridGeometry(occupancy::GridParameters{}), standing);
  state.counters["points"] = static_cast<double>(standing.size());
}

/// The office's occupied cells.
occupancy::BinaryGrid occupancyOf(const CameraFrame& frame)
{
  occupancy::BinaryGrid grid{occupancy::GridGeometry(occupancy::GridParameters{})};
  perception::Projection(perception::Projection::Parameters{})
      .project(frame.view(Input::kCloud16), toFloorFrame(frame), grid);
  return grid;
}

void inflationOf(benchmark::State& state)
{
  const occupancy::BinaryGrid occupancy = occupancyOf(frameOf(Surroundings::kOffice, kVga));
  occupancy::Inflation inflation{occupancy::Inflation::Parameters{}};
  occupancy::BinaryGrid inflated(occupancy.geometry());
  for (auto _ : state) inflation.inflate(occupancy, inflated);
}

void polygonsOf(benchmark::State& state)
{
  const occupancy::BinaryGrid occupancy = occupancyOf(frameOf(Surroundings::kOffice, kVga));
  const occupancy::Inflation::Parameters inflation;
  occupancy::BinaryGrid inflated(occupancy.geometry());
  occupancy::Inflation(inflation).inflate(occupancy, inflated);
  occupancy::Polygonizer polygonizer{occupancy::Polygonizer::Parameters{}};
  geometry::PolygonSet polygons;
  for (auto _ : state) polygonizer.polygonize(occupancy, inflated, inflation.robot_radius, polygons);
  state.counters["vertices"] = static_cast<double>(polygons.vertices.size());
}

void pipelineOf(benchmark::State& state, Input input, Surroundings surroundings, const Size& size,
                int samples)
{
  perception::Pipeline::Parameters parameters;
  parameters.samples = perception::SampleGrid::Parameters{samples, samples};
  perception::Pipeline pipeline(parameters);
  perception::Frame frame;
  frame.points = frameOf(surroundings, size).view(input);
  for (auto _ : state) {
    frame.stamp += kFramePeriod;
    pipeline.process(frame);
  }
  if (pipeline.result().floor.status != perception::FloorStatus::kFound) state.SkipWithError("no floor");
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
  const perception::ProjectionKernel& widest = perception::projectionKernels().back();
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
    for (const perception::ProjectionKernel& kernel : perception::projectionKernels()) {
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
}  // namespace polygonal_perception::benchmarks

int main(int argc, char** argv)
{
  polygonal_perception::benchmarks::registerAll();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
