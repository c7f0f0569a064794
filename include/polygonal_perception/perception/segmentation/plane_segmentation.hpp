#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/perception/floor/floor_detector.hpp"
#include "polygonal_perception/perception/floor/floor_tracker.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"
#include "polygonal_perception/perception/planes/sample_grid.hpp"
#include "polygonal_perception/perception/segmentation/segmented_planes.hpp"

namespace polygonal_perception::perception {

/// Makes a list of all planes of a frame of what the floor detector has extracted (section III-B, last lines): each with
/// a fit through the cloud, an outline, and an id that it keeps.
class POLYGONAL_PERCEPTION_EXPORT PlaneSegmentation
{
public:
  struct Parameters
  {
    /// Pieces of less than this share of the samples are left out: ten of 32 x 32. So few samples may lie on one
    /// plane by chance.
    double least_share = 0.01;
    /// A sample that lies on two planes, where they cross, is of that whose normal is nearer to its own, if the cosines
    /// differ by this: as those of a floor and a board of 8 degrees do.
    double normal_margin = 0.006;
    /// Of the points next to a plane's samples at least this share lies on it: on what is thin and curved few do.
    double least_support = 0.86;
    /// [1/m], standard deviations: what bends more than this, beyond doubt, is no plane: legs and bottles, whose radius is
    /// less than a metre.
    double largest_curvature = 1.0;
    double curvature_sigmas = 3.0;
    /// Planes of at most this share of the samples are looked at for that, 64 of 32 x 32; in larger ones normals tell.
    double bending_share = 0.0625;
    /// [rad] A plane whose normal is not known to 4 degrees, one standard deviation, is none.
    double largest_normal_sigma = 0.07;
    /// [rad] A plane is level or upright to this angle, 3 degrees, and what the noise leaves uncertain of its normal:
    /// less than the slope of a wheelchair's ramp (1:12, 4.8 degrees).
    double kind_angle = 0.05;
    /// Standard deviations of the normal that are added to that.
    double kind_sigmas = 3.0;
    /// [rad] By how much the normal of one plane may turn from frame to frame: 20 degrees, for a camera that turns and the
    /// noise of small planes.
    double id_angle = 0.35;

    /// Users leave them alone: for the ablation.
    template <class Self, class Visitor>
    static void describeThresholds(Self& self, Visitor&& visit)
    {
      visit("least_share", self.least_share);
      visit("normal_margin", self.normal_margin);
      visit("least_support", self.least_support);
      visit("largest_curvature", self.largest_curvature);
      visit("curvature_sigmas", self.curvature_sigmas);
      visit("bending_share", self.bending_share);
      visit("largest_normal_sigma", self.largest_normal_sigma);
      visit("kind_angle", self.kind_angle);
      visit("kind_sigmas", self.kind_sigmas);
      visit("id_angle", self.id_angle);
    }
  };

  explicit PlaneSegmentation(const Parameters& parameters);
  PlaneSegmentation(PlaneSegmentation&& other) noexcept;
  PlaneSegmentation& operator=(PlaneSegmentation&& other) noexcept;
  ~PlaneSegmentation();

  /// Lists the planes of a frame.
  /// @param detector  has looked at this frame
  /// @param floor     what came of it
  /// @param up        unit, in the input's frame; nothing: nobody knows
  /// @param planes    filled anew
  void segment(const PointView& points, const SampleGrid& grid, const FloorDetector& detector,
               const FloorState& floor, const std::optional<Eigen::Vector3d>& up, SegmentedPlanes& planes);

  /// Takes on new parameters with the next frame and keeps the ids.
  void configure(const Parameters& parameters) { parameters_ = parameters; }

  /// Forgets the ids: no plane after this has one that was given before.
  void reset();

private:
  struct Workspace;

  Parameters parameters_;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace polygonal_perception::perception
