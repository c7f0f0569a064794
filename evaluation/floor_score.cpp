#include "floor_score.hpp"

#include <cstdio>

#include "error_statistics.hpp"

namespace polygonal_perception {
namespace evaluation {

void FloorScore::add(const Answer& answer, const std::optional<Plane>& truth, double floor_fraction)
{
  constexpr double kEnoughFloor = 0.02;
  ++frames_;
  const bool counts = truth && floor_fraction >= kEnoughFloor;
  if (answer.status != FloorStatus::kFound) {
    missed_ += counts && answer.status == FloorStatus::kNotFound ? 1 : 0;
    held_ += counts && answer.status == FloorStatus::kHeld ? 1 : 0;
    return;
  }
  if (!truth || isWrong(answer.plane, *truth)) {
    ++(counts ? wrong_ : guessed_);
    return;
  }
  degrees_.push_back(normalError(answer.plane, *truth));
  millimetres_.push_back(heightError(answer.plane, *truth));
}

void FloorScore::add(const FloorScore& other)
{
  degrees_.insert(degrees_.end(), other.degrees_.begin(), other.degrees_.end());
  millimetres_.insert(millimetres_.end(), other.millimetres_.begin(), other.millimetres_.end());
  frames_ += other.frames_;
  wrong_ += other.wrong_;
  missed_ += other.missed_;
  held_ += other.held_;
  guessed_ += other.guessed_;
}

std::string FloorScore::row() const
{
  char text[256];
  std::snprintf(text, sizeof text, "%d | %.3f | %.3f | %.2f | %.2f | %.2f | %.1f | %d | %d | %d | %d |",
                frames_, quantile(degrees_, 0.5), quantile(degrees_, 0.95), quantile(degrees_, 1.0),
                quantile(millimetres_, 0.5), quantile(millimetres_, 0.95), quantile(millimetres_, 1.0),
                wrong_, missed_, held_, guessed_);
  return text;
}

std::string FloorScore::head()
{
  return "frames | deg median | 95 % | max | mm median | 95 % | max | wrong | missed | held | guessed |";
}

std::string FloorScore::rule()
{
  return "--: | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: |";
}

}  // namespace evaluation
}  // namespace polygonal_perception
