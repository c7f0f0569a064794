#include "floor_score.hpp"

#include <cstdio>

#include "reference/error_statistics.hpp"

namespace polygonal_perception::evaluation {

void FloorScore::add(const Answer& answer, const std::optional<geometry::Plane>& truth, double floor_fraction)
{
  constexpr double kEnoughFloor = 0.02;
  ++frames_;
  const bool counts = truth && floor_fraction >= kEnoughFloor;
  if (answer.status != perception::FloorStatus::kFound) {
    missed_ += counts && answer.status == perception::FloorStatus::kNotFound ? 1 : 0;
    held_ += counts && answer.status == perception::FloorStatus::kHeld ? 1 : 0;
    return;
  }
  if (!truth || reference::isWrong(answer.plane, *truth)) {
    ++(counts ? wrong_ : guessed_);
    return;
  }
  degrees_.push_back(reference::normalError(answer.plane, *truth));
  millimetres_.push_back(reference::heightError(answer.plane, *truth));
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
                frames_, reference::quantile(degrees_, 0.5), reference::quantile(degrees_, 0.95),
                reference::quantile(degrees_, 1.0), reference::quantile(millimetres_, 0.5),
                reference::quantile(millimetres_, 0.95), reference::quantile(millimetres_, 1.0), wrong_,
                missed_, held_, guessed_);
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

}  // namespace polygonal_perception::evaluation
