// Polygons from an array of points, without ROS: a floor 1 m below the camera and a box on it, 2 m ahead.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <polygonal_perception/perception/pipeline.hpp>
#include <vector>

namespace {

struct Point
{
  float x, y, z;
};

constexpr std::uint32_t kWidth = 160;
constexpr std::uint32_t kHeight = 120;

// In an optical frame: x right, y down, z forward. What lies above the horizon sees a wall at 6 m.
std::vector<Point> renderBox()
{
  constexpr float kWall = 6.0F;
  constexpr float kBox = 2.0F;
  std::vector<Point> points;
  for (std::uint32_t v = 0; v < kHeight; ++v) {
    for (std::uint32_t u = 0; u < kWidth; ++u) {
      const float x = (static_cast<float>(u) - 79.5F) / 140.0F;
      const float y = (static_cast<float>(v) - 30.0F) / 140.0F;
      float depth = y > 0.0F ? std::min(1.0F / y, kWall) : kWall;
      const bool hits_box = std::abs(kBox * x) < 0.2F && kBox * y > 0.7F;
      if (hits_box) depth = std::min(depth, kBox);
      points.push_back({depth * x, depth * y, depth});
    }
  }
  return points;
}

}  // namespace

int main()
{
  using namespace polygonal_perception::geometry;
  using namespace polygonal_perception::perception;
  const std::vector<Point> points = renderBox();
  Frame frame;
  frame.points = PointView::points(points.data(), kWidth, kHeight);

  Pipeline pipeline{Pipeline::Parameters{}};
  const Pipeline::Result& result = pipeline.process(frame);
  if (result.floor.status != FloorStatus::kFound) {
    std::cout << "no floor\n";
    return 1;
  }
  std::cout << "camera height " << result.floor.floor.plane.distance << '\n';
  for (const PolygonSet::Ring& ring : result.polygons.rings) {
    std::cout << (ring.hole ? "hole" : "polygon");
    for (const Eigen::Vector2d& vertex : result.polygons.view(ring))
      std::cout << ' ' << vertex.x() << ' ' << vertex.y();
    std::cout << '\n';
  }
  return 0;
}
