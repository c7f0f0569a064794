#include "polygon_colors.hpp"

#include <cmath>
#include <cstddef>

namespace polygonal_perception {

namespace {

constexpr double kMaxMove = 0.3;  // [m] between two messages

/// Steps of the golden ratio around the circle keep any number of hues apart.
float hueOf(unsigned int number)
{
  constexpr double kGoldenRatio = 0.6180339887498949;
  return static_cast<float>(std::fmod(0.05 + number * kGoldenRatio, 1.0));
}

}  // namespace

const std::vector<float>& PolygonColors::assign(const std::vector<Eigen::Vector2d>& centers)
{
  std::vector<float> hues;
  hues.reserve(centers.size());
  std::vector<bool> taken(centers_.size(), false);
  for (const Eigen::Vector2d& center : centers) {
    double nearest = kMaxMove;
    std::size_t match = centers_.size();
    for (std::size_t i = 0; i < centers_.size(); ++i) {
      const double distance = (centers_[i] - center).norm();
      if (taken[i] || !(distance < nearest)) continue;
      nearest = distance;
      match = i;
    }
    const bool known = match < centers_.size();
    if (known) taken[match] = true;
    hues.push_back(known ? hues_[match] : hueOf(count_++));
  }
  centers_ = centers;
  hues_.swap(hues);
  return hues_;
}

}  // namespace polygonal_perception
