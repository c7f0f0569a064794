#include <gtest/gtest.h>

#include <array>

#include "polygonal_perception/ros/common/grid_messages.hpp"
#include "ros/perception/message_conversions.hpp"
#include "ros/perception/obstacle_points.hpp"

namespace polygonal_perception::ros_perception {

using ros_common::toObservedGrid;
using ros_common::toOccupancyGrid;
using ros_common::toUnknownGrid;
namespace {

std_msgs::Header header()
{
  std_msgs::Header header;
  header.stamp = ros::Time(12, 34);
  header.frame_id = "frame";
  return header;
}

perception::FloorState floor(perception::FloorStatus status)
{
  perception::FloorState state;
  state.status = status;
  state.floor.plane = {Eigen::Vector3d(0.0, -0.8, -0.6), 1.25};
  state.floor.rms_error = 0.002;
  state.floor.sample_count = 321;
  state.age = 0.25;
  return state;
}

/// 2 m ahead, 1 m to the left, turned by a quarter to the left.
Eigen::Isometry2d quarterTurn()
{
  Eigen::Isometry2d pose = Eigen::Isometry2d::Identity();
  pose.linear() << 0.0, -1.0, 1.0, 0.0;
  pose.translation() << 2.0, 1.0;
  return pose;
}

TEST(MessageConversions, PlanesAreSaidWhole)
{
  perception::SegmentedPlanes planes;
  planes.vertices = {{9.0F, 9.0F, 9.0F}, {0.0F, 0.0F, 2.0F}, {1.0F, 0.0F, 2.0F}, {1.0F, 1.0F, 2.0F}};
  planes.planes.resize(2);
  planes.planes[0].id = 7;
  planes.planes[0].kind = perception::PlaneKind::kVertical;
  planes.planes[0].plane = {Eigen::Vector3d(0.0, 0.0, -1.0), 2.0};
  planes.planes[0].rms_error = 0.003;
  planes.planes[0].sample_count = 50;
  planes.planes[0].first_vertex = 1;
  planes.planes[0].vertex_count = 3;
  const PlaneArrayPtr message = toPlaneArray(header(), planes);
  EXPECT_EQ(message->header.stamp, header().stamp);
  EXPECT_EQ(message->header.frame_id, "frame");
  ASSERT_EQ(message->planes.size(), 2U);
  const Plane& plane = message->planes[0];
  EXPECT_EQ(plane.id, 7U);
  EXPECT_EQ(plane.kind, Plane::VERTICAL);
  EXPECT_EQ(plane.normal.z, -1.0);
  EXPECT_EQ(plane.distance, 2.0);
  EXPECT_EQ(plane.rms_error, 0.003);
  EXPECT_EQ(plane.sample_count, 50U);
  ASSERT_EQ(plane.boundary.size(), 3U);
  EXPECT_EQ(plane.boundary[0].x, 0.0F);
  EXPECT_EQ(plane.boundary[2].y, 1.0F);
  EXPECT_EQ(plane.boundary[2].z, 2.0F);
  EXPECT_TRUE(message->planes[1].boundary.empty());
}

TEST(MessageConversions, AFloorIsSaidWhole)
{
  perception::FloorState state = floor(perception::FloorStatus::kHeld);
  // The normal's third component errs, which is a tilt about the floor frame's y axis, and moves the distance.
  state.floor.covariance(2, 2) = 4e-6;
  state.floor.covariance(2, 3) = state.floor.covariance(3, 2) = 2e-6;
  state.floor.covariance(3, 3) = 9e-6;
  const Eigen::Isometry3d to_floor_frame = perception::floorFrame(state.floor.plane, perception::ViewAxes{});
  const FloorPlanePtr message = toFloorPlane(header(), state, to_floor_frame, {{1.0F, 2.0F, 3.0F}});
  EXPECT_EQ(message->header.stamp, header().stamp);
  EXPECT_EQ(message->header.frame_id, "frame");
  EXPECT_EQ(message->status, FloorPlane::HELD);
  EXPECT_EQ(message->normal.y, -0.8);
  EXPECT_EQ(message->distance, 1.25);
  EXPECT_EQ(message->age, 0.25);
  EXPECT_EQ(message->sample_count, 321U);
  EXPECT_EQ(message->rms_error, 0.002);
  // The frame's x axis is (0, -0.6, 0.8): 0.8 of the error lies along it.
  const std::array<double, 6> covariance = {0.0, 0.0, 0.0, 0.64 * 4e-6, 0.8 * 2e-6, 9e-6};
  for (std::size_t k = 0; k < covariance.size(); ++k) {
    EXPECT_NEAR(message->covariance[k], covariance[k], 1e-15) << "entry " << k << " of the upper triangle";
  }
  ASSERT_EQ(message->hull.size(), 1U);
  EXPECT_EQ(message->hull[0].z, 3.0F);

  const auto coefficients = toModelCoefficients(header(), floor(perception::FloorStatus::kFound));
  EXPECT_EQ(coefficients->values, (std::vector<float>{0.0F, -0.8F, -0.6F, 1.25F}));
}

TEST(MessageConversions, NoFloorSaysNothingOfAnOldOne)
{
  const FloorPlanePtr message = toFloorPlane(header(), floor(perception::FloorStatus::kNotFound),
                                             Eigen::Isometry3d::Identity(), {{1.0F, 2.0F, 3.0F}});
  EXPECT_EQ(message->status, FloorPlane::NOT_FOUND);
  EXPECT_EQ(message->distance, 0.0);
  EXPECT_TRUE(message->hull.empty());
  EXPECT_TRUE(toModelCoefficients(header(), floor(perception::FloorStatus::kNotFound))->values.empty());
}

TEST(MessageConversions, AGridIsPlacedByItsOrigin)
{
  occupancy::GridParameters size;
  size.grid_length = 0.3;
  size.grid_width = 0.2;
  size.grid_resolution = 0.1;
  occupancy::BinaryGrid grid{occupancy::GridGeometry(size)};
  grid.set(2, 1);
  const auto message = toOccupancyGrid(header(), grid, quarterTurn());
  EXPECT_EQ(message->info.width, 3U);
  EXPECT_EQ(message->info.height, 2U);
  EXPECT_FLOAT_EQ(message->info.resolution, 0.1F);
  EXPECT_EQ(message->data, (std::vector<std::int8_t>{0, 0, 0, 0, 0, 100}));
  // The corner (0, -0.1) turned to (0.1, 0) and shifted.
  EXPECT_NEAR(message->info.origin.position.x, 2.1, 1e-9);
  EXPECT_NEAR(message->info.origin.position.y, 1.0, 1e-9);
  EXPECT_NEAR(message->info.origin.orientation.z, std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(message->info.origin.orientation.w, std::sqrt(0.5), 1e-9);

  const auto unknown = toUnknownGrid(header(), grid.geometry(), quarterTurn());
  EXPECT_EQ(unknown->data, std::vector<std::int8_t>(6, -1));
  EXPECT_EQ(unknown->info.origin, message->info.origin);
}

TEST(MessageConversions, WhatIsOccupiedComesBeforeWhatWasSeenFree)
{
  occupancy::GridParameters size;
  size.grid_length = 0.4;
  size.grid_width = 0.1;
  size.grid_resolution = 0.1;
  occupancy::BinaryGrid grid{occupancy::GridGeometry(size)};
  grid.set(1, 0);
  grid.set(2, 0);
  occupancy::ObservedCells observed;
  observed.floor = {1, 1, 0, 0};
  observed.hit = {0, 1, 1, 0};
  const auto message = toObservedGrid(header(), grid, observed.floor, quarterTurn());
  EXPECT_EQ(message->data, (std::vector<std::int8_t>{0, 100, 100, -1}));
  EXPECT_EQ(message->info, toOccupancyGrid(header(), grid, quarterTurn())->info);
}

TEST(MessageConversions, ObstaclePointsKeepTheirHeight)
{
  const auto cloud = toObstaclePoints(header(), {{1.0F, 0.0F, 0.25F}, {0.0F, 1.0F, 0.5F}}, quarterTurn());
  EXPECT_EQ(cloud->width, 2U);
  EXPECT_EQ(cloud->height, 1U);
  EXPECT_EQ(cloud->row_step, 24U);
  ASSERT_EQ(cloud->data.size(), 24U);
  const auto* values = reinterpret_cast<const float*>(cloud->data.data());
  EXPECT_EQ(std::vector<float>(values, values + 6),
            (std::vector<float>{2.0F, 2.0F, 0.25F, 1.0F, 1.0F, 0.5F}));
  EXPECT_EQ(toObstaclePoints(header(), {}, quarterTurn())->width, 0U);
}

}  // namespace
}  // namespace polygonal_perception::ros_perception
