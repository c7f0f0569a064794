#pragma once

#include <chrono>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <string>
#include <vector>

#include "polygonal_perception/cameras/openni2/openni2_source.hpp"

namespace polygonal_perception::openni2 {

using Depth = std::vector<std::uint16_t>;  // [mm] row by row

struct CollectedFrame
{
  std::uint64_t timestamp;  // [us]
  std::uint32_t width;
  std::uint32_t height;
  double focal_length;  // [px]
  double offset_x;      // [px]
  double offset_y;      // [px]
  std::string serial;
  Depth depth;
};

/// A source whose frames and reports are kept.
class CollectingSource
{
public:
  explicit CollectingSource(const SourceOptions& options)
      : source_(
            options, [this](const DepthFrame& frame) { add(frame); },
            [this](Severity /*severity*/, const std::string& text) { add(text); })
  {
  }

  void setStreaming(bool wanted) { source_.setStreaming(wanted); }

  /// Waits until there are that many frames since the last clear.
  bool waitForFrames(std::size_t count)
  {
    return waitFor([&] { return frames_.size() >= count; });
  }
  bool waitForReport(const std::string& part)
  {
    return waitFor([&] {
      for (const std::string& text : reports_) {
        if (text.find(part) != std::string::npos) return true;
      }
      return false;
    });
  }
  void clear()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    frames_.clear();
    reports_.clear();
  }
  std::vector<CollectedFrame> frames()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return frames_;
  }
  /// For a test that fails.
  std::string reports()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::string all = "reports:";
    for (const std::string& text : reports_) all += "\n  " + text;
    return all + "\nframes: " + std::to_string(frames_.size());
  }

private:
  template <class Condition>
  bool waitFor(Condition&& condition)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(30), condition);
  }
  void add(const DepthFrame& frame)
  {
    CollectedFrame copy{frame.timestamp,
                        frame.width,
                        frame.height,
                        frame.focal_length,
                        frame.offset_x,
                        frame.offset_y,
                        std::string(frame.serial),
                        {}};
    copy.depth.resize(std::size_t{frame.width} * frame.height);
    for (std::size_t row = 0; row < frame.height; ++row)
      std::memcpy(&copy.depth[row * frame.width], frame.data + row * frame.step,
                  2 * std::size_t{frame.width});
    const std::lock_guard<std::mutex> lock(mutex_);
    frames_.push_back(std::move(copy));
    changed_.notify_all();
  }
  void add(const std::string& text)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    reports_.push_back(text);
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<CollectedFrame> frames_;
  std::vector<std::string> reports_;
  OpenNI2Source source_;  // last: its thread calls the rest
};

}  // namespace polygonal_perception::openni2
