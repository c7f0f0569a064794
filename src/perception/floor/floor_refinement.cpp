#include "perception/floor/floor_refinement.hpp"

#include <algorithm>
#include <array>

namespace polygonal_perception::perception {

namespace {

NoisyPixels::Band bandOf(const FloorRefinementParameters& parameters)
{
  return {static_cast<float>(parameters.inlier_sigmas), static_cast<float>(parameters.inlier_distance),
          static_cast<float>(parameters.model_error), static_cast<float>(parameters.model_error_slope)};
}

}  // namespace

void FloorRefinement::take(const PointView& points, const SensorNoise& noise)
{
  // Rows lie closer than columns: a floor that is seen from the side is a narrow strip at the image's foot.
  constexpr std::uint32_t kColumns = 53;
  constexpr std::uint32_t kRows = 96;
  const std::uint32_t step_u = std::max(1U, points.width() / kColumns);
  const std::uint32_t step_v = std::max(1U, points.height() / kRows);
  const std::uint32_t columns = (points.width() - step_u / 2 + step_u - 1) / step_u;
  const std::uint32_t rows = (points.height() - step_v / 2 + step_v - 1) / step_v;
  pixels_.resize(std::size_t{columns} * rows, columns);
  std::size_t k = 0;
  for (std::uint32_t v = step_v / 2; v < points.height(); v += step_v) {
    const std::uint32_t next = std::min(v + step_v, points.height() - 1);
    for (std::uint32_t u = step_u / 2; u < points.width(); u += step_u) points.prefetch(u, next);
    for (std::uint32_t u = step_u / 2; u < points.width(); u += step_u) pixels_.set(k++, points.point(u, v));
  }
  pixels_.measure(noise);
}

void FloorRefinement::pickInliers(const Parameters& parameters)
{
  const auto steepest = static_cast<float>(parameters.steepest);
  const auto sigmas = static_cast<float>(parameters.steepest_sigmas);
  const std::size_t looked_at =
      pixels_.pick([&](std::size_t k) { return pixels_.liesFlat(k, steepest, sigmas); },
                   static_cast<std::size_t>(parameters.enough_pixels), picked_);
  flat_ = static_cast<double>(picked_.size()) / static_cast<double>(std::max<std::size_t>(1, looked_at));
}

float FloorRefinement::medianDeviation() const
{
  if (picked_.empty()) return 0.0F;
  // A histogram is fine enough for what it decides, and spares a sort by comparisons that nobody can predict.
  constexpr float kBinsPerSigma = 64.0F;
  std::array<std::uint32_t, 256> histogram{};
  constexpr float kLastBin = static_cast<float>(histogram.size() - 1);
  for (const std::uint32_t k : picked_) {
    ++histogram[static_cast<std::size_t>(std::min(kLastBin, kBinsPerSigma * pixels_.normalizedResidual(k)))];
  }
  std::size_t bin = 0;
  std::size_t up_to_bin = histogram[0];
  while (up_to_bin <= picked_.size() / 2) up_to_bin += histogram[++bin];
  return (static_cast<float>(bin) + 0.5F) / kBinsPerSigma;
}

PlaneFit FloorRefinement::fitClipped(const Parameters& parameters) const
{
  const float limit = static_cast<float>(parameters.clip) * medianDeviation();
  PlaneFit fit;
  for (const std::uint32_t k : picked_) {
    if (pixels_.normalizedResidual(k) < limit) pixels_.addTo(fit, k);
  }
  return fit;
}

std::optional<FloorRefinement::Result> FloorRefinement::refine(const geometry::Plane& rough,
                                                               const std::vector<geometry::Plane>& rivals,
                                                               const Parameters& parameters)
{
  pixels_.computeResiduals(rough, bandOf(parameters));
  for (const geometry::Plane& rival : rivals) pixels_.giveTo(rival);
  pickInliers(parameters);
  const auto first = fitClipped(parameters).solve(rough.normal);
  if (!first) return std::nullopt;
  // Once more, for what is clipped depends on the plane.
  pixels_.computeResidualsOf(picked_, first->plane, bandOf(parameters));
  const PlaneFit points = fitClipped(parameters);
  const auto fit = points.solve(rough.normal);
  if (!fit) return std::nullopt;
  if (flat_ < parameters.least_flat || fit->normal_sigma > parameters.largest_normal_sigma) {
    return std::nullopt;
  }
  return Result{*fit, points.covariance(*fit)};
}

std::optional<FloorRefinement::Result> FloorRefinement::findStripBelow(const geometry::Plane& platform,
                                                                       double deepest,
                                                                       const Parameters& parameters)
{
  pixels_.computeResiduals(platform, bandOf(parameters));
  below_.clear();
  below_sigma_ = 0.0F;
  nearly_below_.clear();
  const auto clearly = static_cast<float>(parameters.strip_sigmas);
  pixels_.forEachBelow(static_cast<float>(std::min(parameters.strip_gap_sigmas, parameters.strip_sigmas)),
                       static_cast<float>(parameters.strip_error_slope),
                       [&](std::size_t k, float height, float sigma) {
                         if (platform.distance - height > deepest ||
                             !pixels_.liesFlat(k, static_cast<float>(parameters.steepest),
                                               static_cast<float>(parameters.steepest_sigmas))) {
                           return;
                         }
                         if (height < -clearly * sigma) {
                           below_.push_back(height);
                           below_sigma_ += sigma;
                         } else {
                           nearly_below_.push_back(height);
                         }
                       });
  const auto height = heightOfStrip(parameters);
  if (!height) return std::nullopt;
  pixels_.computeResiduals({platform.normal, platform.distance - *height}, bandOf(parameters));
  pixels_.giveTo(platform);
  pickInliers(parameters);
  const PlaneFit points = fitClipped(parameters);
  const auto fit = points.solveNear(platform, parameters.strip_normal_sigma);
  if (!fit) return std::nullopt;
  return Result{*fit, points.covariance(*fit, parameters.strip_normal_sigma)};
}

std::optional<double> FloorRefinement::heightOfStrip(const Parameters& parameters)
{
  const auto enough = std::max<std::size_t>(
      1, static_cast<std::size_t>(parameters.strip_support * static_cast<double>(pixels_.size())));
  if (below_.size() < enough) return std::nullopt;
  const float window =
      static_cast<float>(parameters.strip_width) * below_sigma_ / static_cast<float>(below_.size());
  std::sort(below_.begin(), below_.end());
  std::size_t first = 0;
  std::size_t most = 0;
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < below_.size(); ++begin) {
    while (end < below_.size() && below_[end] - below_[begin] < window) ++end;
    if (end - begin <= most) continue;
    most = end - begin;
    first = begin;
  }
  if (most < enough) return std::nullopt;
  // Between the two lies hardly anything, as densely as the strip: a floor that bends down, and what a floor mirrors,
  // is everywhere.
  const float top = below_[first + most - 1];
  auto in_gap = static_cast<double>(below_.size() - first - most);
  float highest = below_.back();
  for (const float height : nearly_below_) {
    in_gap += height > top ? 1.0 : 0.0;
    highest = std::max(highest, height);
  }
  if (parameters.strip_contrast * in_gap * window > static_cast<double>(most) * (highest - top))
    return std::nullopt;
  return below_[first + most / 2];
}

}  // namespace polygonal_perception::perception
