#include "rviz/polygon_colors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace polygonal_perception::displays {

namespace {

constexpr double kMaxMove = 0.3;  // [m] between two messages
constexpr unsigned int kNone = std::numeric_limits<unsigned int>::max();

/// Steps of the golden ratio around the circle keep any number of hues apart.
float hueOf(unsigned int number)
{
  constexpr double kGoldenRatio = 0.6180339887498949;
  return static_cast<float>(std::fmod(0.05 + number * kGoldenRatio, 1.0));
}

/// The first number that no polygon has.
unsigned int freeNumber(const std::vector<unsigned int>& numbers)
{
  unsigned int number = 0;
  while (std::find(numbers.begin(), numbers.end(), number) != numbers.end()) ++number;
  return number;
}

}  // namespace

std::vector<float> PolygonColors::assign(const std::vector<Eigen::Vector2d>& centers)
{
  std::vector<unsigned int> numbers;
  numbers.reserve(centers.size());
  for (const Eigen::Vector2d& center : centers) numbers.push_back(takeNearest(center));
  for (unsigned int& number : numbers) {
    if (number == kNone) number = freeNumber(numbers);
  }
  centers_ = centers;
  numbers_ = numbers;

  std::vector<float> hues;
  hues.reserve(numbers.size());
  for (const unsigned int number : numbers) hues.push_back(hueOf(number));
  return hues;
}

unsigned int PolygonColors::takeNearest(const Eigen::Vector2d& center)
{
  double nearest = kMaxMove;
  std::size_t match = centers_.size();
  for (std::size_t i = 0; i < centers_.size(); ++i) {
    const double distance = (centers_[i] - center).norm();
    if (numbers_[i] == kNone || !(distance < nearest)) continue;
    nearest = distance;
    match = i;
  }
  return match < centers_.size() ? std::exchange(numbers_[match], kNone) : kNone;
}

}  // namespace polygonal_perception::displays
