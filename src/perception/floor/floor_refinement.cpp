#include "perception/floor/floor_refinement.hpp"

#include <algorithm>
#include <array>

#include "perception/floor/floor_candidates.hpp"

namespace polygonal_perception::perception {

void FloorRefinement::take(const PointView& points)
{
  // Rows lie closer than columns: a floor that is seen from the side is a narrow strip at the image's foot.
  constexpr std::uint32_t kColumns = 53;
  constexpr std::uint32_t kRows = 96;
  const std::uint32_t step_u = std::max(1U, points.width() / kColumns);
  const std::uint32_t step_v = std::max(1U, points.height() / kRows);
  columns_ = (points.width() - step_u / 2 + step_u - 1) / step_u;
  const std::uint32_t rows = (points.height() - step_v / 2 + step_v - 1) / step_v;
  pixels_.resize(std::size_t{columns_} * rows);
  std::size_t k = 0;
  for (std::uint32_t v = step_v / 2; v < points.height(); v += step_v) {
    const std::uint32_t next = std::min(v + step_v, points.height() - 1);
    for (std::uint32_t u = step_u / 2; u < points.width(); u += step_u) points.prefetch(u, next);
    for (std::uint32_t u = step_u / 2; u < points.width(); u += step_u) pixels_.set(k++, points.point(u, v));
  }
}

bool FloorRefinement::liesFlat(std::size_t k) const
{
  // The foot of a wall lies in the floor's band too, but runs across it: it would tilt the fit.
  return (k < columns_ || pixels_.runsAlong(k, k - columns_)) &&
         (k + columns_ >= pixels_.size() || pixels_.runsAlong(k, k + columns_));
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

std::optional<FloorRefinement::Result> FloorRefinement::refine(const geometry::Plane& rough,
                                                               const FloorDetector::Parameters& parameters)
{
  // A fit through this many pixels errs by less than the camera's own calibration.
  constexpr std::size_t kEnough = 700;
  // What lies farther off than this many times the median distance (2.5 standard deviations) is dropped,
  // again for the new plane: the foot of a lamp is nearer to the floor than the noise model alone could tell.
  constexpr float kClip = 3.7F;
  constexpr float kLeastClip = 0.5F;
  constexpr int kRounds = 2;
  constexpr double kLargestNormalSigma = 0.02;  // [rad] more uncertain than this it is no floor
  constexpr double kLeastSupport = 0.006;       // of all pixels
  // The plane along the noses of a staircase has many points near it, but the surface runs along it in few: a
  // fifth to two fifths, on floors more than half.
  constexpr double kLeastFlat = 0.45;

  const NoisyPoints::Band band = bandOf(parameters);
  std::optional<PlaneFit::Result> fit;
  geometry::Plane plane = rough;
  double flat = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    pixels_.computeResiduals(plane, band);
    const std::size_t looked_at =
        pixels_.pick([this](std::size_t k) { return liesFlat(k); }, kEnough, picked_);
    flat = static_cast<double>(picked_.size()) / static_cast<double>(std::max<std::size_t>(1, looked_at));
    const float limit = std::max(kLeastClip, kClip * medianDeviation());
    PlaneFit clipped;
    for (const std::uint32_t k : picked_) {
      if (pixels_.normalizedResidual(k) < limit) pixels_.addTo(clipped, k);
    }
    fit = clipped.solve(rough.normal);
    if (!fit) return std::nullopt;
    plane = fit->plane;
  }
  // How the points lie about the last plane but one: another sweep over all of them would hardly count them
  // differently.
  const NoisyPoints::InlierCount counts = pixels_.counts();
  if (flat < kLeastFlat || fit->normal_sigma > kLargestNormalSigma ||
      counts.inliers < kLeastSupport * static_cast<double>(pixels_.size())) {
    return std::nullopt;
  }
  return Result{*fit, counts};
}

}  // namespace polygonal_perception::perception
