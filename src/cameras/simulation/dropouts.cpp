#include "cameras/simulation/dropouts.hpp"

#include <algorithm>
#include <cmath>

#include "polygonal_perception/cameras/simulation/random.hpp"

namespace polygonal_perception::simulation {
namespace {

constexpr float kEdgeJump = 0.7F;  // [px] of disparity between neighbours: more than any slanted floor has
constexpr float kShadowMargin = 1.5F;  // [px] of disparity that something must be nearer by to keep light off
constexpr float kRounding = 0.5F;      // truncation after adding it rounds a positive number

/// The part of 0..size-1 that lies within a distance of a centre.
struct Span
{
  Span(double centre, double reach, std::uint32_t size)
      : first(static_cast<std::size_t>(std::max(0.0, centre - reach))),
        end(static_cast<std::size_t>(std::min(static_cast<double>(size), centre + reach + 1.0)))
  {
  }
  std::size_t first;
  std::size_t end;
};

}  // namespace

void markShadows(const PinholeCamera& camera, const std::vector<float>& disparity, std::vector<float>& line,
                 std::vector<std::uint8_t>& mask)
{
  // Seen from the projector, pixel u of disparity d lies in column u - d. What is not nearest in its column
  // is in the dark.
  const auto offset = static_cast<std::size_t>(*std::max_element(disparity.begin(), disparity.end())) + 1;
  for (std::size_t v = 0; v < camera.height; ++v) {
    const float* row = &disparity[v * camera.width];
    line.assign(offset + camera.width + 2, 0.0F);
    const auto column = [&](std::size_t u) { return static_cast<float>(u + offset) - row[u]; };
    for (std::size_t u = 0; u < camera.width; ++u) {
      // A pixel lights two columns, so that a slanted surface leaves no gaps.
      const auto at = static_cast<std::size_t>(column(u));
      line[at] = std::max(line[at], row[u]);
      line[at + 1] = std::max(line[at + 1], row[u]);
    }
    for (std::size_t u = 0; u < camera.width; ++u) {
      const auto at = static_cast<std::size_t>(column(u) + kRounding);
      if (line[at] > row[u] + kShadowMargin) mask[v * camera.width + u] = 1;
    }
  }
}

void markEdges(const PinholeCamera& camera, const std::vector<float>& disparity, int width,
               std::vector<std::uint8_t>& mask)
{
  const auto reach = static_cast<std::size_t>(width);
  for (std::size_t v = 0; v < camera.height; ++v) {
    for (std::size_t u = 0; u < camera.width; ++u) {
      const std::size_t i = v * camera.width + u;
      if (u + 1 < camera.width && std::abs(disparity[i + 1] - disparity[i]) > kEdgeJump) {
        const std::size_t end = std::min<std::size_t>(u + reach + 1, camera.width);
        for (std::size_t near = u + 1 - std::min(reach, u + 1); near < end; ++near)
          mask[v * camera.width + near] = 1;
      }
      if (v + 1 < camera.height && std::abs(disparity[i + camera.width] - disparity[i]) > kEdgeJump) {
        const std::size_t end = std::min<std::size_t>(v + reach + 1, camera.height);
        for (std::size_t near = v + 1 - std::min(reach, v + 1); near < end; ++near)
          mask[near * camera.width + u] = 1;
      }
    }
  }
}

void markBlobs(const PinholeCamera& camera, double average, double radius,
               const std::vector<float>& raggedness, std::uint64_t seed, std::vector<std::uint8_t>& mask)
{
  Random random(seed, 1);
  // Between none and twice the average.
  const auto count = static_cast<int>(random.uniform(0.0, 2.0 * average + 1.0));
  for (int blob = 0; blob < count; ++blob) {
    const double centre_u = random.uniform(0.0, camera.width);
    const double centre_v = random.uniform(0.0, camera.height);
    const double radius_u = std::max(0.5, radius * random.uniform(0.2, 2.0));
    const double radius_v = std::max(0.5, radius_u * random.uniform(0.4, 1.5));
    const Span columns(centre_u, 1.5 * radius_u, camera.width);
    const Span rows(centre_v, 1.5 * radius_v, camera.height);
    for (std::size_t v = rows.first; v < rows.end; ++v) {
      for (std::size_t u = columns.first; u < columns.end; ++u) {
        const double du = (static_cast<double>(u) - centre_u) / radius_u;
        const double dv = (static_cast<double>(v) - centre_v) / radius_v;
        const std::size_t i = v * camera.width + u;
        if (du * du + dv * dv < 1.0 + 0.4 * raggedness[i]) mask[i] = 1;
      }
    }
  }
}

void markDeadColumns(const PinholeCamera& camera, std::uint32_t columns, std::vector<std::uint8_t>& mask)
{
  const std::size_t dead = std::min(columns, camera.width);
  for (std::size_t v = 1; v <= camera.height; ++v) {
    const auto end = mask.begin() + static_cast<std::ptrdiff_t>(v * camera.width);
    std::fill(end - static_cast<std::ptrdiff_t>(dead), end, std::uint8_t{1});
  }
}

}  // namespace polygonal_perception::simulation
