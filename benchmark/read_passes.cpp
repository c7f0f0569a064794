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
        "us, planes %5.1f us, scan %5.1f us, looked through %5.1f us\n",
        nameOf(input_), stage(&perception::StageTimes::samples), stage(&perception::StageTimes::floor),
        stage(&perception::StageTimes::projection), stage(&perception::StageTimes::inflation),
        stage(&perception::StageTimes::polygons), stage(&perception::StageTimes::planes),
        stage(&perception::StageTimes::scan), stage(&perception::StageTimes::looked_through));
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

/// What is given only where somebody reads it.
struct Extra
{
  const char* name;
  perception::Product product;
};
constexpr Extra kExtras[] = {{"planes", perception::Product::kPlanes},
                             {"observed grid", perception::Product::kObserved},
                             {"scan", perception::Product::kScan},
                             {"observed cells", perception::Product::kLookedThrough}};

/// The polygons of one kind of input, alone and with each extra, over all runs in units of a read pass.
class Passes
{
public:
  explicit Passes(Input input) : input_(input)
  {
    subjects_.emplace_back(input, perception::Product::kPolygons);
    for (const Extra& extra : kExtras)
      subjects_.emplace_back(input, perception::Products{perception::Product::kPolygons, extra.product});
    passes_.resize(subjects_.size());
  }

  void beginRun() { run_.assign(subjects_.size(), {}); }
  void process(std::size_t index, const CameraFrame& frame)
  {
    for (std::size_t k = 0; k < subjects_.size(); ++k) run_[k].add(index, subjects_[k](frame));
  }
  /// @param read  [us] a read pass over all frames of the run
  void endRun(double read)
  {
    passes_.front().push_back(run_.front().total() / read);
    for (std::size_t k = 1; k < subjects_.size(); ++k)
      passes_[k].push_back((run_[k].total() - run_.front().total()) / read);
    std::printf("  %s %.1f us (%.2f)\n", nameOf(input_), run_.front().total() / kFrames,
                passes_.front().back());
  }

  void print() const
  {
    for (const Subject& subject : subjects_) subject.printStages();
    std::printf("read passes: %s %.2f", nameOf(input_), median(passes_.front()));
    for (std::size_t k = 1; k < subjects_.size(); ++k)
      std::printf(", more for %s %.2f", kExtras[k - 1].name, median(passes_[k]));
    std::printf("\n");
  }

private:
  Input input_;
  std::vector<Subject> subjects_;
  std::vector<Run> run_;                     // by subject
  std::vector<std::vector<double>> passes_;  // by subject, one a run
};

int measure()
{
  const auto frames = drive(Surroundings::kOffice, 640, 480, kFrames);
  Passes inputs[] = {Passes(Input::kCloud16), Passes(Input::kDepthMillimetres)};
  volatile std::uint64_t sum = 0;
  for (int run = 0; run < kRuns; ++run) {
    Run reads;
    for (Passes& input : inputs) input.beginRun();
    for (int turn = 0; turn < kTurns; ++turn) {
      for (std::size_t k = 0; k < frames.size(); ++k) {
        const std::vector<float>& bytes = frames[k]->cloud16();
        reads.add(k, timeOf([&] { sum = readPass(bytes.data(), bytes.size() * sizeof(float)); }));
        for (Passes& input : inputs) input.process(k, *frames[k]);
      }
    }
    std::printf("run %d: a read pass %.1f us\n", run + 1, reads.total() / kFrames);
    for (Passes& input : inputs) input.endRun(reads.total());
  }
  for (const Passes& input : inputs) input.print();
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace polygonal_perception::benchmarks

int main()
{
  return polygonal_perception::benchmarks::measure();
}
