#include "polygonal_perception/cameras/simulation/depth_noise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "cameras/simulation/correlated_field.hpp"
#include "cameras/simulation/dropouts.hpp"
#include "polygonal_perception/cameras/simulation/random.hpp"
#include "polygonal_perception/parameters/parameter_check.hpp"

namespace polygonal_perception::simulation {
namespace {

constexpr float kNoReturn = std::numeric_limits<float>::quiet_NaN();
constexpr float kLeast = 1e-3F;  // [m] no depth is less
constexpr float kHalf = 0.5F;    // truncation after adding it rounds a positive number, without libm
constexpr float kReferenceWidth = 640.0F;  // [px] of the image that sizes in pixels are given for
constexpr std::size_t kPatch = 3;          // [px] a matcher loses patches, not single pixels

/// 0..1 from some of the bits.
float fraction(std::uint64_t bits)
{
  return static_cast<float>(bits & 0xFFFFF) * (1.0F / 1048576.0F);
}

/// The disparities of an ideal image [px], 0 where there is no return.
void toDisparity(const std::vector<float>& depth, float scale, std::vector<float>& disparity)
{
  disparity.resize(depth.size());
  for (std::size_t i = 0; i < depth.size(); ++i) disparity[i] = depth[i] > kLeast ? scale / depth[i] : 0.0F;
}

}  // namespace

DepthNoise::Parameters DepthNoise::Parameters::none()
{
  Parameters p;
  p.sigma_base = p.sigma_quadratic = p.correlation = p.disparity_step = 0.0;
  p.shadows = false;
  p.edge_loss = p.edge_jitter = p.blobs = p.grazing_cosine = p.dark_range = p.min_range = 0.0;
  p.dead_columns = 0;
  p.max_range = 1000.0;
  return p;
}

DepthNoise::DepthNoise(const Parameters& parameters, std::uint64_t seed)
    : parameters_(parameters), seed_(seed)
{
  if (const auto fault = parameters::findOutOfRange(parameters)) throw std::invalid_argument(fault->reason);
}

void DepthNoise::apply(const PinholeCamera& camera, const RayImage& image, std::uint32_t frame,
                       std::vector<float>& depth)
{
  const std::uint64_t frame_seed = mixBits(seed_ ^ mixBits(frame));
  drawCorrelatedField(camera.width, camera.height, parameters_.correlation, frame_seed, field_, scratch_);
  markDropouts(camera, image, frame_seed);

  depth.resize(camera.size());
  const auto loss = static_cast<float>(parameters_.edge_loss);
  const std::size_t patches = camera.width / kPatch + 1;
  for (std::size_t v = 0; v < camera.height; ++v) {
    for (std::size_t u = 0; u < camera.width; ++u) {
      const std::size_t i = v * camera.width + u;
      depth[i] = kNoReturn;
      if (lost_[i] != 0) continue;
      std::size_t from = i;
      if (edge_[i] != 0) {
        const std::uint64_t patch = mixBits(frame_seed ^ mixBits(v / kPatch * patches + u / kPatch));
        if (fraction(patch) < loss) continue;
        from = strayed(camera, u, v, mixBits(frame_seed ^ mixBits(~i)));
      }
      if (!reflects(image, from, patchField(camera, u, v))) continue;
      const float seen = measured(image.depth[from], field_[i]);
      // Written so that NaN fails.
      if (seen >= static_cast<float>(parameters_.min_range) &&
          seen <= static_cast<float>(parameters_.max_range)) {
        depth[i] = seen;
      }
    }
  }
}

void DepthNoise::markDropouts(const PinholeCamera& camera, const RayImage& image, std::uint64_t frame_seed)
{
  const double scale = camera.width / static_cast<double>(kReferenceWidth);
  toDisparity(image.depth, static_cast<float>(camera.fx * parameters_.baseline), disparity_);
  lost_.assign(camera.size(), 0);
  edge_.assign(camera.size(), 0);
  if (parameters_.shadows) markShadows(camera, disparity_, scratch_, lost_);
  if (parameters_.edge_loss > 0.0 || parameters_.edge_jitter > 0.0) {
    markEdges(camera, disparity_, parameters_.edge_width, edge_);
  }
  markBlobs(camera, parameters_.blobs, scale * parameters_.blob_radius, field_, frame_seed, lost_);
  markDeadColumns(camera, static_cast<std::uint32_t>(std::lround(scale * parameters_.dead_columns)), lost_);
}

float DepthNoise::patchField(const PinholeCamera& camera, std::size_t u, std::size_t v) const
{
  // Another part of the field, far enough away to be unrelated to the error of the depth, and magnified.
  const std::size_t i = camera.size() / 2 + v / kPatch * camera.width + u / kPatch;
  return field_[std::min(i, camera.size() - 1)];
}

std::size_t DepthNoise::strayed(const PinholeCamera& camera, std::size_t u, std::size_t v,
                                std::uint64_t bits) const
{
  const auto move = [this](std::uint64_t some, std::size_t at, std::uint32_t end) {
    const auto reach = static_cast<float>(parameters_.edge_jitter);
    const float moved = static_cast<float>(at) + reach * (2.0F * fraction(some) - 1.0F);
    return static_cast<std::size_t>(std::max(0.0F, std::min(std::round(moved), static_cast<float>(end - 1))));
  };
  return move(bits, v, camera.height) * camera.width + move(bits >> 32, u, camera.width);
}

bool DepthNoise::reflects(const RayImage& image, std::size_t i, float field) const
{
  const float chance = 1.0F + 0.25F * field;
  if (image.cosine[i] < static_cast<float>(parameters_.grazing_cosine) * chance) return false;
  const auto range = static_cast<float>(parameters_.dark_range);
  return range <= 0.0F || image.depth[i] * image.depth[i] <= range * range * image.reflectance[i] * chance;
}

float DepthNoise::measured(float depth, float field) const
{
  const float beyond = std::max(0.0F, depth - static_cast<float>(parameters_.sigma_onset));
  const float sigma = static_cast<float>(parameters_.sigma_base) +
                      static_cast<float>(parameters_.sigma_quadratic) * beyond * beyond;
  const float noisy = depth + sigma * field;
  // Written so that NaN fails.
  if (!(noisy > kLeast)) return kNoReturn;
  if (parameters_.disparity_step <= 0.0) return noisy;
  const auto scale =
      static_cast<float>(parameters_.baseline * parameters_.disparity_focal / parameters_.disparity_step);
  return scale / static_cast<float>(static_cast<int>(scale / noisy + kHalf));
}

}  // namespace polygonal_perception::simulation
