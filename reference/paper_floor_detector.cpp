#include "reference/paper_floor_detector.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace polygonal_perception::reference {

namespace {

constexpr double kClusterDistance = 0.01;  // [m] tau_l
constexpr double kMergeDistance = 0.1;     // [m] tau_h
constexpr std::size_t kReplacement = 20;
const double kLeastUpright = std::sqrt(0.5);  // cosine of pi / 4

struct Average
{
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};

/// d(s_m, s_n), eq. 5.
double planeDistance(const Average& m, const Average& n)
{
  const Eigen::Vector3d step = n.point - m.point;
  return std::abs(m.normal.dot(step)) + std::abs(n.normal.dot(step));
}

Average valueOf(const perception::Sample& sample)
{
  return {sample.point.cast<double>(), sample.normal.cast<double>()};
}

Average averageOf(const perception::SampleGrid& grid, const std::vector<std::size_t>& members)
{
  Average sum;
  for (const std::size_t k : members) {
    sum.point += grid.samples()[k].point.cast<double>();
    sum.normal += grid.samples()[k].normal.cast<double>();
  }
  return {sum.point / static_cast<double>(members.size()), sum.normal.normalized()};
}

std::optional<geometry::Plane> leastSquares(const perception::SampleGrid& grid,
                                            const std::vector<std::size_t>& members,
                                            const Eigen::Vector3d& up)
{
  if (members.size() < 3) return std::nullopt;
  const Eigen::Vector3d mean = averageOf(grid, members).point;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const std::size_t k : members) {
    const Eigen::Vector3d d = grid.samples()[k].point.cast<double>() - mean;
    scatter += d * d.transpose();
  }
  Eigen::Vector3d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
  if (normal.dot(up) < 0.0) normal = -normal;
  return geometry::Plane{normal, -normal.dot(mean)};
}

}  // namespace

void PaperFloorDetector::flood(const perception::SampleGrid& grid, std::size_t seed)
{
  const auto columns = static_cast<std::size_t>(grid.samplesX());
  const auto& samples = grid.samples();
  segment_.assign(1, seed);
  waiting_[seed] = false;
  for (std::size_t next = 0; next < segment_.size(); ++next) {
    const std::size_t here = segment_[next];
    const auto visit = [&](std::size_t there) {
      if (!waiting_[there] ||
          !(planeDistance(valueOf(samples[there]), valueOf(samples[here])) < kClusterDistance))
        return;
      waiting_[there] = false;
      segment_.push_back(there);
    };
    if (here % columns + 1 < columns) visit(here + 1);
    if (here % columns > 0) visit(here - 1);
    if (here + columns < samples.size()) visit(here + columns);
    if (here >= columns) visit(here - columns);
  }
}

std::optional<geometry::Plane> PaperFloorDetector::detect(const perception::SampleGrid& grid,
                                                          const Eigen::Vector3d& up)
{
  const auto& samples = grid.samples();
  waiting_.assign(samples.size(), false);
  order_.clear();
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (!samples[k].has_normal || !(samples[k].normal.cast<double>().dot(up) > kLeastUpright)) continue;
    waiting_[k] = true;
    order_.push_back(k);
  }
  const auto height = [&](std::size_t k) { return samples[k].point.cast<double>().dot(up); };
  std::sort(order_.begin(), order_.end(),
            [&](std::size_t a, std::size_t b) { return height(a) < height(b); });

  floor_.clear();
  for (const std::size_t k : order_) {
    if (!waiting_[k]) continue;
    flood(grid, k);
    if (floor_.empty()) {
      floor_ = segment_;
    } else if (planeDistance(averageOf(grid, floor_), averageOf(grid, segment_)) < kMergeDistance) {
      floor_.insert(floor_.end(), segment_.begin(), segment_.end());
    } else if (floor_.size() * kReplacement < segment_.size()) {
      floor_ = segment_;
    }
  }
  return leastSquares(grid, floor_, up);
}

}  // namespace polygonal_perception::reference
