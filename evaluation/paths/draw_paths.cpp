// Draws the upper half of the paper's figure 7: a simulated corridor with somebody in the way, and a recorded frame.
// draw_paths PICTURE.png [SET/NAME of the recorded frame]; recorded frames are in POLYGONAL_PERCEPTION_DATA.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "paths/plan_picture.hpp"
#include "polygonal_perception/cameras/simulation/depth_noise.hpp"
#include "polygonal_perception/cameras/simulation/person.hpp"
#include "polygonal_perception/cameras/simulation/ray_caster.hpp"
#include "polygonal_perception/cameras/simulation/simulated_camera.hpp"
#include "reference/recorded_frames.hpp"

namespace polygonal_perception::evaluation {
namespace {

constexpr double kGoal = 5.0;  // [m] ahead

cv::Mat3b planned(const cv::Mat1f& depth, const perception::PinholeRays& rays, const std::string& title)
{
  perception::Pipeline pipeline({});
  perception::Frame frame;
  frame.points = perception::PointView::depth(depth.ptr<float>(), depth.step, rays);
  const auto& result = pipeline.process(frame);
  if (result.floor.status != perception::FloorStatus::kFound)
    throw std::runtime_error(title + ": no floor was found");
  planning::PathPlanner planner;
  if (const auto refused = planner.setObstacles(result.polygons, {}, true))
    throw std::runtime_error(refused->text);
  planning::Plan plan;
  planner.makePlan({0.0, 0.0}, {kGoal, 0.0}, 1.0, plan);
  if (plan.outcome != planning::PlanOutcome::kOk) throw std::runtime_error(title + ": there is no path");
  char text[120];
  std::snprintf(text, sizeof text, "%s: a path of %.2f m to %.1f m ahead", title.c_str(), plan.length, kGoal);
  return drawPlan({depth, rays, result, planner, plan}, text);
}

cv::Mat3b corridorWithPerson()
{
  simulation::SimulatedCamera::Options options;
  options.scene = "corridor";
  options.seed = 3;
  const simulation::SimulatedCamera camera(options);
  const Eigen::Isometry3d pose = camera.pose(0);
  simulation::Scene scene = camera.scene();
  const Eigen::Vector2d ahead = pose.linear().col(2).head<2>().normalized();
  simulation::PersonPose person;
  person.position = pose.translation().head<2>() + 2.6 * ahead + 0.1 * Eigen::Vector2d(-ahead.y(), ahead.x());
  person.yaw = std::atan2(-ahead.y(), -ahead.x());
  simulation::addPerson(scene.solids, person);
  simulation::RayImage truth;
  simulation::RayCaster(scene).cast(options.camera, pose, 0.0, truth);
  cv::Mat1f depth(static_cast<int>(options.camera.height), static_cast<int>(options.camera.width));
  std::vector<float> noisy;
  simulation::DepthNoise(simulation::DepthNoise::Parameters{}, options.seed)
      .apply(options.camera, truth, 0, noisy);
  std::copy(noisy.begin(), noisy.end(), depth.begin());
  const auto& c = options.camera;
  return planned(depth, perception::PinholeRays::make(c.width, c.height, c.fx, c.fy, c.cx, c.cy),
                 "simulated corridor");
}

cv::Mat3b recorded(const std::string& wanted)
{
  const auto frames = reference::findRecordedFrames();
  if (!frames) throw std::runtime_error("set POLYGONAL_PERCEPTION_DATA to a folder with a frames.json");
  for (const reference::RecordedFrame& frame : reference::listRecordedFrames(*frames)) {
    if (frame.set + "/" + frame.name != wanted && frame.name != wanted) continue;
    const reference::LoadedFrame loaded = reference::load(frame);
    return planned(loaded.depth, loaded.rays, "recorded, " + frame.set);
  }
  throw std::runtime_error("there is no frame " + wanted);
}

}  // namespace
}  // namespace polygonal_perception::evaluation

int main(int argc, char** argv)
{
  using namespace polygonal_perception::evaluation;
  if (argc < 2) {
    std::fprintf(stderr, "usage: draw_paths PICTURE.png [SET/NAME]\n");
    return EXIT_FAILURE;
  }
  try {
    cv::Mat3b picture = corridorWithPerson();
    if (argc > 2) cv::vconcat(picture, recorded(argv[2]), picture);
    if (!cv::imwrite(argv[1], picture)) throw std::runtime_error(std::string(argv[1]) + " cannot be written");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "draw_paths: %s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
