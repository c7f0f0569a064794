#include <gtest/gtest.h>

#include "polygonal_perception/perception/pipeline.hpp"
#include "polygonal_perception/ros/common/reconfigure_messages.hpp"

namespace polygonal_perception::ros_common {
namespace {

using dynamic_reconfigure::Config;

template <class Parameters>
auto valueOf(const Parameters& parameters, const std::string& name)
{
  for (const auto& parameter : parameters) {
    if (parameter.name == name) return parameter.value;
  }
  ADD_FAILURE() << name << " is missing";
  return decltype(parameters.front().value)();
}

TEST(ReconfigureMessages, ASetGoesThereAndBack)
{
  perception::Pipeline::Parameters parameters;
  parameters.inflation.robot_radius = 0.2;
  parameters.samples.samples_x = 48;
  const Config config = toConfig(listParameters(parameters));
  EXPECT_EQ(valueOf(config.doubles, "robot_radius"), 0.2);
  EXPECT_EQ(valueOf(config.ints, "samples_x"), 48);
  ASSERT_EQ(config.groups.size(), 1U);
  EXPECT_EQ(config.groups[0].name, "Default");

  perception::Pipeline::Parameters copy;
  EXPECT_EQ(mergeConfig(config, listParameters(copy)), "");
  EXPECT_EQ(copy.inflation.robot_radius, 0.2);
  EXPECT_EQ(copy.samples.samples_x, 48);
}

TEST(ReconfigureMessages, DescriptionsComeFromTheStages)
{
  perception::Pipeline::Parameters defaults;
  const dynamic_reconfigure::ConfigDescription description = describeConfig(listParameters(defaults));
  ASSERT_EQ(description.groups.size(), 1U);
  const auto& parameters = description.groups[0].parameters;
  EXPECT_EQ(parameters.size(), description.min.doubles.size() + description.min.ints.size());
  EXPECT_EQ(parameters.size(), description.dflt.doubles.size() + description.dflt.ints.size());
  EXPECT_EQ(valueOf(description.min.doubles, "robot_radius"), 0.0);
  EXPECT_EQ(valueOf(description.max.doubles, "robot_radius"), 5.0);
  EXPECT_EQ(valueOf(description.dflt.doubles, "robot_radius"), 0.3);
  EXPECT_EQ(valueOf(description.max.ints, "min_points_per_cell"), 255);
}

TEST(ReconfigureMessages, WhatIsNotNamedStays)
{
  Config config;
  config.doubles.resize(1);
  config.doubles[0].name = "robot_radius";
  config.doubles[0].value = 0.5;
  config.ints.resize(1);
  config.ints[0].name = "grid_length";  // a whole number will do
  config.ints[0].value = 4;
  perception::Pipeline::Parameters parameters;
  parameters.projection.max_height = 1.1;
  EXPECT_EQ(mergeConfig(config, listParameters(parameters)), "");
  EXPECT_EQ(parameters.inflation.robot_radius, 0.5);
  EXPECT_EQ(parameters.grid.grid_length, 4.0);
  EXPECT_EQ(parameters.projection.max_height, 1.1);
}

TEST(ReconfigureMessages, UnknownNamesAndWrongTypesAreFound)
{
  perception::Pipeline::Parameters parameters;
  Config config;
  config.doubles.resize(1);
  config.doubles[0].name = "samples_x";
  EXPECT_EQ(mergeConfig(config, listParameters(parameters)),
            "samples_x is no parameter, or none that takes a double");
  config.doubles.clear();
  config.strs.resize(1);
  config.strs[0].name = "robot_radius";
  EXPECT_EQ(mergeConfig(config, listParameters(parameters)),
            "robot_radius is no parameter, or none that takes a string");
}

}  // namespace
}  // namespace polygonal_perception::ros_common
