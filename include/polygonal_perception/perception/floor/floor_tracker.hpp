#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/perception/floor/floor_detector.hpp"
#include "polygonal_perception/perception/floor/floor_mount.hpp"
#include "polygonal_perception/perception/floor/view_change.hpp"

namespace polygonal_perception::perception {

/// As the constants of FloorPlane.msg.
enum class FloorStatus : std::uint8_t
{
  kNotFound = 0,
  kFound = 1,
  kHeld = 2,
  kAssumed = 3
};

/// What tf knows of a frame, in its own frame; each as far as somebody has asked for it.
struct FloorHints
{
  std::optional<Eigen::Vector3d> up;     ///< any length; seeds the up vector, or is it without up_feedback
  std::optional<geometry::Plane> mount;  ///< where the camera's mount says that the floor is
  std::optional<Eigen::Vector3d> level;  ///< unit; up in the frame in which the answer is placed
};

/// The floor as it stands after a frame.
struct FloorState
{
  FloorStatus status = FloorStatus::kNotFound;
  /// Meaningful unless NOT_FOUND; when HELD it is that of an earlier frame, when ASSUMED what the mount says.
  DetectedFloor floor;
  double age = 0.0;  ///< [s] since the floor was FOUND
  /// Why the last frame shows none; nothing where it does, or was not looked at.
  std::optional<FloorAbsence> absence;
  /// How it lies beside what the mount says, where it is FOUND and there is a mount.
  std::optional<MountError> mount_error;
};

/// Carries the floor from frame to frame (section III-B): feeds the normal back as the next up vector, holds
/// a floor for a while when a frame does not show it, and forgets it after that.
class POLYGONAL_PERCEPTION_EXPORT FloorTracker
{
public:
  struct Parameters
  {
    Eigen::Vector3d initial_up{0.0, -1.0, 0.0};  ///< in the input's frame, any length but 0
    bool up_feedback = true;                     ///< the found normal is the next frame's up vector
    double floor_timeout = 0.5;                  ///< [s] how long a floor is held
    ViewChange::Parameters view_change;
    FloorMountParameters mount;

    /// [m], [m/s] How much the camera's height may differ from frame to frame, and so much more for each second in which
    /// the floor was not seen.
    double height_tolerance = 0.06;
    double vertical_speed = 0.1;
    /// [s] How long after it was last seen the floor's height still says something about the camera's.
    double height_memory = 3.0;
    /// [s] The same for a lower storey: the robot may stand at its edge and look down for a while.
    double drop_memory = 20.0;
    /// [m] Level planes beside the floor whose heights differ by less are one.
    double remembered_offset = 0.1;
    /// Frames in a row that must have shown the same floor before a lower plane counts as a drop beyond it.
    double confirmed_after = 5.0;
    /// [m] A plane nearer than this may as well be a table top that the camera looks over: it never counts as confirmed.
    /// A robot with a lower camera has max_camera_height to keep it off lower storeys.
    double least_confirmed_height = 0.38;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      visit("floor_timeout", self.floor_timeout, parameters::Range{0.0, 60.0}, "s",
            "How long a floor that is not seen any more is held before it is given up.");
      FloorMountParameters::describe(self.mount, visit);
    }

    /// The rest, which users leave alone: for the ablation.
    template <class Self, class Visitor>
    static void describeThresholds(Self& self, Visitor&& visit)
    {
      ViewChange::Parameters::describeThresholds(self.view_change, visit);
      visit("height_tolerance", self.height_tolerance);
      visit("vertical_speed", self.vertical_speed);
      visit("height_memory", self.height_memory);
      visit("drop_memory", self.drop_memory);
      visit("remembered_offset", self.remembered_offset);
      visit("confirmed_after", self.confirmed_after);
      visit("least_confirmed_height", self.least_confirmed_height);
    }
  };

  FloorTracker(const Parameters& parameters, const FloorDetector::Parameters& detector)
      : parameters_(parameters), detector_(detector)
  {
  }

  /// @param stamp       [s] of the frame; a stamp before the last one resets the tracker first, and with the
  ///                    same one no floor is held
  /// @param hints       what tf knows
  const FloorState& update(const PointView& points, const SampleGrid& grid, double stamp,
                           const FloorHints& hints);

  /// Takes on new parameters with the next frame and keeps the floor.
  void configure(const Parameters& parameters, const FloorDetector::Parameters& detector);

  /// Forgets everything; the next frame starts from the seed.
  void reset();

  /// Whether the update at `stamp` has no floor to start from, and so wants an up vector from tf if there is
  /// one.
  bool needsSeed(double stamp) const { return !parameters_.up_feedback || !standsAt(stamp); }

  const FloorState& state() const { return state_; }
  const FloorDetector& detector() const { return detector_; }

private:
  /// A level plane that was seen with the floor and is not it.
  struct OtherPlane
  {
    double offset = 0.0;                                      // [m] above the floor
    double stamp = -std::numeric_limits<double>::infinity();  // [s] when it was last seen
  };

  void forgetView();
  void remember(const DetectedFloor& floor, double stamp);
  /// Whether a floor was found and is not yet held too long.
  bool standsAt(double stamp) const
  {
    return found_stamp_ && !is_given_up_ && stamp - *found_stamp_ <= parameters_.floor_timeout;
  }
  /// Whether the camera is still where it was on its mount when the floor was found.
  bool isSameMount(const std::optional<geometry::Plane>& mount) const;
  FloorPrior prior(double stamp, const FloorHints& hints) const;
  void answerWithout(double stamp, const FloorHints& hints);

  Parameters parameters_;
  FloorDetector detector_;
  ViewChange view_change_;
  FloorState state_;
  bool view_is_new_ = false;  // nothing that was known helps with this view
  DetectedFloor found_;       // the last that was; meaningful with found_stamp_
  std::optional<double> found_stamp_;
  std::optional<geometry::Plane> found_mount_;  // what the mount said then
  bool is_given_up_ = false;                    // that floor, since then
  std::optional<double> last_stamp_;
  std::array<OtherPlane, 8> others_{};
  double streak_ = 0.0;  // frames that showed this floor, as far as it matters
};

}  // namespace polygonal_perception::perception
