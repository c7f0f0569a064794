#include <gtest/gtest.h>

#include <limits>

#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/perception/pipeline.hpp"

namespace polygonal_perception::perception {
namespace {

using parameters::findFault;
using Names = std::vector<std::string>;

TEST(ParameterCheck, DefaultsAreGood)
{
  const auto fault = findFault(Pipeline::Parameters{});
  EXPECT_FALSE(fault) << fault->reason;
}

TEST(ParameterCheck, NamesTheParameterItsValueAndItsRange)
{
  Pipeline::Parameters parameters;
  parameters.inflation.robot_radius = -0.1;
  const auto fault = findFault(parameters);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->names, Names{"robot_radius"});
  EXPECT_EQ(fault->reason, "robot_radius is -0.1, accepted is 0 to 5 m");
}

TEST(ParameterCheck, NaNIsOutOfEveryRange)
{
  Pipeline::Parameters parameters;
  parameters.detector.selection.max_tilt = std::numeric_limits<double>::quiet_NaN();
  const auto fault = findFault(parameters);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->names, Names{"max_tilt"});
}

TEST(ParameterCheck, HeightsMustBeInOrder)
{
  Pipeline::Parameters parameters;
  parameters.projection.min_height = 0.6;
  auto fault = findFault(parameters);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->names, (Names{"min_height", "max_height"}));
  EXPECT_EQ(fault->reason, "min_height is 0.6 and max_height is 0.6, accepted is min_height < max_height");

  parameters = {};
  parameters.detector.selection.max_camera_height = 0.04;
  fault = findFault(parameters);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->names, (Names{"min_camera_height", "max_camera_height"}));
}

TEST(ParameterCheck, AGridOfTooManyCellsIsRefused)
{
  Pipeline::Parameters parameters;
  parameters.grid.grid_length = parameters.grid.grid_width = 50.0;
  EXPECT_FALSE(findFault(parameters)) << "a million cells";
  parameters.grid.grid_resolution = 0.01;
  const auto fault = findFault(parameters);
  ASSERT_TRUE(fault) << "25 million cells";
  EXPECT_EQ(fault->names, (Names{"grid_length", "grid_behind", "grid_width", "grid_resolution"}));

  parameters.grid = {};
  parameters.grid.grid_width = 50.0;
  parameters.grid.grid_resolution = 0.01;
  EXPECT_FALSE(findFault(parameters)) << "2.5 million cells";
  parameters.grid.grid_behind = 5.0;
  EXPECT_TRUE(findFault(parameters)) << "twice as many";
}

TEST(ParameterCheck, UpMustBeADirection)
{
  Pipeline::Parameters parameters;
  parameters.tracker.initial_up.setZero();
  const auto fault = findFault(parameters);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->names, Names{"initial_up"});
}

}  // namespace
}  // namespace polygonal_perception::perception
