#include "inflation_methods.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "polygonal_perception/occupancy/grid/inflation.hpp"

namespace polygonal_perception::evaluation {
namespace {

/// The cells of a grid as an image, without a copy.
cv::Mat1b imageOf(occupancy::BinaryGrid& grid)
{
  return cv::Mat1b(grid.cellsY(), grid.cellsX(), grid.row(0));
}
cv::Mat1b imageOf(const occupancy::BinaryGrid& grid)
{
  return imageOf(const_cast<occupancy::BinaryGrid&>(grid));
}

class BitWords : public InflationMethod
{
public:
  explicit BitWords(double robot_radius) : inflation_({robot_radius}) {}
  std::string name() const override { return "bit words (this package)"; }
  void inflate(const occupancy::BinaryGrid& occupancy, occupancy::BinaryGrid& inflated) override
  {
    inflation_.inflate(occupancy, inflated);
  }

private:
  occupancy::Inflation inflation_;
};

class Dilation : public InflationMethod
{
public:
  Dilation(std::string name, cv::Mat1b kernel) : name_(std::move(name)), kernel_(std::move(kernel)) {}
  std::string name() const override { return name_; }
  void inflate(const occupancy::BinaryGrid& occupancy, occupancy::BinaryGrid& inflated) override
  {
    inflated.reset(occupancy.geometry());
    cv::Mat1b to = imageOf(inflated);
    cv::dilate(imageOf(occupancy), to, kernel_);
  }

private:
  std::string name_;
  cv::Mat1b kernel_;
};

/// Distances between cells' squares are those from the centres of the occupied cells and their neighbours.
class DistanceTransform : public InflationMethod
{
public:
  explicit DistanceTransform(double radius) : radius_(radius) {}
  std::string name() const override { return "cv::distanceTransform, precise"; }
  void inflate(const occupancy::BinaryGrid& occupancy, occupancy::BinaryGrid& inflated) override
  {
    inflated.reset(occupancy.geometry());
    cv::dilate(imageOf(occupancy), free_, cv::Mat1b::ones(3, 3));
    cv::bitwise_xor(free_, 1, free_);
    cv::distanceTransform(free_, distance_, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    cv::Mat1b to = imageOf(inflated);
    cv::compare(distance_, radius_ - 1e-4, to, cv::CMP_LT);
    cv::bitwise_and(to, 1, to);
  }

private:
  double radius_;  // [cells]
  cv::Mat1b free_;
  cv::Mat1f distance_;
};

/// The kernel whose cells come within a radius [cells] of the square of the middle one.
cv::Mat1b exactKernel(double radius)
{
  const int reach = static_cast<int>(std::ceil(radius - 1e-9));
  cv::Mat1b kernel(2 * reach + 1, 2 * reach + 1, std::uint8_t{0});
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const double gap = std::hypot(std::max(0, std::abs(dx) - 1), std::max(0, std::abs(dy) - 1));
      kernel(dy + reach, dx + reach) = gap < radius - 1e-9 ? 1 : 0;
    }
  }
  return kernel;
}

}  // namespace

std::vector<std::unique_ptr<InflationMethod>> makeInflationMethods(double robot_radius, double resolution)
{
  const double radius = robot_radius / resolution;
  const int whole = static_cast<int>(std::lround(radius));
  std::vector<std::unique_ptr<InflationMethod>> methods;
  methods.push_back(std::make_unique<BitWords>(robot_radius));
  methods.push_back(std::make_unique<Dilation>("cv::dilate, exact kernel", exactKernel(radius)));
  methods.push_back(std::make_unique<DistanceTransform>(radius));
  methods.push_back(std::make_unique<Dilation>(
      "cv::dilate, ellipse (paper)",
      cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(2 * whole + 1, 2 * whole + 1))));
  return methods;
}

}  // namespace polygonal_perception::evaluation
