#include "reference/still_view.hpp"

#include "polygonal_perception/cameras/simulation/ray_caster.hpp"

namespace polygonal_perception::reference {

StillView::StillView(const std::string& scene, std::uint64_t seed)
    : rays_(perception::PinholeRays::make(camera_.width, camera_.height, camera_.fx, camera_.fy, camera_.cx,
                                          camera_.cy)),
      noise_(simulation::DepthNoise::Parameters{}, seed)
{
  simulation::SimulatedCamera::Options options;
  options.scene = scene;
  options.seed = seed;
  const simulation::SimulatedCamera camera(options);
  simulation::RayCaster(camera.scene()).cast(camera_, camera.pose(0), 0.0, truth_);
}

perception::Frame StillView::frame(std::uint32_t index)
{
  noise_.apply(camera_, truth_, index, depth_);
  return frameOf(depth_, index / 30.0);
}

perception::Frame StillView::ideal() const
{
  return frameOf(truth_.depth, 0.0);
}

perception::Frame StillView::frameOf(const std::vector<float>& depth, double stamp) const
{
  perception::Frame frame;
  frame.points = perception::PointView::depth(depth.data(), camera_.width * sizeof(float), rays_);
  frame.stamp = stamp;
  return frame;
}

}  // namespace polygonal_perception::reference
