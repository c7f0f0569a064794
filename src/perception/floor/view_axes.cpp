#include "polygonal_perception/perception/floor/view_axes.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace polygonal_perception::perception {

namespace {

/// The frame's own axis where one is this near, so that rounding moves nothing.
Eigen::Vector3d snapped(const Eigen::Vector3d& direction)
{
  constexpr double kSame = 0.999994;  // cosine of 0.2 degrees
  Eigen::Index largest = 0;
  const double along = direction.cwiseAbs().maxCoeff(&largest);
  if (along < kSame) return direction;
  return std::copysign(1.0, direction[largest]) * Eigen::Vector3d::Unit(largest);
}

}  // namespace

ViewAxes viewAxesOf(const Pinhole& pinhole)
{
  // Rows and columns of the image run along the first two columns, and the viewing direction is across both.
  const Eigen::Vector3d down = pinhole.direction_of_pixel.col(1).normalized();
  Eigen::Vector3d forward = pinhole.direction_of_pixel.col(0).cross(down).normalized();
  if (forward.dot(pinhole.centre) < 0.0) forward = -forward;  // a mirrored image
  ViewAxes axes;
  axes.forward = snapped(forward);
  axes.upward = snapped((axes.forward.dot(down) * axes.forward - down).normalized());
  axes.upward = (axes.upward - axes.forward.dot(axes.upward) * axes.forward).normalized();
  axes.source = ViewAxes::Source::kPixels;
  return axes;
}

ViewAxes conventionalViewAxes(PointLayout layout, const Eigen::Vector3d& initial_up)
{
  constexpr double kBody =
      0.7;  // cosine of 45 degrees: z of a body frame is up, that of an optical one is not
  if (layout != PointLayout::kCloud || initial_up.normalized().z() < kBody) return {};
  return {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(), ViewAxes::Source::kBodyFrame};
}

ViewAxes viewAxesAlong(const Eigen::Vector3d& forward, const Eigen::Vector3d& initial_up)
{
  const Eigen::Vector3d ahead = forward.normalized();
  const Eigen::Vector3d up = initial_up.normalized();
  const Eigen::Vector3d upward = up - up.dot(ahead) * ahead;
  constexpr double kAcross = 0.01;  // a direction that is up itself has any other for its upper border
  return {ahead, upward.norm() > kAcross ? upward.normalized() : ahead.unitOrthogonal(),
          ViewAxes::Source::kParameter};
}

}  // namespace polygonal_perception::perception
