// A robot drives over ramps, with and without mount_frame and max_slope: a table in markdown, each frame held against
// the truth, and a picture. Run through scripts/evaluate_course.

#include <array>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "course_picture.hpp"

namespace polygonal_perception::evaluation {
namespace {

using reference::CourseFrame;
using reference::CourseRun;

constexpr double kMaxSlope = 0.2;  // [rad]

struct Case
{
  bool has_mount;
  bool has_slopes;
};
constexpr std::array<Case, 4> kCases{{{false, false}, {true, false}, {false, true}, {true, true}}};

CourseRun::Options optionsOf(const Case& what, std::uint64_t seed)
{
  CourseRun::Options options;
  options.seed = seed;
  options.has_mount = what.has_mount;
  options.parameters.ground.max_slope = what.has_slopes ? kMaxSlope : 0.0;
  return options;
}

std::string textOf(const Case& what)
{
  return std::string(what.has_mount ? "with" : "without") + " mount_frame, max_slope " +
         (what.has_slopes ? "0.2" : "0");
}

void printRow(std::uint64_t seed, const Case& what, const std::vector<CourseFrame>& frames)
{
  std::array<int, 4> statuses{};
  int off = 0;
  int with_false = 0;
  int with_far_false = 0;
  int obstacles = 0;
  int missed = 0;
  for (const CourseFrame& frame : frames) {
    ++statuses[static_cast<std::size_t>(frame.status)];
    off += frame.isOff() ? 1 : 0;
    with_false += frame.false_cells > 0 ? 1 : 0;
    with_far_false += frame.false_far_cells > 0 ? 1 : 0;
    obstacles += frame.obstacle_cells;
    missed += frame.missed_cells;
  }
  std::printf("| %d | %s | %s | %d | %d | %d | %d | %d | %d | %d | %d of %d |\n", static_cast<int>(seed),
              what.has_mount ? "yes" : "no", what.has_slopes ? "0.2" : "0", statuses[1], statuses[2],
              statuses[3], statuses[0], off, with_false, with_far_false, missed, obstacles);
  std::fflush(stdout);
}

std::vector<CourseFrame> drive(const Case& what, std::uint64_t seed)
{
  CourseRun run(optionsOf(what, seed));
  std::vector<CourseFrame> frames;
  for (std::uint32_t k = 0; k < CourseRun::kFrames; ++k) frames.push_back(run.next());
  return frames;
}

/// Some moments of the way there, where they are for this seed.
void addMoments(std::uint64_t seed, cv::Mat3b& picture)
{
  struct Moment
  {
    double x;
    const char* text;
  };
  constexpr std::array<Moment, 7> kMoments{{{-4.0, "along a wall"},
                                            {-2.9, "before a door"},
                                            {-0.8, "before a ramp"},
                                            {0.8, "on the ramp"},
                                            {3.6, "before the crest"},
                                            {7.2, "before the kerb ramp"},
                                            {11.4, "before a wall"}}};
  const Case what{true, true};
  CourseRun run(optionsOf(what, seed));
  std::size_t next = 0;
  while (next < kMoments.size()) {
    const CourseFrame frame = run.next();
    if (frame.x < kMoments[next].x) continue;
    const std::string title =
        std::string(kMoments[next++].text) + ", x = " + std::to_string(frame.x).substr(0, 4);
    const cv::Mat3b one = drawCourseFrame(run, title);
    if (next == 1) {
      cv::Mat3b wider(picture.rows, one.cols, cv::Vec3b(255, 255, 255));
      picture.copyTo(wider(cv::Rect(0, 0, picture.cols, picture.rows)));
      picture = wider;
    }
    cv::vconcat(picture, one, picture);
  }
}

void evaluate(const std::string& picture_file)
{
  std::printf(
      "| course | mount_frame | max_slope | FOUND | HELD | ASSUMED | NOT_FOUND | floor off | false cells | "
      "far | "
      "missed |\n| --: | --- | --: | --: | --: | --: | --: | --: | --: | --: | --: |\n");
  constexpr std::uint64_t kDrawn = 3;
  cv::Mat3b picture;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const Case& what : kCases) {
      const std::vector<CourseFrame> frames = drive(what, seed);
      printRow(seed, what, frames);
      if (seed != kDrawn || picture_file.empty()) continue;
      // The way there; back it would lie over it.
      const std::vector<CourseFrame> there(frames.begin(), frames.begin() + CourseRun::kFrames / 2);
      const cv::Mat3b side = drawCourse(CourseRun(optionsOf(what, seed)).scene(), there, textOf(what));
      if (picture.empty()) {
        picture = side;
      } else {
        cv::vconcat(picture, side, picture);
      }
    }
  }
  if (picture_file.empty()) return;
  addMoments(kDrawn, picture);
  cv::imwrite(picture_file, picture);
}

}  // namespace
}  // namespace polygonal_perception::evaluation

int main(int argc, char** argv)
{
  const bool draws = argc == 3 && std::string(argv[1]) == "--picture";
  if (argc != 1 && !draws) {
    std::fprintf(stderr, "usage: evaluate_course [--picture FILE]\n");
    return 2;
  }
  polygonal_perception::evaluation::evaluate(draws ? argv[2] : "");
  return 0;
}
