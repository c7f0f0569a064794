#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/perception/floor/pinhole_fit.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::perception {

/// Where a camera looks, in the input's frame: two perpendicular unit vectors. They are the same in every frame.
struct ViewAxes
{
  /// How they are known.
  enum class Source : std::uint8_t
  {
    kConvention,  ///< a depth image's frame is an optical one (REP 103), and so, for want of more, is a cloud's
    kPixels,      ///< from the directions in which a cloud's pixels look
    kBodyFrame,  ///< the cloud's pixels tell nothing, and initial_up is that of a body frame
    kParameter   ///< `forward`
  };

  Eigen::Vector3d forward = Eigen::Vector3d::UnitZ();  ///< the viewing direction
  Eigen::Vector3d upward = -Eigen::Vector3d::UnitY();  ///< towards the upper border of the image
  Source source = Source::kConvention;
};

struct ViewAxesParameters
{
  /// In the input's frame, any length but 0. Nothing: from the input itself.
  std::optional<Eigen::Vector3d> forward;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    visit("forward", self.forward,
          "The direction in the input's frame that is ahead, x of the floor frame, as initial_up; empty: "
          "where the "
          "camera looks.");
  }
};

/// The axes of the pinhole from which a cloud's pixels come.
POLYGONAL_PERCEPTION_EXPORT ViewAxes viewAxesOf(const Pinhole& pinhole);

/// The axes by convention (REP 103): those of an optical frame, or, for a cloud, of a body frame where up is z.
/// @param initial_up  up in the input's frame, any length
POLYGONAL_PERCEPTION_EXPORT ViewAxes conventionalViewAxes(PointLayout layout,
                                                          const Eigen::Vector3d& initial_up);

/// The axes of a camera that looks along a direction.
/// @param forward, initial_up  in the input's frame, any length
POLYGONAL_PERCEPTION_EXPORT ViewAxes viewAxesAlong(const Eigen::Vector3d& forward,
                                                   const Eigen::Vector3d& initial_up);

}  // namespace polygonal_perception::perception
