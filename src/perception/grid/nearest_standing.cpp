#include "perception/grid/nearest_standing.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

namespace polygonal_perception::perception {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

}  // namespace

void NearestStanding::setUp(const BearingBins& bins, std::uint32_t rows_per_band,
                            const FloorPointNoise& noise, double sigmas)
{
  rows_per_band_ = rows_per_band;
  rule_ = {static_cast<float>(bins.first - 0.5 * bins.increment),
           static_cast<float>(1.0 / bins.increment),
           static_cast<float>(bins.count),
           noise.sensorHeight(),
           static_cast<float>(sigmas),
           static_cast<float>(noise.sensor().constant),
           static_cast<float>(noise.sensor().linear),
           static_cast<float>(noise.sensor().quadratic),
           {}};
  const Eigen::Matrix3f& c = noise.covariance();
  const float form[] = {c(0, 0), 2.0F * c(0, 1), 2.0F * c(0, 2), c(1, 1), 2.0F * c(1, 2), c(2, 2)};
  std::copy(std::begin(form), std::end(form), rule_.floor_covariance);
  squared_.assign(bins.count, kInfinity);
}

NearestLanes NearestStanding::begin(const ProjectionKernel& kernel, const PointView& points)
{
  kernel_ = &kernel;
  band_end_ = rows_per_band_;
  width_ = (points.width() + kBlock - 1) / kBlock * kBlock;
  lanes_.assign(4 * width_, kInfinity);
  found_ = 0;
  changed_.assign(width_ / kBlock, 0);
  float* const lanes = lanes_.data();
  return {lanes, lanes + width_, lanes + 2 * width_, lanes + 3 * width_, changed_.data()};
}

void NearestStanding::endBand()
{
  band_end_ += rows_per_band_;
  for (std::vector<float>* values : {&x_, &y_, &height_}) values->resize(found_ + width_);
  for (std::size_t block = 0; block < changed_.size(); ++block) {
    if (changed_[block] == 0) continue;
    changed_[block] = 0;
    float* const lanes = lanes_.data() + block * kBlock;
    for (std::size_t lane = 0; lane < kBlock; ++lane) {
      // Written, and written over where nothing stands: a processor could not guess where.
      x_[found_] = lanes[width_ + lane];
      y_[found_] = lanes[2 * width_ + lane];
      height_[found_] = rule_.sensor_height + lanes[3 * width_ + lane];
      found_ += lanes[lane] < kInfinity ? 1 : 0;
      lanes[lane] = kInfinity;
    }
  }
}

void NearestStanding::lookUp()
{
  bin_.resize(x_.size());
  kernel_->bins(rule_, x_.data(), y_.data(), height_.data(), found_, bin_.data());
  for (std::size_t k = 0; k < found_; ++k) {
    if (bin_[k] < 0) continue;
    if (occupancy_ != nullptr) {
      const auto cell = occupancy_->geometry().cellOf(x_[k], y_[k]);
      if (!cell || occupancy_->cells()[*cell] == 0) continue;
    }
    float& nearest = squared_[static_cast<std::size_t>(bin_[k])];
    nearest = std::min(nearest, x_[k] * x_[k] + y_[k] * y_[k]);
  }
  found_ = 0;
}

}  // namespace polygonal_perception::perception
