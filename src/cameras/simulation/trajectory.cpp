#include "polygonal_perception/cameras/simulation/trajectory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "cameras/simulation/free_space.hpp"
#include "cameras/simulation/route.hpp"
#include "polygonal_perception/cameras/simulation/random.hpp"
#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::simulation {
namespace {

constexpr double kMaxPitch = 45.0 * geometry::kDegree;
constexpr double kMaxRoll = 15.0 * geometry::kDegree;

/// Heights that a camera can have.
struct Heights
{
  double low;
  double high;
};

/// A view area that a camera of these heights fits in, with the heights that suit both.
std::pair<ViewArea, Heights> chooseArea(const Scene& scene, Random& random, const Heights& heights)
{
  std::vector<std::pair<ViewArea, Heights>> fitting;
  for (const ViewArea& area : scene.view_areas) {
    const Heights both{std::max(heights.low, area.min_camera_height),
                       std::min(heights.high, area.max_camera_height)};
    if (both.low <= both.high) fitting.emplace_back(area, both);
  }
  if (fitting.empty())
    throw std::runtime_error("no view area of scene '" + scene.name + "' suits the camera's height");
  return fitting[static_cast<std::size_t>(random.integer(0, static_cast<int>(fitting.size()) - 1))];
}

/// A few sinusoids: smooth, without a period that one could notice, always within -1..1.
class SmoothNoise
{
public:
  SmoothNoise(Random& random, double slowest, double fastest)
  {
    for (Wave& wave : waves_)
      wave = {geometry::kTwoPi * random.uniform(slowest, fastest), random.uniform(0.0, geometry::kTwoPi)};
  }
  double operator()(double time) const
  {
    double sum = 0.0;
    for (const Wave& wave : waves_) sum += std::sin(wave.angular_frequency * time + wave.phase);
    return std::max(-1.0, std::min(1.0, 0.5 * sum));
  }

private:
  struct Wave
  {
    double angular_frequency;
    double phase;
  };
  std::array<Wave, 3> waves_{};
};

/// Where a robot stands on three wheels, at 60, 180 and 300 degrees from ahead.
Eigen::Isometry3d standingOnWheels(const Scene& scene, const Waypoint& place)
{
  constexpr double kWheel = 0.165;  // [m] from the middle
  const Eigen::Rotation2Dd turn(place.yaw);
  std::array<Eigen::Vector3d, 3> contacts;
  for (int wheel = 0; wheel < 3; ++wheel) {
    const double angle = (60.0 + 120.0 * wheel) * geometry::kDegree;
    const Eigen::Vector2d at =
        place.position + turn * (kWheel * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    contacts[static_cast<std::size_t>(wheel)] << at, scene.groundHeight(at);
  }
  const Eigen::Vector3d up = (contacts[1] - contacts[0]).cross(contacts[2] - contacts[0]).normalized();
  const Eigen::Vector3d ahead(std::cos(place.yaw), std::sin(place.yaw), 0.0);
  const Eigen::Vector3d left = up.cross(ahead).normalized();
  Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
  base.linear() << left.cross(up), left, up;
  base.translation() << place.position, (contacts[0] + contacts[1] + contacts[2]).z() / 3.0;
  return base;
}

/// Robotino: three omnidirectional wheels whose rollers make the mast hum.
class DrivingTrajectory : public Trajectory
{
public:
  DrivingTrajectory(const Scene& scene, Random random)
      : scene_(&scene), hum_(random, 9.0, 17.0), rattle_(random, 11.0, 23.0), lean_(random, 0.1, 0.6)
  {
    const auto [area, heights] = chooseArea(scene, random, {0.6, 1.0});
    height_ = random.uniform(heights.low, heights.high);
    pitch_ = random.uniform(5.0, 35.0) * geometry::kDegree;
    roll_ = random.uniform(-1.0, 1.0) * geometry::kDegree;
    const FreeSpace space(scene, 0.27, 0.03, height_ + 0.1);
    const Route::Pace pace{random.uniform(0.25, 0.5), random.uniform(0.3, 0.8)};
    route_ = scene.way.empty() ? Route(space, area, random, pace) : Route(scene.way, pace);
  }

  Eigen::Isometry3d pose(double time) const override
  {
    const double height = height_ + 0.001 * hum_(time);
    const double pitch = pitch_ + (0.12 * rattle_(time) + 0.3 * lean_(time)) * geometry::kDegree;
    const double roll = roll_ + 0.12 * hum_(time + 7.0) * geometry::kDegree;
    return base(time) * opticalPose({0.0, 0.0, height}, 0.0, pitch, roll);
  }

  Eigen::Isometry3d base(double time) const override
  {
    const Waypoint place = route_.at(time);
    return standingOnWheels(*scene_, place);
  }

private:
  const Scene* scene_;
  SmoothNoise hum_;
  SmoothNoise rattle_;
  SmoothNoise lean_;
  double height_ = 0.0;
  double pitch_ = 0.0;
  double roll_ = 0.0;
  Route route_;
};

/// Nao: sways to the leg it stands on, nods with each step, and shakes when a heel hits the floor.
class WalkingTrajectory : public Trajectory
{
public:
  WalkingTrajectory(const Scene& scene, Random random) : gaze_(random, 0.05, 0.2), turn_(random, 0.05, 0.2)
  {
    const auto [area, heights] = chooseArea(scene, random, {0.45, 0.55});
    height_ = random.uniform(heights.low, heights.high);
    pitch_ = random.uniform(10.0, 30.0) * geometry::kDegree;
    step_rate_ = random.uniform(1.0, 2.0);
    sway_ = random.uniform(0.015, 0.035);
    const FreeSpace space(scene, 0.2, 0.03, 0.6);
    route_ = Route(space, area, random, {random.uniform(0.06, 0.12), random.uniform(0.2, 0.4)});
  }

  Eigen::Isometry3d pose(double time) const override
  {
    const Waypoint base = route_.at(time);
    const double steps = step_rate_ * time;
    const double sideways = std::sin(geometry::kPi * steps);
    // A blow at the start of each step, alternating in side, that rings off within a fifth of a second.
    const double since = (steps - std::floor(steps)) / step_rate_;
    const double ringing = std::exp(-since / 0.05) * std::sin(geometry::kTwoPi * 13.0 * since);
    const double side = std::fmod(std::floor(steps), 2.0) < 1.0 ? 1.0 : -1.0;
    const Eigen::Vector2d left(-std::sin(base.yaw), std::cos(base.yaw));
    const Eigen::Vector2d position = base.position + sway_ * sideways * left;
    const double height = height_ - 0.008 * std::abs(sideways) + 0.004 * ringing;
    const double pitch =
        pitch_ +
        (6.0 * gaze_(time) + 1.5 * std::sin(geometry::kTwoPi * steps) + 2.0 * ringing) * geometry::kDegree;
    const double roll = (2.5 * sideways + 1.5 * side * ringing) * geometry::kDegree;
    const double yaw = base.yaw + (10.0 * turn_(time) + 1.5 * sideways) * geometry::kDegree;
    return opticalPose({position.x(), position.y(), height}, yaw, pitch, roll);
  }

private:
  SmoothNoise gaze_;
  SmoothNoise turn_;
  double height_ = 0.0;
  double pitch_ = 0.0;
  double step_rate_ = 1.0;
  double sway_ = 0.0;
  Route route_;
};

/// Carried by hand: every angle and the height drift through their whole ranges.
class HandheldTrajectory : public Trajectory
{
public:
  HandheldTrajectory(const Scene& scene, Random random, const Heights& band)
      : lift_(random, 0.03, 0.15), nod_(random, 0.05, 0.3), tilt_(random, 0.05, 0.3)
  {
    const auto [area, heights] = chooseArea(scene, random, band);
    heights_ = heights;
    const FreeSpace space(scene, 0.2, heights.low - 0.1, heights.high + 0.1);
    route_ = Route(space, area, random, {random.uniform(0.15, 0.4), random.uniform(0.3, 0.7)});
  }

  Eigen::Isometry3d pose(double time) const override
  {
    const Waypoint base = route_.at(time);
    const double height = heights_.low + (heights_.high - heights_.low) * 0.5 * (1.0 + lift_(time));
    return opticalPose({base.position.x(), base.position.y(), height}, base.yaw,
                       kMaxPitch * 0.5 * (1.0 + nod_(time)), kMaxRoll * tilt_(time));
  }

private:
  SmoothNoise lift_;
  SmoothNoise nod_;
  SmoothNoise tilt_;
  Heights heights_{};
  Route route_;
};

/// No motion at all: each frame is somewhere else.
class IndependentTrajectory : public Trajectory
{
public:
  IndependentTrajectory(const Scene& scene, std::uint64_t seed, const Heights& band)
      : scene_(&scene), seed_(seed), band_(band), space_(scene, 0.2, band.low - 0.1, band.high + 0.1)
  {
  }

  Eigen::Isometry3d pose(double time) const override
  {
    Random random(seed_, static_cast<std::uint64_t>(std::llround(30.0 * time)));
    const auto [area, heights] = chooseArea(*scene_, random, band_);
    const Waypoint place = drawPose(spaceFor(heights), area, random);
    return opticalPose({place.position.x(), place.position.y(), random.uniform(heights.low, heights.high)},
                       place.yaw, random.uniform(0.0, kMaxPitch), random.uniform(-kMaxRoll, kMaxRoll));
  }

private:
  /// Over a table only the heights that the camera takes must be free, not the whole band.
  FreeSpace spaceFor(const Heights& heights) const
  {
    if (heights.low == band_.low && heights.high == band_.high) return space_;
    return FreeSpace(*scene_, 0.2, heights.low - 0.1, heights.high + 0.1);
  }

  const Scene* scene_;
  std::uint64_t seed_;
  Heights band_;
  FreeSpace space_;
};

}  // namespace

Eigen::Isometry3d Trajectory::base(double time) const
{
  const Eigen::Isometry3d camera = pose(time);
  const Eigen::Vector3d forward = camera.linear().col(2);
  return Eigen::Translation3d(camera.translation().x(), camera.translation().y(), 0.0) *
         Eigen::AngleAxisd(std::atan2(forward.y(), forward.x()), Eigen::Vector3d::UnitZ());
}

Eigen::Isometry3d opticalPose(const Eigen::Vector3d& position, double yaw, double pitch, double roll)
{
  // Columns: the optical frame's right, down and forward in a frame whose x is forward and whose z is up.
  Eigen::Matrix3d optical;
  optical << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                  Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                  Eigen::AngleAxisd(-roll, Eigen::Vector3d::UnitX()) * optical;
  pose.translation() = position;
  return pose;
}

const std::vector<std::string>& trajectoryNames()
{
  static const std::vector<std::string> names{
      "robotino",         "nao",           "smooth_low",        "smooth_high", "independent_low",
      "independent_high", "smooth_lowest", "independent_lowest"};
  return names;
}

std::unique_ptr<Trajectory> makeTrajectory(const std::string& name, const Scene& scene, std::uint64_t seed)
{
  constexpr Heights kLowest{0.2, 0.5};
  constexpr Heights kLow{0.4, 0.7};
  constexpr Heights kHigh{0.7, 1.5};
  const Random random(seed, 1000);
  if (name == "robotino") return std::make_unique<DrivingTrajectory>(scene, random);
  if (name == "nao") return std::make_unique<WalkingTrajectory>(scene, random);
  if (name == "smooth_lowest") return std::make_unique<HandheldTrajectory>(scene, random, kLowest);
  if (name == "independent_lowest") return std::make_unique<IndependentTrajectory>(scene, seed, kLowest);
  if (name == "smooth_low") return std::make_unique<HandheldTrajectory>(scene, random, kLow);
  if (name == "smooth_high") return std::make_unique<HandheldTrajectory>(scene, random, kHigh);
  if (name == "independent_low") return std::make_unique<IndependentTrajectory>(scene, seed, kLow);
  if (name == "independent_high") return std::make_unique<IndependentTrajectory>(scene, seed, kHigh);
  std::string known;
  for (const std::string& other : trajectoryNames()) known += ' ' + other;
  throw std::invalid_argument("no trajectory is named '" + name + "'; there are:" + known);
}

}  // namespace polygonal_perception::simulation
