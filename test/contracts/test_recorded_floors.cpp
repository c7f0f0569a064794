#include <gtest/gtest.h>

#include <set>

#include "error_statistics.hpp"
#include "polygonal_perception/floor_tracker.hpp"
#include "recorded_frames.hpp"

namespace polygonal_perception {
namespace {

/// Frames whose reference is not to be trusted to 5 cm: the floor is a strip of 1.7 % of the image; it is
/// nearly grazed; it is bent, so that the reference, fitted to its far end too, has an rms of 24 and 37 mm,
/// where the plane found, with 17 and 11 mm, follows the near floor.
const std::set<std::string> kHard = {"kinect_scenes/depth/office1.png", "boxes_low_camera/depth/000005.png",
                                     "singles/depth/tum_fr3_long_office_open3d.png",
                                     "singles/depth/tum_fr3_long_office_val_1341848230.910894.png"};

class RecordedFloors : public ::testing::Test
{
protected:
  void SetUp() override
  {
    const auto path = findRecordedFrames();
    if (!path)
      GTEST_SKIP() << "no recorded frames: set POLYGONAL_PERCEPTION_DATA to a folder with a frames.json";
    frames_ = listRecordedFrames(*path);
  }

  const FloorState& see(const RecordedFrame& frame)
  {
    const LoadedFrame loaded = load(frame);
    grid_.update(loaded.view());
    stamp_ += 1.0 / 30.0;
    return tracker_.update(loaded.view(), grid_, stamp_, std::nullopt);
  }

  void check(const RecordedFrame& frame, const FloorState& state)
  {
    if (!frame.reference_known) return;
    if (!frame.floor) {
      EXPECT_NE(state.status, FloorStatus::kFound)
          << frame.name << " shows no floor, one was found at " << state.floor.plane.distance << " m";
    } else if (state.status == FloorStatus::kFound && kHard.count(frame.name) == 0) {
      EXPECT_FALSE(isWrong(state.floor.plane, *frame.floor))
          << frame.name << ": " << normalError(state.floor.plane, *frame.floor) << " deg and "
          << heightError(state.floor.plane, *frame.floor) << " mm off its reference";
    }
  }

  std::vector<RecordedFrame> frames_;
  SampleGrid grid_{SampleGrid::Parameters{}};
  FloorTracker tracker_{FloorTracker::Parameters{}, FloorDetector::Parameters{}};
  double stamp_ = 0.0;
};

TEST_F(RecordedFloors, AreFoundFromTheInitialUpVectorAlone)
{
  for (const RecordedFrame& frame : frames_) {
    tracker_.reset();
    const FloorState& state = see(frame);
    check(frame, state);
    if (!frame.floor || !frame.reference_known) continue;
    EXPECT_EQ(state.status, FloorStatus::kFound) << frame.name;
  }
}

TEST_F(RecordedFloors, AreNeverWrongWithFeedback)
{
  for (const RecordedFrame& frame : frames_) check(frame, see(frame));
}

TEST_F(RecordedFloors, OfATurningRobotAgreeWithTheirReferences)
{
  std::size_t seen = 0;
  for (const RecordedFrame& frame : frames_) {
    if (frame.set != "robot_turning") continue;
    const FloorState& state = see(frame);
    ASSERT_EQ(state.status, FloorStatus::kFound) << frame.name;
    EXPECT_LT(normalError(state.floor.plane, *frame.floor), 1.5) << frame.name;
    EXPECT_LT(heightError(state.floor.plane, *frame.floor), 20.0) << frame.name;
    ++seen;
  }
  EXPECT_EQ(seen, 40U);
}

}  // namespace
}  // namespace polygonal_perception
