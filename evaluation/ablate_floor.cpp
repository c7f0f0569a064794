// What each threshold of the floor detector is worth: all frames again with it off, at 0.7 and at 1.4 times its value.
// Prints a table in markdown. Run through scripts/ablate_floor.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "floor_score.hpp"
#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "reference/error_statistics.hpp"
#include "reference/recorded_frames.hpp"

namespace polygonal_perception::evaluation {
namespace {

using perception::FloorDetector;

/// A frame in memory. Those of one run follow each other with feedback.
struct TestFrame
{
  std::vector<float> depth;
  const perception::PinholeRays* rays;
  std::optional<geometry::Plane> floor;
  double floor_fraction;
  double stamp;
  int run;
  double highest;  // [m] what is known of the camera's height
};

/// All that decides.
struct Parameters
{
  FloorDetector::Parameters detector;
  perception::FloorTracker::Parameters tracker;
};

/// What a set of parameters gives.
struct Outcome
{
  FloorScore rendered;
  FloorScore recorded;
  double microseconds = 0.0;  // median of a frame
};

class Frames
{
public:
  void render(int seeds, int frames_each);
  void record(const std::string& frames_json);
  Outcome judge(const Parameters& parameters) const;

private:
  static constexpr double kKnownHeight = 0.1;  // [m] above stairs and ledges
  static constexpr int kSequence = 4;          // times as many frames as elsewhere
  static constexpr int kKnownFrames = 8;
  static constexpr int kIndependent = 1 << 20;  // runs of one frame each

  std::vector<TestFrame> rendered_;
  std::vector<TestFrame> recorded_;
  std::vector<std::unique_ptr<perception::PinholeRays>> rays_;
};

void Frames::render(int seeds, int frames_each)
{
  int run = 0;
  for (const std::string& scene : simulation::sceneNames()) {
    for (const std::string& trajectory : simulation::trajectoryNames()) {
      const bool independent = trajectory.rfind("independent", 0) == 0;
      for (int seed = 1; seed <= seeds; ++seed, ++run) {
        simulation::SimulatedCamera::Options options;
        options.scene = scene;
        options.trajectory = trajectory;
        options.seed = static_cast<std::uint64_t>(seed);
        simulation::SimulatedCamera camera(options);
        const auto& pinhole = options.camera;
        rays_.push_back(std::make_unique<perception::PinholeRays>(perception::PinholeRays::make(
            pinhole.width, pinhole.height, pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy)));
        simulation::SimulatedFrame frame;
        // A sequence lasts longer, for what is remembered: above stairs and ledges the height is known at first alone.
        const int frames = independent ? frames_each : kSequence * frames_each;
        for (int k = 0; k < frames; ++k) {
          camera.render(static_cast<std::uint32_t>(k), frame);
          const bool drops = (scene == "stairs" || scene == "ledge") && (independent || k < kKnownFrames);
          rendered_.push_back({frame.depth, rays_.back().get(), frame.floor, frame.floor_fraction, frame.time,
                               independent ? kIndependent + run * frames_each + k : run,
                               drops ? frame.floor.distance + kKnownHeight
                                     : FloorDetector::Parameters{}.selection.max_camera_height});
        }
      }
    }
  }
}

void Frames::record(const std::string& frames_json)
{
  int run = 0;
  for (const reference::RecordedFrame& recorded : reference::listRecordedFrames(frames_json)) {
    if (!recorded.reference_known) continue;
    const reference::LoadedFrame loaded = reference::load(recorded);
    rays_.push_back(std::make_unique<perception::PinholeRays>(loaded.rays));
    TestFrame frame{{},
                    rays_.back().get(),
                    recorded.floor,
                    1.0,
                    0.0,
                    run++,
                    FloorDetector::Parameters{}.selection.max_camera_height};
    frame.depth.assign(loaded.depth.begin(), loaded.depth.end());
    recorded_.push_back(std::move(frame));
  }
}

Outcome Frames::judge(const Parameters& parameters) const
{
  Outcome outcome;
  std::vector<double> times;
  perception::SampleGrid grid{perception::SampleGrid::Parameters{}};
  for (const bool recorded : {false, true}) {
    FloorScore& score = recorded ? outcome.recorded : outcome.rendered;
    int run = -1;
    perception::FloorTracker tracker(parameters.tracker, parameters.detector);
    for (const TestFrame& frame : recorded ? recorded_ : rendered_) {
      if (frame.run != run) tracker.reset();
      run = frame.run;
      FloorDetector::Parameters known = parameters.detector;
      known.selection.max_camera_height = std::min(known.selection.max_camera_height, frame.highest);
      tracker.configure(parameters.tracker, known);
      const perception::PointView view = perception::PointView::depth(
          frame.depth.data(), frame.rays->column_slope.size() * sizeof(float), *frame.rays);
      grid.update(view);
      const auto start = std::chrono::steady_clock::now();
      const perception::FloorState& state = tracker.update(view, grid, frame.stamp, {});
      times.push_back(
          std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
      score.add({state.status, state.floor.plane, std::nullopt}, frame.floor, frame.floor_fraction);
    }
  }
  outcome.microseconds = reference::quantile(times, 0.5);
  return outcome;
}

/// All thresholds, by name.
template <class Visitor>
void forEachThreshold(Parameters& parameters, Visitor&& visit)
{
  perception::PlaneExtractionParameters::describeThresholds(parameters.detector.planes, visit);
  perception::FloorSelectionParameters::describeThresholds(parameters.detector.selection, visit);
  perception::FloorRefinementParameters::describeThresholds(parameters.detector.refinement, visit);
  perception::FloorTracker::Parameters::describeThresholds(parameters.tracker, visit);
}

std::string cell(const Outcome& outcome)
{
  char text[128];
  std::snprintf(text, sizeof text, "%d / %d / %d / %d, %.3f; %d / %d / %d", outcome.rendered.wrong(),
                outcome.rendered.off(), outcome.rendered.missed(), outcome.rendered.guessed(),
                outcome.rendered.degrees(0.95), outcome.recorded.wrong(), outcome.recorded.missed(),
                outcome.recorded.guessed());
  return text;
}

void ablate(const Frames& frames)
{
  constexpr std::array<double, 3> kFactors = {0.0, 0.7, 1.4};
  const Outcome base = frames.judge({});
  std::cout
      << "wrong / off / missed / guessed of the rendered frames, 95 % of the normals' errors [deg], wrong or "
         "missed of the recorded ones.\n\nAs it is: "
      << cell(base) << "; median " << base.microseconds << " us.\n\n"
      << "| threshold | value | off (0) | x 0.7 | x 1.4 | time off, x 0.7, x 1.4 |\n"
         "| --- | --: | --- | --- | --- | --- |\n";
  std::vector<std::string> names;
  Parameters defaults;
  forEachThreshold(defaults, [&](const char* name, double /*value*/) { names.emplace_back(name); });
  for (const std::string& name : names) {
    std::string row;
    std::string times;
    double value = 0.0;
    for (const double factor : kFactors) {
      Parameters changed;
      forEachThreshold(changed, [&](const char* other, double& member) {
        if (name != other) return;
        value = member;
        member *= factor;
      });
      const Outcome outcome = frames.judge(changed);
      const std::string text = cell(outcome);
      row += (text == cell(base) ? std::string("=") : text) + " | ";
      char time[32];
      std::snprintf(time, sizeof time, "%s%.2f", times.empty() ? "" : ", ",
                    outcome.microseconds / base.microseconds);
      times += time;
    }
    std::cout << "| " << name << " | " << value << " | " << row << times << " |\n";
    std::cout.flush();
  }
}

}  // namespace
}  // namespace polygonal_perception::evaluation

int main(int argc, char** argv)
{
  using namespace polygonal_perception::evaluation;
  int seeds = 2;
  int frames_each = 3;
  std::string recorded;
  bool is_understood = argc % 2 == 1;
  for (int k = 1; k + 1 < argc; k += 2) {
    const std::string option = argv[k];
    if (option == "--seeds") {
      seeds = std::atoi(argv[k + 1]);
    } else if (option == "--frames") {
      frames_each = std::atoi(argv[k + 1]);
    } else if (option == "--recorded") {
      recorded = argv[k + 1];
    } else {
      is_understood = false;
    }
  }
  if (!is_understood || seeds < 1 || frames_each < 1) {
    std::cerr << "usage: ablate_floor [--seeds N] [--frames N] [--recorded FRAMES.json]\n"
                 "  --seeds    layouts of each scene and trajectory (2)\n"
                 "  --frames   of each layout (3)\n"
                 "  --recorded recorded frames and their floors\n";
    return 2;
  }
  try {
    Frames frames;
    frames.render(seeds, frames_each);
    if (!recorded.empty()) frames.record(recorded);
    ablate(frames);
  } catch (const std::exception& error) {
    std::cerr << "ablate_floor: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
