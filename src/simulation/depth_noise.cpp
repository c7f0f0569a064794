#include "polygonal_perception/simulation/depth_noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "polygonal_perception/simulation/random.hpp"

namespace polygonal_perception {
namespace simulation {
namespace {

constexpr float kNoReturn = std::numeric_limits<float>::quiet_NaN();
constexpr float kEdgeJump = 0.7F;  // [px] of disparity between neighbours: more than any slanted floor has
// Truncation after adding this rounds a positive number, without a call into libm.
constexpr float kHalf = 0.5F;
constexpr float kShadowMargin = 1.5F;  // [px] of disparity that something must be nearer by to keep light off

/// Nearly normal, zero mean, unit variance: the sum of four numbers of 16 bits each.
float nearlyNormal(std::uint64_t bits)
{
  const auto sum =
      static_cast<float>((bits & 0xFFFF) + ((bits >> 16) & 0xFFFF) + ((bits >> 32) & 0xFFFF) + (bits >> 48));
  return (sum - 131070.0F) * (1.7320508F / 65536.0F);
}

/// 0..1 from some of the bits.
float fraction(std::uint64_t bits)
{
  return static_cast<float>(bits & 0xFFFFFF) * (1.0F / 16777216.0F);
}

/// Weights whose squares sum up to 1: smoothing with them keeps the variance of independent values.
std::vector<float> smoothingKernel(double sigma)
{
  const int radius = static_cast<int>(std::ceil(2.5 * sigma));
  std::vector<float> kernel;
  float squares = 0.0F;
  for (int i = -radius; i <= radius; ++i) {
    kernel.push_back(static_cast<float>(sigma > 0.0 ? std::exp(-0.5 * i * i / (sigma * sigma)) : 1.0));
    squares += kernel.back() * kernel.back();
  }
  for (float& weight : kernel) weight /= std::sqrt(squares);
  return kernel;
}

/// The index on a ring of n values.
std::size_t wrap(std::ptrdiff_t i, std::ptrdiff_t n)
{
  while (i < 0) i += n;
  while (i >= n) i -= n;
  return static_cast<std::size_t>(i);
}

}  // namespace

DepthNoise::Parameters DepthNoise::Parameters::none()
{
  Parameters p;
  p.sigma_base = p.sigma_quadratic = p.correlation = p.disparity_step = 0.0;
  p.shadows = false;
  p.edge_loss = p.edge_jitter = p.blobs = p.grazing_cosine = p.dark_range = p.min_range = 0.0;
  p.max_range = 1000.0;
  return p;
}

DepthNoise::DepthNoise(const Parameters& parameters, std::uint64_t seed)
    : parameters_(parameters), seed_(seed)
{
  RangeCheck check;
  Parameters::describe(parameters_, check);
  if (check.offender() != nullptr)
    throw std::invalid_argument(std::string(check.offender()) + " is out of its range");
}

void DepthNoise::apply(const PinholeCamera& camera, const RayImage& image, std::uint32_t frame,
                       std::vector<float>& depth)
{
  const std::size_t size = camera.size();
  const std::uint64_t frame_seed = mixBits(seed_ ^ mixBits(frame));
  depth.resize(size);
  lost_.assign(size, 0);
  disparity_.resize(size);
  const auto disparity_scale = static_cast<float>(camera.fx * parameters_.baseline);
  for (std::size_t i = 0; i < size; ++i) {
    disparity_[i] = image.depth[i] > 0.0F ? disparity_scale / image.depth[i] : 0.0F;
  }
  drawField(camera, frame_seed);
  if (parameters_.shadows) castShadows(camera);
  punchBlobs(camera, frame_seed);

  const auto grazing = static_cast<float>(parameters_.grazing_cosine);
  const auto dark_range_squared = static_cast<float>(parameters_.dark_range * parameters_.dark_range);
  const auto loss = static_cast<float>(parameters_.edge_loss);
  const auto jitter = static_cast<float>(parameters_.edge_jitter);
  const auto nearest = static_cast<float>(parameters_.min_range);
  const auto farthest = static_cast<float>(parameters_.max_range);
  // Another part of the field, shifted far enough to be unrelated, decides what is lost: holes have smooth
  // rims.
  const std::size_t shift = size / 2 + camera.width / 3;
  for (std::size_t v = 0; v < camera.height; ++v) {
    for (std::size_t u = 0; u < camera.width; ++u) {
      const std::size_t i = v * camera.width + u;
      depth[i] = kNoReturn;
      if (lost_[i] != 0) continue;
      std::size_t from = i;
      if ((loss > 0.0F || jitter > 0.0F) && isEdge(camera, u, v)) {
        const std::uint64_t bits = mixBits(frame_seed ^ mixBits(i));
        if (fraction(bits) < loss) continue;
        const auto move = [&](std::uint64_t some, std::size_t at, std::uint32_t end) {
          const auto moved = static_cast<float>(at) + jitter * (2.0F * fraction(some) - 1.0F);
          return static_cast<std::size_t>(
              std::max(0.0F, std::min(std::round(moved), static_cast<float>(end - 1))));
        };
        from = move(bits >> 40, v, camera.height) * camera.width + move(bits >> 20, u, camera.width);
      }
      const float z = image.depth[from];
      const float chance = 1.0F + 0.25F * field_[i + shift < size ? i + shift : i + shift - size];
      if (image.cosine[from] < grazing * chance) continue;
      if (dark_range_squared > 0.0F && z * z > dark_range_squared * image.reflectance[from] * chance)
        continue;
      const float seen = measured(z, field_[i]);
      // Written so that NaN fails.
      if (seen >= nearest && seen <= farthest) depth[i] = seen;
    }
  }
}

float DepthNoise::measured(float depth, float field) const
{
  const float beyond = std::max(0.0F, depth - static_cast<float>(parameters_.sigma_onset));
  const float sigma = static_cast<float>(parameters_.sigma_base) +
                      static_cast<float>(parameters_.sigma_quadratic) * beyond * beyond;
  const float noisy = depth + sigma * field;
  if (parameters_.disparity_step <= 0.0) return noisy;
  const auto scale =
      static_cast<float>(parameters_.baseline * parameters_.disparity_focal / parameters_.disparity_step);
  return scale / static_cast<float>(static_cast<int>(scale / noisy + kHalf));
}

void DepthNoise::drawField(const PinholeCamera& camera, std::uint64_t frame_seed)
{
  const std::size_t size = camera.size();
  field_.resize(size);
  scratch_.resize(size);
  const std::vector<float> kernel = smoothingKernel(parameters_.correlation);
  const auto radius = static_cast<std::ptrdiff_t>(kernel.size() / 2);
  for (std::size_t i = 0; i < size; ++i) field_[i] = nearlyNormal(mixBits(frame_seed + i));
  if (radius == 0) return;

  // The image is taken as a torus: every pixel then has the same variance.
  const auto width = static_cast<std::ptrdiff_t>(camera.width);
  const auto height = static_cast<std::ptrdiff_t>(camera.height);
  std::vector<float> line(static_cast<std::size_t>(width + 2 * radius));
  for (std::ptrdiff_t v = 0; v < height; ++v) {
    for (std::ptrdiff_t u = -radius; u < width + radius; ++u) {
      line[static_cast<std::size_t>(u + radius)] =
          field_[static_cast<std::size_t>(v * width) + wrap(u, width)];
    }
    float* out = &scratch_[static_cast<std::size_t>(v * width)];
    std::fill(out, out + width, 0.0F);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      for (std::ptrdiff_t u = 0; u < width; ++u) out[u] += kernel[k] * line[static_cast<std::size_t>(u) + k];
    }
  }
  for (std::ptrdiff_t v = 0; v < height; ++v) {
    float* out = &field_[static_cast<std::size_t>(v * width)];
    std::fill(out, out + width, 0.0F);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const std::size_t row = wrap(v + static_cast<std::ptrdiff_t>(k) - radius, height);
      const float* in = &scratch_[row * camera.width];
      for (std::ptrdiff_t u = 0; u < width; ++u) out[u] += kernel[k] * in[u];
    }
  }
}

void DepthNoise::castShadows(const PinholeCamera& camera)
{
  // Seen from the projector, which stands to the camera's right, pixel u of disparity d lies in column u - d.
  // What is not nearest in its column is in the dark.
  const auto most =
      static_cast<float>(camera.fx * parameters_.baseline / std::max(0.1, parameters_.min_range));
  const auto offset = static_cast<std::size_t>(most) + 1;
  for (std::size_t v = 0; v < camera.height; ++v) {
    const float* disparity = &disparity_[v * camera.width];
    lit_.assign(offset + camera.width + 2, 0.0F);
    const auto column = [&](std::size_t u) {
      return static_cast<float>(u + offset) - std::min(disparity[u], most);
    };
    for (std::size_t u = 0; u < camera.width; ++u) {
      // A pixel lights two columns, so that a slanted surface leaves no gaps.
      const auto at = static_cast<std::size_t>(column(u));
      lit_[at] = std::max(lit_[at], disparity[u]);
      lit_[at + 1] = std::max(lit_[at + 1], disparity[u]);
    }
    for (std::size_t u = 0; u < camera.width; ++u) {
      const auto at = static_cast<std::size_t>(column(u) + kHalf);
      if (lit_[at] > disparity[u] + kShadowMargin) lost_[v * camera.width + u] = 1;
    }
  }
}

void DepthNoise::punchBlobs(const PinholeCamera& camera, std::uint64_t frame_seed)
{
  Random random(frame_seed, 1);
  const double scale = camera.width / 640.0;
  // Between none and twice the average.
  const auto count = static_cast<int>(random.uniform(0.0, 2.0 * parameters_.blobs + 1.0));
  for (int blob = 0; blob < count; ++blob) {
    const double centre_u = random.uniform(0.0, camera.width);
    const double centre_v = random.uniform(0.0, camera.height);
    const double radius_u = std::max(0.5, scale * parameters_.blob_radius * random.uniform(0.2, 2.0));
    const double radius_v = std::max(0.5, radius_u * random.uniform(0.4, 1.5));
    const auto first = [](double centre, double radius) {
      return static_cast<std::size_t>(std::max(0.0, centre - radius));
    };
    const auto end = [](double centre, double radius, std::uint32_t size) {
      return static_cast<std::size_t>(std::min(static_cast<double>(size), centre + radius + 1.0));
    };
    for (std::size_t v = first(centre_v, 1.5 * radius_v); v < end(centre_v, 1.5 * radius_v, camera.height);
         ++v) {
      for (std::size_t u = first(centre_u, 1.5 * radius_u); u < end(centre_u, 1.5 * radius_u, camera.width);
           ++u) {
        const double du = (static_cast<double>(u) - centre_u) / radius_u;
        const double dv = (static_cast<double>(v) - centre_v) / radius_v;
        const std::size_t i = v * camera.width + u;
        if (du * du + dv * dv < 1.0 + 0.4 * field_[i]) lost_[i] = 1;
      }
    }
  }
}

bool DepthNoise::isEdge(const PinholeCamera& camera, std::size_t u, std::size_t v) const
{
  const std::size_t i = v * camera.width + u;
  const float here = disparity_[i];
  const auto jumps = [&](std::size_t other) { return std::abs(disparity_[other] - here) > kEdgeJump; };
  return (u > 0 && jumps(i - 1)) || (u + 1 < camera.width && jumps(i + 1)) ||
         (v > 0 && jumps(i - camera.width)) || (v + 1 < camera.height && jumps(i + camera.width));
}

}  // namespace simulation
}  // namespace polygonal_perception
