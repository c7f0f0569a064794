#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "polygonal_perception/cameras/openni2/device_clock.hpp"

namespace polygonal_perception::openni2 {
namespace {

constexpr double kPeriod = 1.0 / 30.0;  // [s]
constexpr double kStart = 1.7e9;        // [s] on the host's clock

std::uint64_t microseconds(double seconds)
{
  return static_cast<std::uint64_t>(std::llround(1e6 * seconds));
}

TEST(DeviceClock, TakesTheFirstFrameAsItArrives)
{
  DeviceClock clock;
  EXPECT_DOUBLE_EQ(clock.toHost(12345, kStart), kStart);
}

TEST(DeviceClock, EvensOutDelayedArrivals)
{
  DeviceClock clock;
  std::mt19937 random(1);
  std::exponential_distribution<double> delay(1.0 / 0.01);
  double last = 0.0;
  for (int i = 0; i < 300; ++i) {
    const double host = clock.toHost(microseconds(i * kPeriod), kStart + i * kPeriod + delay(random));
    if (i > 150) {
      EXPECT_NEAR(host - last, kPeriod, 1e-3) << "frame " << i;
      EXPECT_NEAR(host, kStart + i * kPeriod, 2e-3) << "frame " << i;
    }
    last = host;
  }
}

TEST(DeviceClock, NeverStandsStill)
{
  DeviceClock clock;
  const double late = clock.toHost(0, kStart + 0.5);
  EXPECT_GT(clock.toHost(microseconds(kPeriod), kStart + kPeriod), late);
}

TEST(DeviceClock, FollowsADriftEitherWay)
{
  for (const double drift : {-5e-5, 5e-5}) {
    DeviceClock clock;
    for (int i = 0; i < 30000; ++i) {
      const double arrival = kStart + i * kPeriod;
      EXPECT_NEAR(clock.toHost(microseconds(i * kPeriod * (1.0 + drift)), arrival), arrival, 1e-4)
          << "frame " << i;
    }
  }
}

TEST(DeviceClock, BeginsAnewWhenARecordingDoes)
{
  DeviceClock clock;
  clock.toHost(microseconds(0.6), kStart);
  EXPECT_DOUBLE_EQ(clock.toHost(0, kStart + kPeriod), kStart + kPeriod);
}

TEST(DeviceClock, BeginsAnewWhenTheHostsClockJumps)
{
  for (const double jump : {-100.0, 100.0}) {
    DeviceClock clock;
    clock.toHost(0, kStart);
    EXPECT_DOUBLE_EQ(clock.toHost(microseconds(kPeriod), kStart + jump), kStart + jump);
  }
}

}  // namespace
}  // namespace polygonal_perception::openni2
