#pragma once

#include <cassert>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "polygonal_perception/export.hpp"

namespace polygonal_perception::ros_common {

/// Mean and maximum of a duration since the last reset.
class POLYGONAL_PERCEPTION_EXPORT DurationStatistics
{
public:
  using Duration = std::chrono::nanoseconds;

  void add(Duration duration);
  double meanMs() const;
  double maxMs() const;

private:
  Duration sum_{0};
  Duration max_{0};
  std::uint64_t count_ = 0;
};

/// What became of a node's input messages, its frames: counts since the start, rate and times since the last
/// report.
class POLYGONAL_PERCEPTION_EXPORT FrameStatistics
{
public:
  using Clock = std::chrono::steady_clock;
  using Stages = std::vector<std::pair<std::string, DurationStatistics>>;

  /// @tparam StageTimes  a struct of durations with describe(), as perception/stage_times.hpp
  template <class StageTimes>
  static FrameStatistics ofStages()
  {
    FrameStatistics statistics;
    const StageTimes none;
    StageTimes::describe(none, [&](const char* name, const auto&) {
      statistics.stages_.emplace_back(name, DurationStatistics{});
    });
    statistics.stages_.emplace_back("messages", DurationStatistics{});
    statistics.stages_.emplace_back("total", DurationStatistics{});
    return statistics;
  }

  /// A frame has come in.
  /// @param sequence  the header's sequence number, as far as the publisher counts: a gap tells of frames
  ///                  that were dropped
  void received(std::uint32_t sequence, Clock::time_point now);
  /// A frame was answered.
  /// @param messages  the time that its messages took, after the stages
  template <class StageTimes>
  void answered(const StageTimes& times, DurationStatistics::Duration messages)
  {
    ++answered_;
    DurationStatistics::Duration total = messages;
    auto stage = stages_.begin();
    StageTimes::describe(times, [&](const char* name, DurationStatistics::Duration time) {
      assert(stage->first == name);
      static_cast<void>(name);
      (stage++)->second.add(time);
      total += time;
    });
    (stage++)->second.add(messages);
    stage->second.add(total);
  }
  /// A frame was not answered, or without a result, because of its own fault or a missing transform.
  void rejected(const std::string& reason);
  /// Frames that nobody had the time for.
  void dropped(std::uint64_t count) { dropped_ += count; }
  /// The input stops for a while on purpose, or starts again: gaps say nothing.
  void interrupt();

  std::uint64_t answeredCount() const { return answered_; }
  std::uint64_t rejectedCount() const { return rejected_; }
  std::uint64_t droppedCount() const { return dropped_; }
  const std::string& lastRejection() const { return last_rejection_; }

  /// Frames since the last report: received, and rejected among them.
  std::uint64_t recentlyReceived() const { return recent_received_; }
  std::uint64_t recentlyRejected() const { return recent_rejected_; }
  /// [Hz] since the last report.
  double rate(Clock::time_point now) const;
  /// [s] since the last frame, or since the input was started.
  double silence(Clock::time_point now) const;
  /// The stages by name, then "messages" and "total".
  const Stages& stages() const { return stages_; }

  /// Begins the next report.
  void startReport(Clock::time_point now);

private:
  FrameStatistics() = default;

  std::uint64_t answered_ = 0;
  std::uint64_t rejected_ = 0;
  std::uint64_t dropped_ = 0;
  std::string last_rejection_;

  std::uint64_t recent_received_ = 0;
  std::uint64_t recent_rejected_ = 0;
  Stages stages_;
  Clock::time_point report_start_ = Clock::now();
  Clock::time_point last_frame_ = Clock::now();
  std::optional<std::uint32_t> last_sequence_;  // roscpp's first one is 0
  bool sequence_counts_ = true;                 // the publisher numbers its frames
};

}  // namespace polygonal_perception::ros_common
