#pragma once

#include <cstdint>
#include <optional>

#include "polygonal_perception/export.hpp"

namespace polygonal_perception::openni2 {

/// Maps the stamps of a device's own clock onto the host's clock.
///
/// The device's stamps are evenly spaced, the arrivals are not: scheduling and the USB bus delay some frames.
/// The offset between the clocks is that of the least delayed frame so far, and creeps up as fast as two
/// quartz clocks may drift apart, so that it can follow either way. A jump of either clock begins anew.
class POLYGONAL_PERCEPTION_EXPORT DeviceClock
{
public:
  /// @param device   [us] on the device's clock
  /// @param arrival  [s] on the host's clock
  /// @return [s] on the host's clock, later than the one before unless a clock has jumped
  double toHost(std::uint64_t device, double arrival);

  void reset() { last_.reset(); }

private:
  struct State
  {
    std::uint64_t device;  // [us]
    double offset;         // [s] host - device
    double host;           // [s]
  };
  std::optional<State> last_;
};

}  // namespace polygonal_perception::openni2
