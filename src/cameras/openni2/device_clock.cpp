#include "polygonal_perception/cameras/openni2/device_clock.hpp"

#include <algorithm>
#include <cmath>

namespace polygonal_perception::openni2 {
namespace {

constexpr double kDrift = 1e-4;  // two quartz clocks, each within 50 ppm
constexpr double kJump = 1.0;    // [s] no frame is under way for that long
constexpr double kStep = 1e-6;   // [s] the resolution of the device's stamps

}  // namespace

double DeviceClock::toHost(std::uint64_t device, double arrival)
{
  const double seconds = 1e-6 * static_cast<double>(device);
  const double measured = arrival - seconds;
  const bool goes_on = last_ && device > last_->device && std::abs(measured - last_->offset) < kJump &&
                       arrival > last_->host - kJump;
  if (!goes_on) {
    last_ = State{device, measured, arrival};
    return arrival;
  }
  const double elapsed = 1e-6 * static_cast<double>(device - last_->device);
  const double offset = std::min(last_->offset + kDrift * elapsed, measured);
  last_ = State{device, offset, std::max(seconds + offset, last_->host + kStep)};
  return last_->host;
}

}  // namespace polygonal_perception::openni2
