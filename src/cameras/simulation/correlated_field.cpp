#include "cameras/simulation/correlated_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "polygonal_perception/cameras/simulation/random.hpp"

namespace polygonal_perception::simulation {
namespace {

/// The sum of four numbers of 16 bits each, less its mean, over its standard deviation.
float nearlyNormal(std::uint64_t bits)
{
  const auto sum =
      static_cast<float>((bits & 0xFFFF) + ((bits >> 16) & 0xFFFF) + ((bits >> 32) & 0xFFFF) + (bits >> 48));
  return (sum - 131070.0F) * (1.7320508F / 65536.0F);
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

/// The index on a ring of n values. The image is smoothed as a torus, so that every pixel has the same
/// variance.
std::size_t wrap(std::ptrdiff_t i, std::ptrdiff_t n)
{
  while (i < 0) i += n;
  while (i >= n) i -= n;
  return static_cast<std::size_t>(i);
}

}  // namespace

void drawCorrelatedField(std::uint32_t width, std::uint32_t height, double sigma, std::uint64_t seed,
                         std::vector<float>& field, std::vector<float>& scratch)
{
  const std::size_t size = static_cast<std::size_t>(width) * height;
  field.resize(size);
  for (std::size_t i = 0; i < size; ++i) field[i] = nearlyNormal(mixBits(seed + i));
  const std::vector<float> kernel = smoothingKernel(sigma);
  const auto radius = static_cast<std::ptrdiff_t>(kernel.size() / 2);
  if (radius == 0) return;

  scratch.resize(size);
  std::vector<float> line(width + kernel.size() - 1);
  for (std::size_t v = 0; v < height; ++v) {
    const float* in = &field[v * width];
    for (std::size_t i = 0; i < line.size(); ++i)
      line[i] = in[wrap(static_cast<std::ptrdiff_t>(i) - radius, width)];
    float* out = &scratch[v * width];
    std::fill(out, out + width, 0.0F);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      for (std::size_t u = 0; u < width; ++u) out[u] += kernel[k] * line[u + k];
    }
  }
  for (std::size_t v = 0; v < height; ++v) {
    float* out = &field[v * width];
    std::fill(out, out + width, 0.0F);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const float* in = &scratch[wrap(static_cast<std::ptrdiff_t>(v + k) - radius, height) * width];
      for (std::size_t u = 0; u < width; ++u) out[u] += kernel[k] * in[u];
    }
  }
}

}  // namespace polygonal_perception::simulation
