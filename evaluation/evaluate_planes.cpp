// Holds the planes of rendered frames against those of their scenes, and prints tables in markdown. Run through
// scripts/evaluate_planes.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "plane_picture.hpp"
#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "polygonal_perception/perception/pipeline.hpp"
#include "reference/error_statistics.hpp"
#include "reference/plane_checker.hpp"
#include "reference/recorded_frames.hpp"

namespace polygonal_perception::evaluation {
namespace {

struct Options
{
  int frames = 12;
  std::uint64_t seed = 1;
  int samples = 32;
  std::string scene;
  std::string pictures;  // a folder
  std::string recorded;  // a frames.json
  bool faults = false;
  bool ablate = false;
};

struct Row
{
  reference::PlaneCounts counts;
  std::vector<double> planes_ms;

  void add(const Row& other)
  {
    counts.add(other.counts);
    planes_ms.insert(planes_ms.end(), other.planes_ms.begin(), other.planes_ms.end());
  }
};

using Thresholds = perception::PlaneSegmentation::Parameters;

Row run(const Options& options, const Thresholds& thresholds, const std::string& scene,
        const std::string& trajectory)
{
  simulation::SimulatedCamera::Options camera_options;
  camera_options.scene = scene;
  camera_options.trajectory = trajectory;
  camera_options.seed = options.seed;
  simulation::SimulatedCamera camera(camera_options);
  const auto& pinhole = camera_options.camera;
  const perception::PinholeRays rays = perception::PinholeRays::make(
      pinhole.width, pinhole.height, pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy);
  perception::Pipeline::Parameters parameters;
  parameters.samples.samples_x = options.samples;
  parameters.samples.samples_y = options.samples;
  parameters.segmentation = thresholds;
  perception::Pipeline pipeline(parameters);
  reference::PlaneChecker checker(camera, options.samples, options.samples);
  simulation::SimulatedFrame frame;
  Row row;
  for (int k = 0; k < options.frames; ++k) {
    camera.render(static_cast<std::uint32_t>(k), frame);
    const perception::PointView view =
        perception::PointView::depth(frame.depth.data(), pinhole.width * sizeof(float), rays);
    const perception::Pipeline::Result& result =
        pipeline.process({view, frame.time, {}}, perception::Product::kPlanes);
    checker.add(frame, result.planes);
    if (!options.pictures.empty()) {
      cv::Mat3b picture = paintTruth(pinhole, frame);
      drawPlanes(result.planes, pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy, picture);
      std::string file = options.pictures;
      file.append("/").append(scene).append("_").append(trajectory).append("_");
      file.append(std::to_string(k)).append(".png");
      cv::imwrite(file, picture);
    }
    row.planes_ms.push_back(std::chrono::duration<double, std::milli>(result.times.planes).count());
  }
  row.counts = checker.counts();
  return row;
}

void print(const std::string& name, const Row& row)
{
  const reference::PlaneCounts& c = row.counts;
  const auto q = [](const std::vector<double>& values, double share) {
    return reference::quantile(values, share);
  };
  std::printf(
      "| %s | %d | %d | %d | %d | %d | %d | %d | %.1f %% of %d | %.3f | %.3f | %.2f | %.2f | %.3f |\n",
      name.c_str(), c.frames, c.true_ones, c.found, c.uncovered, c.off, c.split, c.invented,
      100.0 * c.kept / std::max(1, c.pairs), c.pairs, q(c.degrees, 0.5), q(c.degrees, 0.95),
      q(c.millimetres, 0.5), q(c.millimetres, 0.95), q(row.planes_ms, 0.5));
  std::fflush(stdout);
}

/// Of all trajectories whose frames follow one another: in others there are no ids to keep.
Row runAll(const Options& options, const Thresholds& thresholds, const std::string& scene)
{
  Row row;
  for (const std::string& trajectory : simulation::trajectoryNames()) {
    if (trajectory.rfind("independent", 0) != 0) row.add(run(options, thresholds, scene, trajectory));
  }
  return row;
}

std::vector<std::string> scenes(const Options& options)
{
  return options.scene.empty() ? simulation::sceneNames() : std::vector<std::string>{options.scene};
}

void evaluate(const Options& options)
{
  std::printf(
      "| scene | frames | true planes | found | uncovered | off | split | invented | ids kept | deg median | "
      "95 %% "
      "| mm median | 95 %% | ms |\n| --- |%s\n",
      " --: | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: |");
  Row all;
  for (const std::string& scene : scenes(options)) {
    const Row row = runAll(options, Thresholds{}, scene);
    print(scene, row);
    if (options.faults) {
      for (const std::string& fault : row.counts.faults) std::printf("    %s\n", fault.c_str());
    }
    all.add(row);
  }
  print("all", all);
}

std::string outcome(const Options& options, const Thresholds& thresholds)
{
  Row all;
  for (const std::string& scene : scenes(options)) all.add(runAll(options, thresholds, scene));
  const reference::PlaneCounts& c = all.counts;
  char text[120];
  std::snprintf(text, sizeof text, "%d / %d / %d / %d / %d, %.1f %%", c.found, c.uncovered, c.off, c.split,
                c.invented, 100.0 * c.kept / std::max(1, c.pairs));
  return text;
}

/// Nobody knows the planes of recorded frames: their pictures are to be looked at.
void drawRecorded(const Options& options)
{
  for (const reference::RecordedFrame& recorded : reference::listRecordedFrames(options.recorded)) {
    const reference::LoadedFrame frame = reference::load(recorded);
    perception::Pipeline pipeline({});
    const perception::Pipeline::Result& result =
        pipeline.process({frame.view(), 0.0, {}}, perception::Product::kPlanes);
    cv::Mat3b picture = paintDepth(frame.depth);
    drawPlanes(result.planes, recorded.fx, recorded.fy, recorded.cx, recorded.cy, picture);
    std::string name = recorded.name;
    std::replace(name.begin(), name.end(), '/', '_');
    cv::imwrite(options.pictures + "/" + name + ".png", picture);
  }
}

/// What each threshold is worth: everything again with it off, at 0.7 and at 1.4 times its value.
void ablate(const Options& options)
{
  Thresholds thresholds;
  const std::string as_it_is = outcome(options, thresholds);
  std::printf(
      "As it is: %s.\n\n| threshold | value | off (0) | x 0.7 | x 1.4 |\n| --- | --: | --- | --- | --- |\n",
      as_it_is.c_str());
  Thresholds::describeThresholds(thresholds, [&](const char* name, double& value) {
    const double usual = value;
    std::printf("| %s | %g |", name, usual);
    for (const double factor : {0.0, 0.7, 1.4}) {
      value = factor * usual;
      const std::string with = outcome(options, thresholds);
      std::printf(" %s |", with == as_it_is ? "=" : with.c_str());
    }
    value = usual;
    std::printf("\n");
    std::fflush(stdout);
  });
}

bool parse(int argc, char** argv, Options& options)
{
  for (int k = 1; k < argc; ++k) {
    const std::string argument = argv[k];
    if (argument == "--faults" || argument == "--ablate") {
      (argument == "--faults" ? options.faults : options.ablate) = true;
      continue;
    }
    if (k + 1 == argc) return false;
    const char* const value = argv[++k];
    if (argument == "--frames") {
      options.frames = std::atoi(value);
    } else if (argument == "--seed") {
      options.seed = std::strtoull(value, nullptr, 10);
    } else if (argument == "--samples") {
      options.samples = std::atoi(value);
    } else if (argument == "--pictures") {
      options.pictures = value;
    } else if (argument == "--recorded") {
      options.recorded = value;
    } else if (argument == "--scene") {
      options.scene = value;
    } else {
      return false;
    }
  }
  return options.frames > 0 && options.samples > 1 && (options.recorded.empty() || !options.pictures.empty());
}

}  // namespace
}  // namespace polygonal_perception::evaluation

int main(int argc, char** argv)
{
  using namespace polygonal_perception::evaluation;
  Options options;
  if (!parse(argc, argv, options)) {
    std::cerr << "usage: evaluate_planes [--frames N] [--seed N] [--samples N] [--scene NAME] [--faults] "
                 "[--ablate]\n                       [--pictures DIR [--recorded FRAMES.json]]\n"
                 "  --frames    of each scene and trajectory (12)\n"
                 "  --samples   across and down the image (32)\n"
                 "  --pictures  draws each frame into the folder\n"
                 "  --recorded  draws recorded frames instead, in the form that README.md describes\n"
                 "  --faults    prints what was wrong, a line each\n"
                 "  --ablate    prints what each threshold is worth instead\n";
    return 2;
  }
  if (!options.recorded.empty()) {
    drawRecorded(options);
  } else {
    options.ablate ? ablate(options) : evaluate(options);
  }
  return 0;
}
