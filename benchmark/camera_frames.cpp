#include "camera_frames.hpp"

#include <cmath>

#include "polygonal_perception/cameras/simulation/ray_caster.hpp"
#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"

namespace polygonal_perception::benchmarks {

const char* nameOf(Input input)
{
  switch (input) {
    case Input::kCloud16:
      return "cloud16";
    case Input::kCloud32:
      return "cloud32";
    case Input::kDepthMillimetres:
      return "depth16UC1";
    case Input::kDepthMetres:
      return "depth32FC1";
  }
  return "";
}

CameraFrame::CameraFrame(const simulation::PinholeCamera& camera, const std::vector<float>& depth,
                         const geometry::Plane& floor)
    : width_(camera.width),
      height_(camera.height),
      floor_(floor),
      rays_(perception::PinholeRays::make(camera.width, camera.height, camera.fx, camera.fy, camera.cx,
                                          camera.cy)),
      millimetres_(depth.size()),
      metres_(depth),
      cloud16_(4 * depth.size()),
      cloud32_(8 * depth.size())
{
  simulation::toMillimetres(depth, millimetres_.data());
  const perception::PointView points = view(Input::kDepthMetres);
  for (std::uint32_t v = 0; v < height_; ++v) {
    for (std::uint32_t u = 0; u < width_; ++u) {
      const std::size_t k = std::size_t{v} * width_ + u;
      const Eigen::Vector3f p = points.point(u, v);
      std::copy_n(p.data(), 3, &cloud16_[4 * k]);
      std::copy_n(p.data(), 3, &cloud32_[8 * k]);
    }
  }
}

perception::PointView CameraFrame::view(Input input) const
{
  perception::PointView::CloudStrides strides;
  switch (input) {
    case Input::kCloud16:
      strides.point_step = 4 * sizeof(float);
      strides.row_step = strides.point_step * width_;
      return perception::PointView::cloud(cloud16_.data(), width_, height_, strides);
    case Input::kCloud32:
      strides.point_step = 8 * sizeof(float);
      strides.row_step = strides.point_step * width_;
      return perception::PointView::cloud(cloud32_.data(), width_, height_, strides);
    case Input::kDepthMillimetres:
      return perception::PointView::depth(millimetres_.data(), sizeof(std::uint16_t) * width_, rays_);
    case Input::kDepthMetres:
      return perception::PointView::depth(metres_.data(), sizeof(float) * width_, rays_);
  }
  return perception::PointView();
}

std::vector<std::unique_ptr<CameraFrame>> drive(Surroundings surroundings, std::uint32_t width,
                                                std::uint32_t height, std::uint32_t count)
{
  simulation::SimulatedCamera::Options options;
  options.scene = "office";
  options.trajectory = "robotino";
  options.camera = simulation::PinholeCamera::ofSize(width, height);
  simulation::SimulatedCamera camera(options);

  simulation::Scene nothing;
  nothing.solids.push_back(simulation::makeLevelRectangle({-30.0, -30.0}, {30.0, 30.0}, 0.0));
  nothing.solids.back().surface = simulation::Surface::kFloor;
  simulation::RayCaster nothing_caster(nothing);
  simulation::DepthNoise noise(options.noise, options.seed);

  std::vector<std::unique_ptr<CameraFrame>> frames;
  simulation::SimulatedFrame frame;
  for (std::uint32_t k = 0; k < count; ++k) {
    camera.render(static_cast<std::uint32_t>(std::lround(k * kFramePeriod * options.rate)), frame);
    if (surroundings == Surroundings::kEmpty) {
      nothing_caster.cast(options.camera, frame.camera_to_world, frame.time, frame.truth);
      noise.apply(options.camera, frame.truth, frame.index, frame.depth);
    }
    frames.push_back(std::make_unique<CameraFrame>(options.camera, frame.depth, frame.floor));
  }
  return frames;
}

}  // namespace polygonal_perception::benchmarks
