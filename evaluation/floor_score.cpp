#include "floor_score.hpp"

#include <cmath>
#include <cstdio>

#include "reference/error_statistics.hpp"

namespace polygonal_perception::evaluation {

namespace {

// Between right and wrong, as the contract counts.
constexpr double kOffDegrees = 0.3;
constexpr double kOffMillimetres = 5.0;

}  // namespace

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
  // Beside less floor than that a carpet of 4 cm is as good.
  if (!counts) return;
  degrees_.push_back(reference::normalError(answer.plane, *truth));
  millimetres_.push_back(reference::heightError(answer.plane, *truth));
  if (answer.covariance)
    uncertainties_.push_back(
        reference::uncertainties(answer.plane, *answer.covariance, *truth, Eigen::Vector3d::UnitZ()));
  off_ += degrees_.back() > kOffDegrees || millimetres_.back() > kOffMillimetres ? 1 : 0;
}

void FloorScore::add(const FloorScore& other)
{
  degrees_.insert(degrees_.end(), other.degrees_.begin(), other.degrees_.end());
  millimetres_.insert(millimetres_.end(), other.millimetres_.begin(), other.millimetres_.end());
  uncertainties_.insert(uncertainties_.end(), other.uncertainties_.begin(), other.uncertainties_.end());
  frames_ += other.frames_;
  wrong_ += other.wrong_;
  off_ += other.off_;
  missed_ += other.missed_;
  held_ += other.held_;
  guessed_ += other.guessed_;
}

std::string FloorScore::row() const
{
  char text[256];
  std::snprintf(text, sizeof text, "%d | %.3f | %.3f | %.2f | %.2f | %.2f | %.1f | %d | %d | %d | %d | %d |",
                frames_, reference::quantile(degrees_, 0.5), reference::quantile(degrees_, 0.95),
                reference::quantile(degrees_, 1.0), reference::quantile(millimetres_, 0.5),
                reference::quantile(millimetres_, 0.95), reference::quantile(millimetres_, 1.0), wrong_, off_,
                missed_, held_, guessed_);
  return text;
}

std::string FloorScore::covarianceText() const
{
  if (uncertainties_.empty()) return {};
  std::array<std::vector<double>, 3> errors;
  std::array<std::vector<double>, 3> sigmas;
  std::size_t inside = 0;
  for (const auto& uncertainty : uncertainties_) {
    bool all = true;
    for (std::size_t k = 0; k < uncertainty.size(); ++k) {
      errors[k].push_back(std::abs(uncertainty[k].error));
      sigmas[k].push_back(uncertainty[k].sigma);
      all &= errors[k].back() <= 3.0 * sigmas[k].back();
    }
    inside += all ? 1 : 0;
  }
  std::array<double, 3> size{};
  for (std::size_t k = 0; k < size.size(); ++k)
    size[k] = 3.0 * reference::quantile(sigmas[k], 0.5) / reference::quantile(errors[k], 0.99);
  char text[160];
  std::snprintf(text, sizeof text, "%.2f %% of %zu frames, %.2f, %.2f, %.2f",
                100.0 * static_cast<double>(inside) / static_cast<double>(uncertainties_.size()),
                uncertainties_.size(), size[0], size[1], size[2]);
  return text;
}

double FloorScore::degrees(double share) const
{
  return reference::quantile(degrees_, share);
}

std::string FloorScore::head()
{
  return "frames | deg median | 95 % | max | mm median | 95 % | max | wrong | off | missed | held | guessed "
         "|";
}

std::string FloorScore::rule()
{
  return "--: | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: |";
}

}  // namespace polygonal_perception::evaluation
