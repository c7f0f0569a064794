#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace polygonal_perception::perception {

/// Why no floor was found in a frame.
struct FloorAbsence
{
  enum class Reason : std::uint8_t
  {
    kNoPlane,       ///< the samples lie on no plane, or are too few
    kNoneFacesUp,   ///< no plane faces up, as far as up is known
    kNotLevelInTf,  ///< the plane that faces up is far from level as far as tf knows
    kTooNear,       ///< the camera is lower above the plane than it can be above a floor
    kTooFar,        ///< it is higher
    kUnlikely       ///< too much lies below the plane, or too few pixels bear it out
  };

  Reason reason = Reason::kNoPlane;
  double point_share = 0.0;  ///< of the samples have a return
  /// [1] In the input's frame, towards the sensor: of the largest plane that faces up, or where none does of the
  /// largest of all.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double tilt = 0.0;  ///< [rad] its angle with the up vector, or where tf contradicts with tf's
  bool up_is_from_tf = false;
  double height = 0.0;  ///< [m] of the sensor above it, and between which heights the floor was sought
  double lowest = 0.0;
  double highest = 0.0;
  bool bounds_are_mounts = false;  ///< rather than the parameters'
};

}  // namespace polygonal_perception::perception
