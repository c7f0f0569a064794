#include <gtest/gtest.h>

#include <cmath>

#include "plugins/dense_plan.hpp"

namespace polygonal_perception::plugins {
namespace {

std_msgs::Header header()
{
  std_msgs::Header header;
  header.frame_id = "map";
  return header;
}

double yaw(const geometry_msgs::PoseStamped& pose)
{
  return 2.0 * std::atan2(pose.pose.orientation.z, pose.pose.orientation.w);
}

const Eigen::Isometry3d kSame(Eigen::Isometry3d::Identity());

TEST(DensePlan, HasNoLongSegment)
{
  const auto plan = densePlan({{0, 0}, {1, 0}, {1, 0.35}}, kSame, 0.25, std::nullopt, header());
  ASSERT_EQ(plan.size(), 7U);
  EXPECT_DOUBLE_EQ(plan[3].pose.position.x, 0.75);
  EXPECT_DOUBLE_EQ(plan[4].pose.position.x, 1.0);
  EXPECT_DOUBLE_EQ(plan[4].pose.position.y, 0.0);
  EXPECT_DOUBLE_EQ(plan[5].pose.position.y, 0.175);
  EXPECT_DOUBLE_EQ(plan[6].pose.position.y, 0.35);
  EXPECT_DOUBLE_EQ(yaw(plan[3]), 0.0);
  EXPECT_DOUBLE_EQ(yaw(plan[4]), M_PI / 2);
  EXPECT_DOUBLE_EQ(yaw(plan[6]), M_PI / 2) << "any will do: that of the last segment";
  EXPECT_EQ(plan[6].header.frame_id, "map");
}

TEST(DensePlan, EndsWithTheGoalsOwnYaw)
{
  const auto plan = densePlan({{0, 0}, {0, 0}}, kSame, 0.1, -1.0, header());
  ASSERT_EQ(plan.size(), 2U);
  EXPECT_DOUBLE_EQ(yaw(plan[0]), 0.0);
  EXPECT_DOUBLE_EQ(yaw(plan[1]), -1.0);
}

TEST(DensePlan, IsTakenIntoTheFrame)
{
  Eigen::Isometry3d to_map = Eigen::Translation3d(1, 2, 0.3) * Eigen::Isometry3d::Identity();
  to_map.rotate(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));
  const auto plan = densePlan({{0, 0}, {1, 0}}, to_map, 2.0, 0.5, header());
  ASSERT_EQ(plan.size(), 2U);
  EXPECT_NEAR(plan[1].pose.position.x, 1.0, 1e-12);
  EXPECT_NEAR(plan[1].pose.position.y, 3.0, 1e-12);
  EXPECT_EQ(plan[1].pose.position.z, 0.0);
  EXPECT_NEAR(yaw(plan[0]), M_PI / 2, 1e-12);
  EXPECT_NEAR(yaw(plan[1]), M_PI / 2 + 0.5, 1e-12);
}

}  // namespace
}  // namespace polygonal_perception::plugins
