#pragma once

#include <optional>
#include <string>

#include "polygonal_perception/parameters/parameter_table.hpp"

namespace polygonal_perception::perception {

/// How much the depth of a point errs: sigma(z) = c + l z + q z^2.
///
/// Depth noise moves a point along its viewing ray, so its distance from a plane errs by the part of that along
/// the plane's normal alone: on a floor seen at a grazing angle a small one.
struct SensorNoise
{
  double constant = 0.001504;  ///< [m] c
  double linear = -0.00152;    ///< [] l
  double quadratic = 0.0019;   ///< [1/m] q

  /// The names of the presets, the default first.
  static constexpr const char* kPresets = "xtion, realsense_d435, time_of_flight, lidar";

  /// What is known of a kind of sensor; nothing where there is no preset of that name.
  static std::optional<SensorNoise> preset(const std::string& name)
  {
    // Nguyen, Izadi, Lovell: Modeling Kinect Sensor Noise for Improved 3D Reconstruction and Tracking, 2012:
    // 1.2 mm + 1.9 mm (z - 0.4)^2.
    if (name == "xtion") return SensorNoise{};
    // As a ROS 2 launch file derived from elevation_mapping has it: 0.611 mm + 3.587 mm (z - 0.3515)^2. Elevation_mapping's
    // own file of that name has 2.4 mm + 6.6 mm (z - 0.77)^2 of the older ZR300: set noise_* for that.
    if (name == "realsense_d435") return SensorNoise{0.001054, -0.002522, 0.003587};
    // Tölgyessy, Dekan, Chovanec, Hubinský: Evaluation of the Azure Kinect, 2021: at most 17 mm up to 3.5 m.
    if (name == "time_of_flight") return SensorNoise{0.001, 0.0, 0.0013};
    // A rule of thumb for spinning lidars, not measured here.
    if (name == "lidar") return SensorNoise{0.022, 0.0, 0.0};
    return std::nullopt;
  }

  /// Standard deviation of the depth at a range [m].
  float at(float range) const
  {
    constexpr float kLeast = 1e-5F;  // a sum that is no more than rounding would make a point infinitely sure
    const float sigma = static_cast<float>(constant) +
                        range * (static_cast<float>(linear) + range * static_cast<float>(quadratic));
    return sigma > kLeast ? sigma : kLeast;
  }

  /// Read at the start alone: a node writes what can be reconfigured back to the parameter server, and the next one would
  /// take it for set.
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    visit("noise_constant", self.constant, parameters::Range{0.0, 0.5}.atStart(), "m",
          "Standard deviation of the depth: the part that does not depend on it.");
    visit("noise_linear", self.linear, parameters::Range{-0.1, 0.5}.atStart(), "",
          "The same: the part that grows with the depth.");
    visit("noise_quadratic", self.quadratic, parameters::Range{0.0, 0.5}.atStart(), "1/m",
          "The same: the part that grows with the square of the depth, as of all cameras that triangulate.");
  }
};

}  // namespace polygonal_perception::perception
