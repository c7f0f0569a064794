#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <ostream>
#include <random>
#include <vector>

#include "perception/planes/plane_extraction.hpp"
#include "polygonal_perception/geometry/angle.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kNoiseAt1m = 0.0019;  // [m] of an Xtion
constexpr double kNoiseAt2m = 0.006;

const geometry::Plane kFloor = test::floorSeenFrom(0.8, 0.6);
const Eigen::Vector3d kAhead(0.0, kFloor.normal.z(), -kFloor.normal.y());  // along the floor

PlaneExtraction extract(const test::PlaneScene& scene, const std::optional<geometry::Plane>& known = {})
{
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene.view());
  PlaneExtraction extraction;
  extraction.extract(grid, PlaneExtractionParameters{}, known);
  return extraction;
}

/// The planes with at least so many samples, the nearest first.
std::vector<ExtractedPlane> planesOf(const PlaneExtraction& extraction, std::uint32_t least = 0)
{
  std::vector<ExtractedPlane> planes;
  for (const ExtractedPlane& plane : extraction.planes()) {
    if (plane.size >= least) planes.push_back(plane);
  }
  std::sort(planes.begin(), planes.end(), [](const ExtractedPlane& a, const ExtractedPlane& b) {
    return a.fit.plane.distance < b.fit.plane.distance;
  });
  return planes;
}

bool isLeft(const Eigen::Vector3d& p)
{
  return p.x() < 0.0;
}

bool isRight(const Eigen::Vector3d& p)
{
  return p.x() >= 0.0;
}

/// How a plane is seen, with its noise.
struct Seen
{
  const char* how;
  geometry::Plane plane;
  double sigma;
};

void PrintTo(const Seen& seen, std::ostream* out)
{
  *out << seen.how << " with a noise of " << seen.sigma << " m";
}

class ParallelPlanes : public testing::TestWithParam<Seen>
{
};

TEST_P(ParallelPlanes, StayTwo)
{
  const auto& [how, plane, sigma] = GetParam();
  for (const double step : {0.03, 0.05, 0.1}) {
    test::PlaneScene scene(160, 120, 142.5, sigma);
    scene.add(plane, isRight);
    scene.add(test::raised(plane, step), isLeft);
    const PlaneExtraction extraction = extract(scene);
    const auto planes = planesOf(extraction, 50);
    EXPECT_EQ(planes.size(), 2U) << how << ", step " << step;
    if (planes.size() != 2) continue;
    EXPECT_NEAR(planes[0].fit.plane.distance, plane.distance - step, 0.006) << how << ", step " << step;
    EXPECT_NEAR(planes[1].fit.plane.distance, plane.distance, 0.006) << how << ", step " << step;
    for (const ExtractedPlane& found : planes) {
      EXPECT_GT(found.size, 350U) << how << ", step " << step;
      EXPECT_LT(geometry::angleBetween(found.fit.plane.normal, plane.normal) / kDegree, 1.0)
          << how << ", step " << step;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    StepsOf3To10Centimetres, ParallelPlanes,
    testing::Values(Seen{"a wall 1 m away", {-Eigen::Vector3d::UnitZ(), 1.0}, kNoiseAt1m},
                    Seen{"a wall 2 m away", {-Eigen::Vector3d::UnitZ(), 2.0}, kNoiseAt2m},
                    Seen{"a floor from 1 m above it", test::floorSeenFrom(1.0, 1.0), kNoiseAt1m},
                    Seen{"a floor from 1 m, 2 m ahead", test::floorSeenFrom(1.0, 0.75), 0.003},
                    Seen{"a floor from 2 m above it", test::floorSeenFrom(2.0, 1.2), kNoiseAt2m}));

TEST(PlaneExtraction, AFloorBehindAChairsLegIsOnePlane)
{
  test::PlaneScene scene(160, 120, 142.5, kNoiseAt1m);
  scene.add(kFloor);
  // A pole 10 cm wide from the image's top to its bottom, 0.5 m ahead.
  scene.add({-Eigen::Vector3d::UnitZ(), 0.5},
            [](const Eigen::Vector3d& p) { return std::abs(p.x()) < 0.05; });
  const PlaneExtraction extraction = extract(scene);
  std::uint32_t largest = 0;
  int floors = 0;
  for (const ExtractedPlane& plane : extraction.planes()) {
    if (geometry::angleBetween(plane.fit.plane.normal, kFloor.normal) > 5 * kDegree) continue;
    ++floors;
    largest = std::max(largest, plane.size);
  }
  EXPECT_EQ(floors, 1) << "on both sides of the pole";
  EXPECT_GT(largest, 500U);
}

/// A floor that rises by an angle from 1.2 m ahead.
PlaneExtraction floorThatRises(double angle)
{
  const Eigen::Vector3d up = std::cos(angle) * kFloor.normal - std::sin(angle) * kAhead;
  const Eigen::Vector3d foot = 1.2 * kAhead - kFloor.distance * kFloor.normal;
  test::PlaneScene scene(160, 120, 142.5, kNoiseAt1m);
  scene.add(kFloor, [](const Eigen::Vector3d& p) { return kAhead.dot(p) < 1.2; });
  scene.add({up, -up.dot(foot)}, [](const Eigen::Vector3d& p) { return kAhead.dot(p) >= 1.2; });
  return extract(scene);
}

TEST(PlaneExtraction, AFloorThatBendsBy1AndAHalfDegreesIsOne)
{
  for (const double angle : {-1.5, 1.5}) {
    const PlaneExtraction extraction = floorThatRises(angle * kDegree);
    ASSERT_EQ(extraction.planes().size(), 1U) << angle << " degrees";
    EXPECT_GT(extraction.planes()[0].size, 800U) << angle << " degrees";
  }
}

TEST(PlaneExtraction, ARampOf8DegreesIsNotOneWithTheFloor)
{
  const PlaneExtraction extraction = floorThatRises(8 * kDegree);
  const auto planes = planesOf(extraction, 100);
  ASSERT_EQ(planes.size(), 2U);
  std::vector<double> angles;
  for (const ExtractedPlane& plane : planes)
    angles.push_back(geometry::angleBetween(plane.fit.plane.normal, kFloor.normal) / kDegree);
  std::sort(angles.begin(), angles.end());
  EXPECT_NEAR(angles[0], 0.0, 0.5) << "the floor";
  EXPECT_NEAR(angles[1], 8.0, 0.5) << "the ramp";
}

TEST(PlaneExtraction, FindsPlanesOfEveryDirectionWithoutAnUpVector)
{
  // In a corridor, 2 m wide and 2 m high, that ends 3 m ahead.
  const std::vector<geometry::Plane> truth = {{-Eigen::Vector3d::UnitY(), 1.0},
                                              {Eigen::Vector3d::UnitY(), 1.0},
                                              {Eigen::Vector3d::UnitX(), 1.0},
                                              {-Eigen::Vector3d::UnitX(), 1.0},
                                              {-Eigen::Vector3d::UnitZ(), 3.0}};
  // And the same for a camera that lies askew.
  for (const double roll : {0.0, 0.5, 1.6}) {
    const Eigen::AngleAxisd turn(roll, Eigen::Vector3d(0.2, 0.1, 1.0).normalized());
    test::PlaneScene scene(160, 120, 100.0, kNoiseAt1m);
    for (const geometry::Plane& plane : truth) scene.add({turn * plane.normal, plane.distance});
    const PlaneExtraction extraction = extract(scene);
    EXPECT_EQ(planesOf(extraction, 30).size(), truth.size()) << "roll " << roll;
    for (const geometry::Plane& plane : truth) {
      const Eigen::Vector3d normal = turn * plane.normal;
      const bool found = std::any_of(
          extraction.planes().begin(), extraction.planes().end(), [&](const ExtractedPlane& candidate) {
            return candidate.size > 30 &&
                   geometry::angleBetween(candidate.fit.plane.normal, normal) < 1.0 * kDegree &&
                   std::abs(candidate.fit.plane.distance - plane.distance) < 0.02;
          });
      EXPECT_TRUE(found) << "none with normal " << normal.transpose() << " at " << plane.distance << ", roll "
                         << roll;
    }
  }
}

TEST(PlaneExtraction, SamplesOfOneImageRowMakeNoPlane)
{
  test::PlaneScene scene;
  scene.add(kFloor);
  for (std::size_t k = 0; k < scene.depth().size(); ++k) {
    if (k / 160 < 114) scene.depth()[k] = std::numeric_limits<float>::quiet_NaN();
  }
  // Two rows of samples have normals; a single one has none.
  EXPECT_EQ(extract(scene).planes().size(), 1U);
  for (std::size_t k = 0; k < scene.depth().size(); ++k) {
    if (k / 160 < 118) scene.depth()[k] = std::numeric_limits<float>::quiet_NaN();
  }
  EXPECT_TRUE(extract(scene).planes().empty());
  EXPECT_TRUE(extract(scene, kFloor).planes().empty()) << "even where the plane is known";
}

/// Patches of 2 x 2 samples of the floor, far apart, each too small for a plane.
test::PlaneScene patches(int count, const geometry::Plane& plane)
{
  test::PlaneScene whole;
  whole.add(plane);
  test::PlaneScene scene;
  for (int patch = 0; patch < count; ++patch) {
    const int i = 4 + 8 * (patch % 4);
    const int j = 12 + 6 * (patch / 4);
    for (int v = 119 * j / 31 - 1; v <= 119 * (j + 1) / 31 + 1; ++v) {
      for (int u = 159 * i / 31 - 1; u <= 159 * (i + 1) / 31 + 1; ++u) {
        const auto pixel = static_cast<std::size_t>(160 * v + u);
        scene.depth()[pixel] = whole.depth()[pixel];
      }
    }
  }
  return scene;
}

TEST(PlaneExtraction, AKnownPlaneIsFoundWhereFewSamplesShowIt)
{
  const test::PlaneScene scene = patches(4, kFloor);
  EXPECT_TRUE(extract(scene).planes().empty()) << "nobody could tell without";
  const PlaneExtraction extraction = extract(scene, kFloor);
  ASSERT_EQ(extraction.planes().size(), 1U);
  EXPECT_EQ(extraction.planes()[0].size, 16U);
  EXPECT_NEAR(extraction.planes()[0].fit.plane.distance, kFloor.distance, 0.002);
  EXPECT_LT(geometry::angleBetween(extraction.planes()[0].fit.plane.normal, kFloor.normal) / kDegree, 0.2);
}

TEST(PlaneExtraction, AKnownPlaneOfFewerThanTheLeastSamplesIsNone)
{
  EXPECT_TRUE(extract(patches(1, kFloor), kFloor).planes().empty()) << "4 samples";
}

TEST(PlaneExtraction, AKnownPlaneThatIsNotThereIsNotFound)
{
  EXPECT_TRUE(extract(patches(4, kFloor), test::raised(kFloor, 0.2)).planes().empty());
  EXPECT_TRUE(extract(test::PlaneScene(), kFloor).planes().empty());
}

/// In how many of 20 frames a bare floor that was known is found more than once.
/// @param factor  of the noise, times what the parameters say
int framesWithTwo(double factor)
{
  test::PlaneScene scene;
  scene.add(kFloor);
  const std::vector<float> exact = scene.depth();
  std::mt19937 random(1);
  std::normal_distribution<float> gauss;
  int frames = 0;
  for (int frame = 0; frame < 20; ++frame) {
    for (std::size_t k = 0; k < exact.size(); ++k)
      scene.depth()[k] = exact[k] + static_cast<float>(factor) * SensorNoise().at(exact[k]) * gauss(random);
    EXPECT_EQ(extract(scene).planes().size(), 1U) << "frame " << frame << ", where nothing was known";
    frames += extract(scene, kFloor).planes().size() > 1 ? 1 : 0;
  }
  return frames;
}

TEST(PlaneExtraction, AKnownPlaneThatIsFoundAnywayIsNotFoundTwice)
{
  EXPECT_EQ(framesWithTwo(1.0), 0) << "of 20 frames";
}

TEST(PlaneExtraction, AKnownPlaneIsNotFoundTwiceByACameraTwiceAsNoisyAsItsParametersSay)
{
  EXPECT_EQ(framesWithTwo(2.0), 0) << "of 20 frames";
}

TEST(PlaneExtraction, NothingOfTheLastFrameIsLeft)
{
  SampleGrid grid{SampleGrid::Parameters{}};
  PlaneExtraction extraction;
  test::PlaneScene floor;
  floor.add(kFloor);
  grid.update(floor.view());
  extraction.extract(grid, {}, {});
  ASSERT_EQ(extraction.planes().size(), 1U);
  const test::PlaneScene nothing(8, 8);
  grid.update(nothing.view());
  extraction.extract(grid, {}, {});
  EXPECT_TRUE(extraction.planes().empty());
  EXPECT_TRUE(extraction.members().empty());
  EXPECT_EQ(extraction.planeOf(), std::vector<int>(64, PlaneSegments::kNone));
}

/// What holds of all planes of all frames.
void expectSound(const PlaneExtraction& extraction, const PlaneExtractionParameters& parameters)
{
  const std::vector<int>& of = extraction.planeOf();
  ASSERT_EQ(of.size(), extraction.samples().size());
  std::vector<int> listed(of.size(), PlaneSegments::kNone);
  for (std::size_t p = 0; p < extraction.planes().size(); ++p) {
    const ExtractedPlane& plane = extraction.planes()[p];
    const geometry::Plane& fitted = plane.fit.plane;
    EXPECT_GE(plane.size, parameters.least_samples) << "plane " << p;
    EXPECT_NEAR(fitted.normal.norm(), 1.0, 1e-9) << "plane " << p;
    EXPECT_GT(fitted.distance, 0.0) << "plane " << p << ": its normal is towards the camera";
    EXPECT_GE(fitted.distance, parameters.least_view_angle * plane.fit.centre.norm()) << "plane " << p;
    ASSERT_LE(plane.first + plane.size, extraction.members().size()) << "plane " << p;
    double squares = 0.0;
    PlaneFit again;
    for (std::uint32_t m = plane.first; m < plane.first + plane.size; ++m) {
      const std::uint32_t k = extraction.members()[m];
      ASSERT_EQ(listed[k], PlaneSegments::kNone) << "sample " << k << " is listed twice";
      listed[k] = static_cast<int>(p);
      const NoisySample& sample = extraction.samples()[k];
      ASSERT_TRUE(sample.has_point && sample.has_normal) << "sample " << k;
      const float along = fitted.normal.cast<float>().dot(sample.point);
      const double height = fitted.height(sample.point.cast<double>());
      squares += height * height / sample.variance(along);
      again.add(sample.point.x(), sample.point.y(), sample.point.z(), 1.0F / sample.variance(along));
    }
    // Each was within growing_sigmas of the plane that grew.
    EXPECT_LT(std::sqrt(squares / plane.size), parameters.growing_sigmas)
        << "plane " << p << " of " << plane.size << " samples: root mean square distance in sigmas";
    const auto fit = again.solve(fitted.normal);
    ASSERT_TRUE(fit) << "plane " << p;
    // The weights are those of the planes that grew, not of the last one, and may differ a little.
    EXPECT_LT(geometry::angleBetween(fit->plane.normal, fitted.normal),
              1.0 * kDegree + 2.0 * plane.fit.normal_sigma)
        << "plane " << p << " of " << plane.size << " samples is not the fit of its samples";
    EXPECT_NEAR(fit->plane.height(plane.fit.centre), 0.0, 0.01)
        << "plane " << p << " of " << plane.size << " samples is not the fit of its samples";
  }
  EXPECT_EQ(listed, of) << "members() and planeOf() disagree";
  EXPECT_EQ(static_cast<std::ptrdiff_t>(extraction.members().size()),
            std::count_if(of.begin(), of.end(), [](int plane) { return plane != PlaneSegments::kNone; }))
      << "members() lists samples of planes alone";
}

TEST(PlaneExtraction, HoldsItsPromisesInAThousandRandomScenes)
{
  SampleGrid grid{SampleGrid::Parameters{}};
  PlaneExtraction extraction;  // one for all, as in a camera's life
  const PlaneExtractionParameters parameters;
  int planes = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    std::mt19937 random(seed);
    const auto between = [&random](double least, double most) {
      return std::uniform_real_distribution<double>(least, most)(random);
    };
    const auto direction = [&] {
      return Eigen::Vector3d(between(-1, 1), between(-1, 1), between(-1, 1)).normalized();
    };
    test::PlaneScene scene(64, 48, 57.0, between(0.0, 0.01));
    const int count = std::uniform_int_distribution<int>(2, 4)(random);
    Eigen::Vector3d normal = direction();
    for (int p = 0; p < count; ++p) {
      // Some planes are nearly parallel to the one before. Each has a point in view, and ends at a line
      // through it.
      normal = between(0, 1) < 0.6 ? direction() : (normal + between(0.0, 0.2) * direction()).normalized();
      const Eigen::Vector3d in_view =
          between(0.4, 3.0) * Eigen::Vector3d(between(-0.4, 0.4), between(-0.3, 0.3), 1.0);
      const Eigen::Vector3d edge = direction();
      scene.add({normal, -normal.dot(in_view)},
                [=](const Eigen::Vector3d& x) { return edge.dot(x - in_view) < 0.2; });
    }
    std::optional<geometry::Plane> known;
    if (between(0, 1) < 0.5) known = geometry::Plane{direction(), between(0.1, 2.5)};
    grid.update(scene.view());
    extraction.extract(grid, parameters, known);
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    expectSound(extraction, parameters);
    planes += static_cast<int>(extraction.planes().size());
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(planes, 1500) << "the scenes show planes";
}

}  // namespace
}  // namespace polygonal_perception::perception
