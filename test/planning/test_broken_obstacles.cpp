#include <gtest/gtest.h>

#include "reference/plan_stress.hpp"

namespace polygonal_perception::test {
namespace {

TEST(BrokenObstacles, AreRefusedOrPlannedOn)
{
  const reference::PlanStress result = reference::stressPlans(1, 100000);
  EXPECT_EQ(result.fault, "");
  EXPECT_GT(result.refused, result.sets / 10);
  EXPECT_LT(result.refused, result.sets * 3 / 4);
  EXPECT_GT(result.valid, result.sets / 10);
  EXPECT_GT(result.found, result.queries / 4);
}

}  // namespace
}  // namespace polygonal_perception::test
