// Holds the floor detector, the paper's plain algorithm and PCL's RANSAC against rendered and recorded frames
// whose floor is known, and prints tables in markdown. Run through scripts/evaluate_floor.

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "floor_methods.hpp"
#include "floor_picture.hpp"
#include "floor_score.hpp"
#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "reference/recorded_frames.hpp"

namespace polygonal_perception::evaluation {
namespace {

using simulation::SimulatedCamera;
using simulation::SimulatedFrame;

constexpr double kKnownHeight = 0.1;  // [m] how well a robot knows its camera's height

struct Options
{
  int frames = 12;
  std::uint64_t seed = 1;
  std::string recorded;  // a frames.json
  std::string pictures;  // a folder
  bool rendered = true;
};

/// Trajectories whose frames start from the initial up vector alone are independent of each other.
bool independent(const std::string& trajectory)
{
  return trajectory.rfind("independent", 0) == 0;
}

bool dropsOff(const std::string& scene)
{
  return scene == "stairs" || scene == "ledge";
}

void drawPicture(const std::string& folder, const std::string& name, const perception::PointView& view,
                 const cv::Mat1f& depth, double max_camera_height)
{
  perception::SampleGrid grid{perception::SampleGrid::Parameters{}};
  grid.update(view);
  perception::FloorPrior prior;
  prior.up = -Eigen::Vector3d::UnitY();
  perception::FloorDetector::Parameters parameters;
  parameters.selection.max_camera_height = max_camera_height;
  perception::FloorDetector detector(parameters);
  detector.detect(view, grid, prior);
  cv::imwrite(folder + "/" + name + ".png", drawFloor(depth, grid, detector.labels()));
}

/// A sensor that is not the one that the detector takes it for.
struct OtherNoise
{
  const char* name;
  void (*change)(simulation::DepthNoise::Parameters& noise);
};

constexpr std::array<OtherNoise, 5> kOtherNoises{{
    {"as assumed", [](simulation::DepthNoise::Parameters& /*noise*/) {}},
    {"half the sigma",
     [](simulation::DepthNoise::Parameters& noise) {
       noise.sigma_base *= 0.5;
       noise.sigma_quadratic *= 0.5;
     }},
    {"twice the sigma",
     [](simulation::DepthNoise::Parameters& noise) {
       noise.sigma_base *= 2.0;
       noise.sigma_quadratic *= 2.0;
     }},
    {"correlated over 4 pixels", [](simulation::DepthNoise::Parameters& noise) { noise.correlation = 4.0; }},
    {"another law: 3 mm + 0.3 mm z^2",
     [](simulation::DepthNoise::Parameters& noise) {
       noise.sigma_base = 0.003;
       noise.sigma_quadratic = 0.0003;
       noise.disparity_step = 0.0;
     }},
}};

void run(const Options& options, const OtherNoise& noise, const std::string& scene,
         const std::string& trajectory, std::vector<std::unique_ptr<FloorMethod>>& methods,
         std::vector<FloorScore>& scores)
{
  simulation::SimulatedCamera::Options camera_options;
  camera_options.scene = scene;
  camera_options.trajectory = trajectory;
  camera_options.seed = options.seed;
  noise.change(camera_options.noise);
  simulation::SimulatedCamera camera(camera_options);
  const auto& pinhole = camera_options.camera;
  const perception::PinholeRays rays = perception::PinholeRays::make(
      pinhole.width, pinhole.height, pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy);
  perception::SampleGrid grid{perception::SampleGrid::Parameters{}};
  simulation::SimulatedFrame frame;
  for (auto& method : methods) method->reset();
  for (int k = 0; k < options.frames; ++k) {
    camera.render(static_cast<std::uint32_t>(k), frame);
    const perception::PointView view =
        perception::PointView::depth(frame.depth.data(), pinhole.width * sizeof(float), rays);
    grid.update(view);
    const double highest = dropsOff(scene)
                               ? frame.floor.distance + kKnownHeight
                               : perception::FloorDetector::Parameters{}.selection.max_camera_height;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      methods[m]->boundHeight(highest);
      if (independent(trajectory)) methods[m]->reset();
      scores[m].add(methods[m]->see(view, grid, frame.time), frame.floor, frame.floor_fraction);
    }
    if (k == 0 && !options.pictures.empty()) {
      drawPicture(
          options.pictures, scene + "_" + trajectory, view,
          cv::Mat1f(static_cast<int>(pinhole.height), static_cast<int>(pinhole.width), frame.depth.data()),
          highest);
    }
  }
}

void printHead(const char* first)
{
  std::cout << "\n| " << first << " | method | " << FloorScore::head() << "\n| --- | --- | "
            << FloorScore::rule() << "\n";
}

void printRows(const std::string& first, const std::vector<std::unique_ptr<FloorMethod>>& methods,
               const std::vector<FloorScore>& scores)
{
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::cout << "| " << first << " | " << methods[m]->name() << " | " << scores[m].row() << "\n";
  }
  std::cout.flush();
}

void evaluateRendered(const Options& options)
{
  auto methods = makeFloorMethods();
  for (const bool alone : {false, true}) {
    std::cout << (alone ? "\nRendered, each frame from the initial up vector alone:\n"
                        : "\nRendered, sequences with feedback:\n");
    printHead("scene");
    std::vector<FloorScore> all(methods.size());
    for (const std::string& scene : simulation::sceneNames()) {
      std::vector<FloorScore> scores(methods.size());
      for (const std::string& trajectory : simulation::trajectoryNames()) {
        if (independent(trajectory) != alone) continue;
        std::fprintf(stderr, "\r%-60s", ("rendering " + scene + ", " + trajectory).c_str());
        run(options, kOtherNoises[0], scene, trajectory, methods, scores);
      }
      std::fprintf(stderr, "\r%-60s\r", "");
      printRows(scene, methods, scores);
      for (std::size_t m = 0; m < methods.size(); ++m) all[m].add(scores[m]);
    }
    printRows("all", methods, all);
    std::cout << "\nCovariance: tilt about x and y and distance within 3 sigma in " << all[0].covarianceText()
              << " (median 3 sigma over the 99 % error of each)\n";
  }
}

void evaluateOtherNoises(const Options& options)
{
  std::cout << "\nRendered with a sensor that is not what the detector takes it for, each frame from the "
               "initial up "
               "vector alone, all scenes:\n";
  printHead("noise");
  for (const OtherNoise& noise : kOtherNoises) {
    auto methods = makeFloorMethods();
    methods.resize(1);  // this package
    std::vector<FloorScore> scores(methods.size());
    for (const std::string& scene : simulation::sceneNames()) {
      for (const std::string& trajectory : simulation::trajectoryNames()) {
        if (independent(trajectory)) run(options, noise, scene, trajectory, methods, scores);
      }
    }
    printRows(noise.name, methods, scores);
  }
}

void evaluateRecorded(const Options& options)
{
  auto methods = makeFloorMethods();
  const auto frames = reference::listRecordedFrames(options.recorded);
  for (const bool alone : {false, true}) {
    std::cout << (alone ? "\nRecorded, each frame from the initial up vector alone:\n"
                        : "\nRecorded, in their order with feedback:\n");
    printHead("set");
    for (std::size_t first = 0; first < frames.size();) {
      std::vector<FloorScore> scores(methods.size());
      std::size_t k = first;
      for (auto& method : methods) method->reset();
      for (; k < frames.size() && frames[k].set == frames[first].set; ++k) {
        const reference::LoadedFrame loaded = reference::load(frames[k]);
        perception::SampleGrid grid{perception::SampleGrid::Parameters{}};
        grid.update(loaded.view());
        for (std::size_t m = 0; m < methods.size(); ++m) {
          if (alone) methods[m]->reset();
          const Answer answer = methods[m]->see(loaded.view(), grid, static_cast<double>(k) / 30.0);
          // The reference says that there is a floor, not how much of the image it is.
          if (frames[k].reference_known) scores[m].add(answer, frames[k].floor, 1.0);
        }
        if (alone && !options.pictures.empty()) {
          std::string name = frames[k].name;
          for (char& c : name) c = c == '/' ? '_' : c;
          drawPicture(options.pictures, name, loaded.view(), loaded.depth,
                      perception::FloorDetector::Parameters{}.selection.max_camera_height);
        }
      }
      printRows(frames[first].set, methods, scores);
      first = k;
    }
  }
}

int usage()
{
  std::cerr << "usage: evaluate_floor [--frames N] [--seed N] [--recorded FRAMES.json] [--no-rendered] "
               "[--pictures DIR]\n"
               "  --frames       of each scene and trajectory (12)\n"
               "  --recorded     also recorded frames, in the form that README.md describes\n"
               "  --pictures     writes depth images with the samples drawn on them\n";
  return 2;
}

bool parse(int argc, char** argv, Options& options)
{
  for (int k = 1; k < argc; ++k) {
    const std::string argument = argv[k];
    if (argument == "--no-rendered") {
      options.rendered = false;
      continue;
    }
    if (k + 1 == argc) return false;
    const char* const value = argv[++k];
    if (argument == "--frames") {
      options.frames = std::atoi(value);
    } else if (argument == "--seed") {
      options.seed = std::strtoull(value, nullptr, 10);
    } else if (argument == "--recorded") {
      options.recorded = value;
    } else if (argument == "--pictures") {
      options.pictures = value;
    } else {
      return false;
    }
  }
  return options.frames > 0;
}

}  // namespace
}  // namespace polygonal_perception::evaluation

int main(int argc, char** argv)
{
  using namespace polygonal_perception::evaluation;
  Options options;
  if (!parse(argc, argv, options)) return usage();
  try {
    if (options.rendered) {
      evaluateRendered(options);
      evaluateOtherNoises(options);
    }
    if (!options.recorded.empty()) evaluateRecorded(options);
  } catch (const std::exception& error) {
    std::cerr << "evaluate_floor: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
