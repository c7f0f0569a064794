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
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/perception/floor/sample_grid.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::perception {

/// What became of a sample on the way to the floor (figure 3 of the paper).
enum class SampleLabel : std::uint8_t
{
  kNoPoint,  ///< no return near its pixel
  kPruned,   ///< no normal, or one that is not upright
  kSegment,  ///< in a segment that is not the floor
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
  geometry::Plane plane;           ///< up normal, height of the input frame's origin above the floor
  double rms_error = 0.0;          ///< [m] of the fitted points
  std::uint32_t sample_count = 0;  ///< samples in the floor set
  bool continued = false;          ///< it is at the height where the last floor was
  PlaneOffsets others;             ///< level planes that are not the floor
};

/// What is known about the floor before a frame is looked at.
struct FloorPrior
{
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< the up vector u_c, unit, in the input's frame
  bool up_is_measured = false;  ///< `up` is a floor's normal or comes from tf, not a mere seed
  /// [m] what the camera's height has last been, and how far it may be off by now; no value: never seen.
  std::optional<double> height;
  double height_tolerance = 0.0;
  bool confirmed =
      false;  ///< seen often enough that a lower plane is a drop, rather than the floor under a table
  PlaneOffsets others;  ///< level planes that were seen with it of late: none of them is the floor
};

/// Finds the floor plane in the samples of a frame (section III).
class POLYGONAL_PERCEPTION_EXPORT FloorDetector
{
public:
  struct Parameters
  {
    double max_tilt =
        0.78539816339744831;           ///< [rad] pi/4: a floor's normal is nearer than this to the up vector
    double cluster_distance = 0.01;    ///< [m] tau_l of algorithm 1
    double merge_distance = 0.1;       ///< [m] tau_h of algorithm 2
    double replacement_factor = 20.0;  ///< algorithm 2, line 13
    double min_camera_height = 0.05;   ///< [m]
    double max_camera_height = 3.0;    ///< [m]

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      visit("max_tilt", self.max_tilt, parameters::Range{0.01, 1.4}, "rad",
            "Largest angle between the up vector and the normal of a floor.");
      visit("cluster_distance", self.cluster_distance, parameters::Range{0.0, 1.0}, "m",
            "Plane distance below which neighbouring samples join a segment (tau_l).");
      visit("merge_distance", self.merge_distance, parameters::Range{0.0, 1.0}, "m",
            "Plane distance below which segments join the floor (tau_h).");
      visit("replacement_factor", self.replacement_factor, parameters::Range{1.0, 1000.0}, "",
            "How many times larger a higher segment must be to replace a lower one as the floor.");
      visit("min_camera_height", self.min_camera_height, parameters::Range{0.0, 10.0}, "m",
            "A plane less than this below the camera is no floor.");
      visit("max_camera_height", self.max_camera_height, parameters::Range{0.01, 20.0}, "m",
            "A plane more than this below the camera is no floor.");
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

  /// What became of each sample of the last frame, in the grid's order.
  const std::vector<SampleLabel>& labels() const { return labels_; }

private:
  struct Workspace;

  Parameters parameters_;
  std::vector<SampleLabel> labels_;
  std::unique_ptr<Workspace>
      workspace_;  // what a frame needs while it is looked at, kept to allocate only once
};

}  // namespace polygonal_perception::perception
