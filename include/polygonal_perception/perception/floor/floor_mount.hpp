#pragma once

#include <Eigen/Core>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/perception/floor/floor_detector.hpp"

namespace polygonal_perception::perception {

/// How far a mount is believed: a camera's pose on a robot that stands on its floor (tf's base_footprint, say).
struct FloorMountParameters
{
  /// Standard deviations of what the mount says. A calibration by hand is good to half a degree, and a robot on springs or
  /// legs moves by one or two centimetres.
  double mount_tilt_sigma = 0.01;     ///< [rad]
  double mount_height_sigma = 0.015;  ///< [m]
  /// The floor is sought so many standard deviations of the height about where the mount says: a knock tilts a camera but
  /// leaves its height, and a level plane beyond is a table, a pallet or another storey.
  double search_sigmas = 5.0;
  /// [rad] And by how much a floor's normal is off the mount's, as a standard deviation: robots pitch when they brake, and
  /// a camera that was knocked still finds its floor.
  double tilt_about_mount = 0.06;
  /// A floor that lies this many standard deviations off, its own and the mount's together, disagrees.
  double disagreement_sigmas = 3.0;
  /// Whether ground may slope (GroundPlanes): then a plane that is not level as the mount has it is a ramp ahead rather than
  /// the floor of a camera that was knocked.
  bool has_slopes = false;
  /// Of the samples must have a return: before a wall nearly all have, while with a lens that is covered nobody knows
  /// what is ahead.
  double least_view = 0.1;
  /// [rad], [m] A floor is held only while the camera has moved on its mount by less than this.
  double held_turn = 0.01;
  double held_lift = 0.01;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    visit("mount_tilt_sigma", self.mount_tilt_sigma, parameters::Range{1e-4, 0.3}, "rad",
          "How uncertain the tilt of the camera above mount_frame is, as a standard deviation.");
    visit("mount_height_sigma", self.mount_height_sigma, parameters::Range{1e-4, 1.0}, "m",
          "How uncertain its height is. The floor is sought within five times as much.");
  }
};

/// How a floor that was found lies beside what the mount says.
struct MountError
{
  geometry::Plane mount;   ///< in the input's frame, as the mount says
  double tilt = 0.0;       ///< [rad] between the two normals
  double height = 0.0;     ///< [m] the camera is so much higher than the mount says
  bool is_beyond = false;  ///< the two disagree beyond what both may be off
};

/// @param mount  the floor in the input's frame, as the mount says
POLYGONAL_PERCEPTION_EXPORT MountError mountError(const DetectedFloor& floor, const geometry::Plane& mount,
                                                  const FloorMountParameters& parameters);

/// The floor where no frame shows one: where the mount says, with the mount's covariance.
POLYGONAL_PERCEPTION_EXPORT DetectedFloor assumedFloor(const geometry::Plane& mount,
                                                       const FloorMountParameters& parameters);

}  // namespace polygonal_perception::perception
