#include "polygonal_perception/ros/common/frame_statistics.hpp"

#include <algorithm>

namespace polygonal_perception::ros_common {

namespace {

double seconds(FrameStatistics::Clock::duration duration)
{
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

void DurationStatistics::add(Duration duration)
{
  // A stage that nobody asked for took nothing.
  if (duration <= Duration::zero()) return;
  sum_ += duration;
  max_ = std::max(max_, duration);
  ++count_;
}

double DurationStatistics::meanMs() const
{
  return count_ == 0 ? 0.0
                     : std::chrono::duration<double, std::milli>(sum_).count() / static_cast<double>(count_);
}

double DurationStatistics::maxMs() const
{
  return std::chrono::duration<double, std::milli>(max_).count();
}

void FrameStatistics::received(std::uint32_t sequence, Clock::time_point now)
{
  ++recent_received_;
  last_frame_ = now;
  // Publishers in the same process need not count, and say the same number again; a lower one is that of
  // another publisher or of a restarted one.
  if (sequence == last_sequence_) sequence_counts_ = false;
  if (sequence_counts_ && last_sequence_ && sequence > *last_sequence_)
    dropped_ += sequence - *last_sequence_ - 1;
  last_sequence_ = sequence;
}

void FrameStatistics::rejected(const std::string& reason)
{
  ++rejected_;
  ++recent_rejected_;
  last_rejection_ = reason;
}

void FrameStatistics::interrupt()
{
  last_sequence_.reset();
  sequence_counts_ = true;
  last_frame_ = Clock::now();
}

double FrameStatistics::rate(Clock::time_point now) const
{
  const double window = seconds(now - report_start_);
  return window > 0.0 ? static_cast<double>(recent_received_) / window : 0.0;
}

double FrameStatistics::silence(Clock::time_point now) const
{
  return seconds(now - last_frame_);
}

void FrameStatistics::startReport(Clock::time_point now)
{
  recent_received_ = 0;
  recent_rejected_ = 0;
  for (auto& [name, stage] : stages_) stage = {};
  report_start_ = now;
}

}  // namespace polygonal_perception::ros_common
