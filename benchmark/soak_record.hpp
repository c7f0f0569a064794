#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <fstream>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "polygonal_perception/PolygonArray.h"

/// What becomes of a node over a long time: its answers and its memory.
namespace polygonal_perception::benchmarks {

using Clock = std::chrono::steady_clock;

constexpr double kMemoryPeriod = 5.0;  // [s] between two looks at the memory
constexpr double kWarmUp = 0.2;        // share of the time that is left out of the slope

inline double seconds(Clock::duration duration)
{
  return std::chrono::duration<double>(duration).count();
}

/// [MB] that a process has taken for itself. Pages of its files come and go with the machine's needs.
inline double privateMemory(int process)
{
  std::ifstream file("/proc/" + std::to_string(process) + "/status");
  double kilobytes = 0.0;
  for (std::string key; file >> key;) {
    double value = 0.0;
    if ((key == "RssAnon:" || key == "VmSwap:") && file >> value) kilobytes += value;
  }
  return kilobytes * 1024e-6;
}

/// The memory of a process over time.
class MemoryRecord
{
public:
  explicit MemoryRecord(int process) : process_(process) {}

  void look(double time) { entries_.push_back({time, privateMemory(process_)}); }

  /// [MB/h] of the line through the entries from `begin` [s] on.
  double slope(double begin) const
  {
    double n = 0.0, t = 0.0, m = 0.0, tt = 0.0, tm = 0.0;
    for (const Entry& entry : entries_) {
      if (entry.time < begin) continue;
      n += 1.0;
      t += entry.time;
      m += entry.megabytes;
      tt += entry.time * entry.time;
      tm += entry.time * entry.megabytes;
    }
    const double spread = n * tt - t * t;
    return spread > 0.0 ? 3600.0 * (n * tm - t * m) / spread : 0.0;
  }

  /// [MB] once it has warmed up, and at the end.
  double at(double begin) const
  {
    const auto first = std::find_if(entries_.begin(), entries_.end(),
                                    [begin](const Entry& entry) { return entry.time >= begin; });
    return first == entries_.end() ? 0.0 : first->megabytes;
  }
  double last() const { return entries_.empty() ? 0.0 : entries_.back().megabytes; }

private:
  struct Entry
  {
    double time;
    double megabytes;
  };

  int process_;
  std::vector<Entry> entries_;
};

/// Counts what the node says, in the threads of a spinner.
class Reader
{
public:
  /// @param node  whose ~polygons are its answers
  explicit Reader(const std::string& node)
  {
    polygons_ = node_.subscribe(node + "/polygons", 1000, &Reader::onPolygons, this,
                                ros::TransportHints().tcpNoDelay());
    diagnostics_ = node_.subscribe("/diagnostics", 10, &Reader::onDiagnostics, this);
  }

  void sent(const ros::Time& stamp)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    sent_[stamp].time = Clock::now();
  }

  /// Waits for the answer to a stamp. @return false where none comes in time
  bool waitFor(const ros::Time& stamp)
  {
    constexpr std::chrono::seconds kDeadline(10);
    std::unique_lock<std::mutex> lock(mutex_);
    return answered_.wait_for(lock, kDeadline, [&] { return sent_[stamp].answers > 0; });
  }

  bool connected() const { return polygons_.getNumPublishers() > 0; }

  /// @return whether nothing was answered twice or unasked, and every frame is accounted for
  bool report()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<double> delays;
    std::size_t twice = 0;
    for (const auto& [stamp, frame] : sent_) {
      if (frame.answers > 0) delays.push_back(frame.delay);
      twice += frame.answers > 1 ? 1 : 0;
    }
    std::sort(delays.begin(), delays.end());
    std::printf("%zu frames sent, %zu answered, %zu twice, %zu answers to no frame\n", sent_.size(),
                delays.size(), twice, unasked_);
    std::printf(
        "of the %zu others the node counts %s as dropped, %s as rejected; %u answers were lost on their "
        "way\n",
        sent_.size() - delays.size(), values_["Frames dropped"].c_str(), values_["Frames rejected"].c_str(),
        lost_answers_);
    if (delays.empty()) return false;
    const auto quantile = [&](double share) {
      return 1e3 *
             delays[std::min(delays.size() - 1, static_cast<std::size_t>(share * double(delays.size())))];
    };
    std::printf("latency: median %.2f ms, 99 %% %.2f ms, 99.9 %% %.2f ms, longest %.2f ms\n", quantile(0.5),
                quantile(0.99), quantile(0.999), 1e3 * delays.back());
    return twice == 0 && unasked_ == 0;
  }

private:
  struct Sent
  {
    Clock::time_point time;
    double delay = 0.0;  // [s]
    int answers = 0;
  };

  void onPolygons(const PolygonArrayConstPtr& polygons)
  {
    const auto now = Clock::now();
    const std::lock_guard<std::mutex> lock(mutex_);
    if (last_answer_ != 0) lost_answers_ += polygons->header.seq - last_answer_ - 1;
    last_answer_ = polygons->header.seq;
    const auto frame = sent_.find(polygons->header.stamp);
    if (frame == sent_.end()) {
      ++unasked_;
      return;
    }
    ++frame->second.answers;
    answered_.notify_all();
    frame->second.delay = seconds(now - frame->second.time);
  }

  void onDiagnostics(const diagnostic_msgs::DiagnosticArrayConstPtr& report)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& status : report->status) {
      for (const auto& value : status.values) values_[value.key] = value.value;
    }
  }

  std::mutex mutex_;
  std::condition_variable answered_;
  std::map<ros::Time, Sent> sent_;
  std::map<std::string, std::string> values_;
  std::size_t unasked_ = 0;
  std::uint32_t last_answer_ = 0;  // the number that its publisher gave to it
  std::uint32_t lost_answers_ = 0;
  ros::NodeHandle node_;
  ros::Subscriber polygons_;
  ros::Subscriber diagnostics_;
};

inline void print(const MemoryRecord& memory, double duration)
{
  std::printf("memory: %.1f MB after %.0f s, %.1f MB at the end, slope %+.2f MB/h\n",
              memory.at(kWarmUp * duration), kWarmUp * duration, memory.last(),
              memory.slope(kWarmUp * duration));
}

}  // namespace polygonal_perception::benchmarks
