#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include "segmentation_stage.hpp"

namespace polygonal_perception::perception {
namespace {

/// Scenes that a seed makes: the same with every standard library, which its distributions would not be.
class RandomScenes
{
public:
  explicit RandomScenes(std::uint32_t seed) : random_(seed) {}

  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(random_() % count); }
  double between(double low, double high)
  {
    return low + (high - low) * static_cast<double>(random_()) / 4294967295.0;
  }

  /// A scene of 1 to 4 planes, with holes and pixels without return.
  test::PlaneScene make(std::uint32_t width, std::uint32_t height)
  {
    test::PlaneScene scene(width, height, between(0.5, 1.5) * width);
    const std::uint32_t planes = 1 + below(4);
    for (std::uint32_t p = 0; p < planes; ++p) addPlane(scene);
    if (below(2) == 0) addNoise(scene.depth());
    for (std::uint32_t hole = below(4); hole > 0; --hole) cutHole(scene.depth(), width, height);
    if (below(2) == 0) loseReturns(scene.depth());
    return scene;
  }

private:
  Eigen::Vector3d direction()
  {
    Eigen::Vector3d v;
    do {
      v = {between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0)};
    } while (v.norm() < 0.1 || v.norm() > 1.0);
    return v.normalized();
  }

  /// Half a plane, or a strip of one.
  void addPlane(test::PlaneScene& scene)
  {
    Eigen::Vector3d normal = below(3) == 0 ? Eigen::Vector3d(0.0, -1.0, 0.0) : direction();
    if (normal.z() > 0.0) normal = -normal;
    const Eigen::Vector3d along = direction();
    const double from = between(-2.0, 1.0);
    const double to = from + between(0.05, 3.0);
    scene.add({normal, between(0.05, 2.5)},
              [&](const Eigen::Vector3d& p) { return along.dot(p) > from && along.dot(p) < to; });
  }

  void addNoise(std::vector<float>& depth)
  {
    const double scale = between(0.0, 3.0);
    for (float& z : depth) {
      double sum = -6.0;
      for (int k = 0; k < 12; ++k) sum += between(0.0, 1.0);
      z += static_cast<float>(scale * sum) * SensorNoise{}.at(z);
    }
  }

  void cutHole(std::vector<float>& depth, std::uint32_t width, std::uint32_t height)
  {
    const std::uint32_t left = below(width);
    const std::uint32_t right = left + below(width - left) + 1;
    const std::uint32_t top = below(height);
    const std::uint32_t bottom = top + below(height - top) / 2 + 1;
    const float with =
        below(2) == 0 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(between(0.2, 6.0));
    for (std::uint32_t v = top; v < bottom; ++v)
      std::fill(&depth[v * width + left], &depth[v * width + left] + (right - left), with);
  }

  void loseReturns(std::vector<float>& depth)
  {
    const std::uint32_t one_of = 2 + below(30);
    const float garbage[] = {std::numeric_limits<float>::quiet_NaN(), 0.0F,   -1.0F,
                             std::numeric_limits<float>::infinity(),  1e-30F, 1e6F};
    for (float& z : depth) {
      if (below(one_of) == 0) z = garbage[below(below(4) == 0 ? 6 : 1)];
    }
  }

  std::mt19937 random_;
};

double areaAbout(const Eigen::Vector3d& normal, const std::vector<Eigen::Vector3d>& ring)
{
  double area = 0.0;
  for (std::size_t k = 0; k < ring.size(); ++k)
    area += 0.5 * normal.dot(ring[k].cross(ring[(k + 1) % ring.size()]));
  return area;
}

void expectPlane(const test::Stage& stage, const SegmentedPlane& plane)
{
  EXPECT_NEAR(plane.plane.normal.norm(), 1.0, 1e-6);
  EXPECT_GT(plane.plane.distance, 0.0) << "the normal is not towards the sensor";
  EXPECT_TRUE(plane.covariance.allFinite()) << plane.covariance;
  EXPECT_TRUE(std::isfinite(plane.rms_error));
  EXPECT_TRUE(plane.vertex_count == 0 || plane.vertex_count >= 3) << plane.vertex_count << " vertices";
  ASSERT_LE(plane.first_vertex + plane.vertex_count, stage.seen.vertices.size());
  const auto ring = stage.boundaryOf(plane);
  for (const Eigen::Vector3d& vertex : ring) {
    ASSERT_TRUE(vertex.allFinite()) << vertex.transpose();
    EXPECT_NEAR(plane.plane.height(vertex), 0.0, 1e-4 * std::max(1.0, vertex.norm()))
        << "at " << vertex.transpose();
    EXPECT_LT(vertex.norm(), 1e3) << vertex.transpose();
  }
  EXPECT_GT(areaAbout(plane.plane.normal, ring), -1e-6) << "clockwise as the camera sees it";
}

TEST(RandomPlanes, AreListedAsTheyShouldBe)
{
  RandomScenes scenes(1);
  std::size_t listed = 0;
  for (int sequence = 0; sequence < 1500 && !HasFailure(); ++sequence) {
    test::Stage stage;
    std::uint32_t largest_id = 0;
    std::set<std::uint32_t> last_ids;
    std::uint32_t width = 1 + scenes.below(48);
    std::uint32_t height = 1 + scenes.below(40);
    for (int frame = 0; frame < 4; ++frame) {
      SCOPED_TRACE(testing::Message()
                   << "frame " << frame << " of sequence " << sequence << ", " << width << " x " << height);
      const auto& planes = stage.see(scenes.make(width, height));
      listed += planes.size();
      std::set<std::uint32_t> ids;
      std::uint32_t count = UINT32_MAX;
      for (const SegmentedPlane& plane : planes) {
        EXPECT_LE(plane.sample_count, count) << "not the largest first";
        count = plane.sample_count;
        EXPECT_TRUE(ids.insert(plane.id).second) << "id " << plane.id << " twice";
        EXPECT_TRUE(last_ids.count(plane.id) > 0 || plane.id > largest_id)
            << "id " << plane.id << " was given before";
        expectPlane(stage, plane);
      }
      if (!ids.empty()) largest_id = std::max(largest_id, *ids.rbegin());
      last_ids = ids;
      if (scenes.below(8) == 0) width = 1 + scenes.below(48);
      if (scenes.below(50) == 0) {
        stage.segmentation.reset();
        last_ids.clear();
      }
    }
  }
  EXPECT_GT(listed, 2000U) << "scenes without planes tell nothing";
}

}  // namespace
}  // namespace polygonal_perception::perception
