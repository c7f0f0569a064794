#include "polygonal_perception/cameras/simulation/person.hpp"

#include <algorithm>
#include <cmath>

#include "cameras/simulation/assembly.hpp"
#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::simulation {
namespace {

constexpr double kTurn = 0.25;  // [m] before and after the end of the way over which a walker turns round

/// A point `length` below another, swung forwards by an angle.
Eigen::Vector3d swung(const Eigen::Vector3d& from, double length, double angle)
{
  return from + length * Eigen::Vector3d(std::sin(angle), 0.0, -std::cos(angle));
}

}  // namespace

void addPerson(std::vector<Solid>& solids, const PersonPose& pose)
{
  const Assembly body = Assembly(solids).at(pose.position.x(), pose.position.y(), pose.yaw);
  const double s = pose.stature;
  const double thigh = 0.245 * s;
  const double shin = 0.235 * s;
  const double ankle = 0.045 * s;

  struct Leg
  {
    double hip;
    double knee;
  };
  std::array<Leg, 2> legs{};
  double reach = 0.0;
  for (int side = 0; side < 2; ++side) {
    const double phase = pose.stride + geometry::kPi * side;
    legs[side].hip = pose.stride_amplitude * std::sin(phase);
    // The knee bends while the thigh swings forwards.
    legs[side].knee = 1.6 * pose.stride_amplitude * std::max(0.0, std::cos(phase)) + 0.03;
    reach =
        std::max(reach, thigh * std::cos(legs[side].hip) + shin * std::cos(legs[side].hip - legs[side].knee));
  }
  // The longer leg stands on the floor and carries the hip.
  const double hip_height = reach + ankle;

  const Assembly trousers = body.reflecting(0.35);
  const Assembly shirt = body.reflecting(0.55);
  const Assembly skin = body.reflecting(0.7);
  for (int side = 0; side < 2; ++side) {
    const double y = (side == 0 ? 1.0 : -1.0);
    const Eigen::Vector3d hip(0.0, y * 0.052 * s, hip_height);
    const Eigen::Vector3d knee = swung(hip, thigh, legs[side].hip);
    const Eigen::Vector3d foot = swung(knee, shin, legs[side].hip - legs[side].knee);
    trousers.frustum(hip, knee, 0.048 * s, 0.034 * s);
    trousers.frustum(knee, foot, 0.034 * s, 0.024 * s);
    body.reflecting(0.15).box(foot + Eigen::Vector3d(-0.035 * s, -0.025 * s, -ankle),
                              foot + Eigen::Vector3d(0.11 * s, 0.025 * s, 0.02 * s));

    const double swing = -0.8 * legs[side].hip;
    const Eigen::Vector3d shoulder(0.0, y * 0.115 * s, hip_height + 0.29 * s);
    const Eigen::Vector3d elbow = swung(shoulder, 0.17 * s, swing);
    const Eigen::Vector3d hand = swung(elbow, 0.2 * s, swing + 0.25);
    shirt.frustum(shoulder, elbow, 0.03 * s, 0.025 * s);
    skin.frustum(elbow, hand, 0.025 * s, 0.02 * s);
  }
  shirt.ellipsoid({0, 0, hip_height + 0.17 * s}, {0.07 * s, 0.11 * s, 0.2 * s});
  trousers.ellipsoid({0, 0, hip_height + 0.01 * s}, {0.065 * s, 0.095 * s, 0.07 * s});
  skin.cylinder({0, 0, hip_height + 0.33 * s}, {0, 0, hip_height + 0.4 * s}, 0.03 * s);
  skin.ellipsoid({0.01 * s, 0, hip_height + 0.445 * s}, {0.055 * s, 0.043 * s, 0.065 * s});
}

PersonPose Walker::at(double time) const
{
  PersonPose pose;
  pose.stature = stature;
  const Eigen::Vector2d way = to - from;
  const double length = std::max(way.norm(), 1e-6);
  const double gone = std::fmod(start + speed * time, 2.0 * length);
  const bool back = gone > length;
  pose.position = from + way * ((back ? 2.0 * length - gone : gone) / length);
  // -1 before, 1 after passing a mark of the way, and in between while turning.
  const auto passed = [gone](double mark) { return std::max(-1.0, std::min(1.0, (gone - mark) / kTurn)); };
  pose.yaw = std::atan2(way.y(), way.x()) +
             0.5 * geometry::kPi * (1.0 + passed(0.0) + passed(length) + passed(2.0 * length));
  // A stride of two steps is about 0.8 of the stature long.
  pose.stride = 2.0 * geometry::kPi * (start + speed * time) / (0.8 * stature);
  pose.stride_amplitude = 0.42;
  return pose;
}

}  // namespace polygonal_perception::simulation
