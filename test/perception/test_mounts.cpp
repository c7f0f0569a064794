#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "polygonal_perception/perception/pipeline.hpp"
#include "support/box_scene.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

/// A camera mounted somehow above a floor with a box, whose up vector is known.
struct Mount
{
  double pitch = 0.0;  // [rad] down
  double roll = 0.0;   // [rad] about the viewing axis
  double height = 1.2;

  std::string text() const
  {
    std::ostringstream text;
    text << "pitch " << pitch << ", roll " << roll << ", height " << height << ": ";
    return text.str();
  }
  /// In the floor frame, within the view, which reaches 22 degrees from its axis at least.
  Eigen::AlignedBox3d box() const
  {
    const double ahead = std::min(3.5, height / std::tan(std::max(0.2, pitch - 0.1)));
    return {Eigen::Vector3d(ahead, 0.05, 0.0), Eigen::Vector3d(ahead + 0.2, 0.25, 0.2)};
  }
};

struct Seen
{
  FloorStatus status = FloorStatus::kNotFound;
  double tilt = 0.0;          // [rad] of the floor against the truth
  double height_error = 0.0;  // [m]
  std::size_t cells = 0;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();  // [m] of the occupied cells
};

/// @param frame  from the optical frame into the cloud's; nothing: as a depth image
Seen look(const Mount& mount, const Eigen::Matrix3d* frame)
{
  test::BoxScene scene;
  scene.floor = test::floorSeenFrom(mount.height, mount.pitch, mount.roll);
  scene.boxes = {mount.box()};
  scene.width = 160;
  scene.height = 120;
  const std::vector<float> depth = scene.depth();
  const PinholeRays rays = scene.rays();
  PointView view = PointView::depth(depth.data(), scene.width * sizeof(float), rays);
  const Eigen::Matrix3d into = frame != nullptr ? *frame : Eigen::Matrix3d::Identity();
  struct Point
  {
    float x, y, z;
  };
  std::vector<Point> points;
  if (frame != nullptr) {
    for (std::uint32_t v = 0; v < scene.height; ++v) {
      for (std::uint32_t u = 0; u < scene.width; ++u) {
        const Eigen::Vector3f p = frame->cast<float>() * view.point(u, v);
        points.push_back({p.x(), p.y(), p.z()});
      }
    }
    view = PointView::points(points.data(), scene.width, scene.height);
  }

  Pipeline::Parameters parameters;
  parameters.tracker.initial_up = into * scene.floor.normal;
  Pipeline pipeline(parameters);
  const Pipeline::Result& result = pipeline.process({view, 1.0, {}});
  Seen seen;
  seen.status = result.floor.status;
  seen.tilt = std::acos(std::min(1.0, result.floor.floor.plane.normal.dot(into * scene.floor.normal)));
  seen.height_error = result.floor.floor.plane.distance - mount.height;
  const occupancy::GridGeometry& grid = result.occupancy.geometry();
  for (int j = 0; j < grid.cells_y; ++j) {
    for (int i = 0; i < grid.cells_x; ++i) {
      if (!result.occupancy.occupied(i, j)) continue;
      ++seen.cells;
      seen.middle += Eigen::Vector2d(grid.origin_x + (i + 0.5) * grid.resolution,
                                     grid.origin_y + (j + 0.5) * grid.resolution);
    }
  }
  if (seen.cells > 0) seen.middle /= static_cast<double>(seen.cells);
  return seen;
}

void expectTheBoxInItsPlace(const Mount& mount, const Eigen::Matrix3d* frame, const char* what)
{
  const Seen seen = look(mount, frame);
  ASSERT_EQ(seen.status, FloorStatus::kFound) << mount.text() << what;
  EXPECT_LT(seen.tilt, 0.002) << mount.text() << what;
  EXPECT_NEAR(seen.height_error, 0.0, 0.002) << mount.text() << what;
  ASSERT_GT(seen.cells, 0U) << mount.text() << what << ", no cell is occupied";
  // All that is seen of it lies in it.
  const Eigen::Vector2d off = seen.middle - mount.box().center().head<2>();
  EXPECT_LT(off.cwiseAbs().maxCoeff(), 0.13)
      << mount.text() << what << ", cells about " << seen.middle.transpose() << ", the box at "
      << mount.box().center().transpose();
}

/// From an optical frame into a body frame: x ahead, y left, z up.
Eigen::Matrix3d bodyFrame()
{
  Eigen::Matrix3d turn;
  turn << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return turn;
}

TEST(Mounts, DepthImagesWhateverPitchAndRoll)
{
  for (double pitch = 0.0; pitch < 1.5; pitch += 0.15) {
    for (double roll = -3.1; roll < 3.2; roll += 0.31)
      expectTheBoxInItsPlace({pitch, roll}, nullptr, "depth");
  }
}

TEST(Mounts, CloudsInABodyFrame)
{
  const Eigen::Matrix3d body = bodyFrame();
  for (double pitch = 0.0; pitch < 1.5; pitch += 0.3) {
    for (double roll = -3.1; roll < 3.2; roll += 0.62)
      expectTheBoxInItsPlace({pitch, roll}, &body, "body frame");
  }
}

TEST(Mounts, CloudsInAnyFrame)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int k = 0; k < 300; ++k) {
    const Eigen::Matrix3d frame =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
            .normalized()
            .toRotationMatrix();
    const Mount mount{1.5 * unit(random), 6.28 * unit(random) - 3.14, 0.6 + 0.9 * unit(random)};
    expectTheBoxInItsPlace(mount, &frame, ("any frame, case " + std::to_string(k)).c_str());
  }
}

TEST(Mounts, ACameraThatLooksStraightDownHasTheTopOfItsImageAhead)
{
  const Eigen::Matrix3d optical = Eigen::Matrix3d::Identity();
  for (const double pitch : {1.53, 1.5707963, 1.6}) {
    expectTheBoxInItsPlace({pitch, 0.0}, nullptr, "depth");
    expectTheBoxInItsPlace({pitch, 0.0}, &optical, "cloud");
  }
}

}  // namespace
}  // namespace polygonal_perception::perception
