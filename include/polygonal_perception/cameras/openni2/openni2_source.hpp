#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "polygonal_perception/export.hpp"

namespace polygonal_perception::openni2 {

/// What to open and how.
struct SourceOptions
{
  /// "#n": the nth device found, from 1; "bus@n": that of number n on that USB bus, or the nth there, 0 for
  /// any; a device's serial number; its URI, or a part that no other has; or the path of an .oni file.
  std::string device_id = "#1";
  int width = 640;            ///< [px] the mode; a recording keeps its own
  int height = 480;           ///< [px]
  int rate = 30;              ///< [Hz]
  bool registration = false;  ///< depth as the colour camera sees it, by the device itself
  bool mirror = false;        ///< left and right swapped
  bool loop = true;           ///< a recording begins again at its end
};

/// A depth image, valid while the callback runs.
struct DepthFrame
{
  const std::uint8_t* data = nullptr;  ///< rows of 16-bit unsigned millimetres, 0 = no return
  std::size_t step = 0;                ///< [bytes] from row to row
  std::uint32_t width = 0;             ///< [px]
  std::uint32_t height = 0;            ///< [px]
  std::uint64_t timestamp = 0;         ///< [us] on the device's clock
  std::string_view serial;             ///< the device's serial number; empty where it tells none
  double focal_length = 0.0;           ///< [px] from its camera's field of view; the pixels are square
  double offset_x = 0.0;               ///< [px] of the principal point against that of its camera
  double offset_y = 0.0;               ///< [px]
};

enum class Severity
{
  kInfo,
  kWarning
};

/// The depth stream of an OpenNI2 device or recording, on a thread of its own.
///
/// It looks for the device until it is there, follows it when it goes and comes back, and starts its stream
/// only while frames are wanted. No member blocks for longer than a call of OpenNI does, and none throws.
class POLYGONAL_PERCEPTION_EXPORT OpenNI2Source
{
public:
  /// Both are called on the source's thread.
  using FrameCallback = std::function<void(const DepthFrame&)>;
  /// One sentence each time something changes: what was found, or why there is nothing.
  using ReportCallback = std::function<void(Severity, const std::string&)>;

  OpenNI2Source(const SourceOptions& options, FrameCallback on_frame, ReportCallback on_report);
  /// Returns when the last callback has.
  ~OpenNI2Source();
  OpenNI2Source(const OpenNI2Source&) = delete;
  OpenNI2Source& operator=(const OpenNI2Source&) = delete;

  /// Whether frames are wanted; at first they are not.
  void setStreaming(bool wanted);

private:
  class Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace polygonal_perception::openni2
