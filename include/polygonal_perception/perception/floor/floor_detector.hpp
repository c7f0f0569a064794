#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/perception/floor/floor_absence.hpp"
#include "polygonal_perception/perception/floor/floor_refinement_parameters.hpp"
#include "polygonal_perception/perception/floor/floor_selection_parameters.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"
#include "polygonal_perception/perception/planes/plane_extraction_parameters.hpp"
#include "polygonal_perception/perception/planes/sample_grid.hpp"

namespace polygonal_perception::perception {

class PlaneExtraction;

/// What became of a sample on the way to the floor (figure 3 of the paper).
enum class SampleLabel : std::uint8_t
{
  kNoPoint,  ///< no return near its pixel
  kPruned,   ///< on no plane, or on one that is not upright
  kSegment,  ///< on a level plane that is not the floor
  kFloor     ///< in the floor set
};

/// Heights above the floor [m] of other level planes that were seen with it: table tops, and below it a lower
/// storey.
class PlaneOffsets
{
public:
  void clear() { count_ = 0; }
  void add(double offset)
  {
    if (count_ < values_.size()) values_[count_++] = offset;
  }
  const double* begin() const { return values_.data(); }
  const double* end() const { return values_.data() + count_; }

private:
  std::array<double, 8> values_{};
  std::size_t count_ = 0;
};

/// A floor that was found in a frame.
struct DetectedFloor
{
  geometry::Plane plane;   ///< up normal, height of the input frame's origin above the floor
  double rms_error = 0.0;  ///< [m] of the fitted points
  /// Of the normal's three components [1] and the distance [m].
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  std::uint32_t sample_count = 0;  ///< samples in the floor set
  bool continued = false;          ///< it is at the height where the last floor was
  PlaneOffsets others;             ///< level planes that are not the floor
};

/// [m] Between which heights above the floor a camera can be.
struct HeightBounds
{
  double lowest = 0.0;
  double highest = 0.0;

  bool contain(double height) const { return height >= lowest && height <= highest; }
};

/// What is known about the floor before a frame is looked at.
struct FloorPrior
{
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< the up vector u_c, unit, in the input's frame
  bool up_is_measured = false;  ///< `up` is a floor's normal or comes from tf, not a mere seed
  /// [m] what the camera's height has last been, and how far it may be off by now; no value: never seen.
  std::optional<double> height;
  double height_tolerance = 0.0;
  std::optional<geometry::Plane> last;  ///< the floor of that height, as far as its normal is known
  bool confirmed =
      false;  ///< seen often enough that a lower plane is a drop, rather than the floor under a table
  PlaneOffsets others;  ///< level planes that were seen with it of late: none of them is the floor
  std::optional<double> tilt_sigma;  ///< [rad] how far a floor may be off `up`; no value: as usual
  std::optional<double> max_tilt;    ///< [rad] the same as a bound
  /// Between which heights of the camera the floor is sought; no value: by the selection's parameters.
  std::optional<HeightBounds> bounds;
  /// What tf calls up, unit, in the input's frame: a bound, whatever `up` is.
  std::optional<Eigen::Vector3d> level;

  double maxTiltWith(const FloorSelectionParameters& parameters) const
  {
    return max_tilt.value_or(parameters.maxTilt(up_is_measured));
  }
  HeightBounds boundsWith(const FloorSelectionParameters& parameters) const
  {
    return bounds.value_or(HeightBounds{parameters.min_camera_height, parameters.max_camera_height});
  }
};

/// Finds the floor plane in the samples of a frame (section III).
class POLYGONAL_PERCEPTION_EXPORT FloorDetector
{
public:
  struct Parameters
  {
    PlaneExtractionParameters planes;
    FloorSelectionParameters selection;
    FloorRefinementParameters refinement;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      PlaneExtractionParameters::describe(self.planes, visit);
      FloorSelectionParameters::describe(self.selection, visit);
      FloorRefinementParameters::describe(self.refinement, visit);
    }
  };

  explicit FloorDetector(const Parameters& parameters);
  FloorDetector(FloorDetector&& other) noexcept;
  FloorDetector& operator=(FloorDetector&& other) noexcept;
  ~FloorDetector();

  const Parameters& parameters() const { return parameters_; }

  /// Looks for the floor.
  /// @return the floor, or nothing where no plane of the frame qualifies
  std::optional<DetectedFloor> detect(const PointView& points, const SampleGrid& grid,
                                      const FloorPrior& prior);

  /// Why there is none, where the last frame had no floor.
  /// @param prior  what detect() was told
  FloorAbsence absence(const FloorPrior& prior) const;

  /// What became of each sample of the last frame, in the grid's order.
  const std::vector<SampleLabel>& labels() const { return labels_; }

  /// All planes of the last frame (section III-B, last lines).
  const PlaneExtraction& extraction() const;

private:
  struct Workspace;

  Parameters parameters_;
  std::vector<SampleLabel> labels_;
  std::unique_ptr<Workspace>
      workspace_;  // what a frame needs while it is looked at, kept to allocate only once
};

}  // namespace polygonal_perception::perception
