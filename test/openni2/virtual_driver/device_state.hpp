#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace polygonal_perception::virtual_device {

/// What the streams of an opened device share.
class DeviceState
{
public:
  using Clock = std::chrono::steady_clock;

  /// @param plugged  once it is false, it stays so: plugged in again, it is another device
  explicit DeviceState(std::shared_ptr<const std::atomic<bool>> plugged) : plugged_(std::move(plugged)) {}

  bool isPlugged() const { return *plugged_; }

  /// When the device's clock was at 0: at the first call.
  Clock::time_point epoch()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!epoch_) epoch_ = Clock::now();
    return *epoch_;
  }

  std::atomic<bool> registers{false};  ///< depth to colour

private:
  const std::shared_ptr<const std::atomic<bool>> plugged_;
  std::mutex mutex_;
  std::optional<Clock::time_point> epoch_;
};

}  // namespace polygonal_perception::virtual_device
