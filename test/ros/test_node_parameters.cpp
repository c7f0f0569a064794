#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/ros/common/parameter_holder.hpp"
#include "polygonal_perception/ros/perception/perception_node.hpp"
#include "ros/perception/perception_parameters.hpp"

namespace polygonal_perception::ros_perception {
namespace {

using Texts = std::vector<std::string>;

/// A private namespace of its own a test.
class NodeParametersTest : public testing::Test
{
protected:
  PerceptionParameters read()
  {
    ros_common::ParameterReport report;
    const auto parameters = ros_common::readParameters<PerceptionParameters>(handle_, report);
    errors_ = report.errors;
    warnings_ = report.warnings;
    return parameters;
  }

  ros::NodeHandle handle_{std::string("/") + testing::UnitTest::GetInstance()->current_test_info()->name()};
  Texts errors_;
  Texts warnings_;
};

TEST_F(NodeParametersTest, AreTheDefaultsWhereNothingIsSet)
{
  const PerceptionParameters parameters = read();
  EXPECT_TRUE(errors_.empty()) << errors_.front();
  EXPECT_TRUE(warnings_.empty()) << warnings_.front();
  EXPECT_EQ(parameters.input, "cloud");
  EXPECT_EQ(parameters.floor_frame, "floor");
  EXPECT_TRUE(parameters.output_frame.empty());
  EXPECT_TRUE(parameters.lazy);
  EXPECT_EQ(parameters.pipeline.inflation.robot_radius, occupancy::Inflation::Parameters{}.robot_radius);
}

TEST_F(NodeParametersTest, GoodValuesAreTaken)
{
  handle_.setParam("input", "depth");
  handle_.setParam("output_frame", "odom");
  handle_.setParam("lazy", false);
  handle_.setParam("robot_radius", 0.2);
  handle_.setParam("grid_length", 4);  // a whole number will do
  handle_.setParam("samples_x", 16);
  handle_.setParam("initial_up", std::vector<double>{0.0, 0.0, 1.0});
  handle_.setParam("forward", std::vector<double>{0.0, 2.0, 0.0});
  const PerceptionParameters parameters = read();
  EXPECT_TRUE(errors_.empty()) << errors_.front();
  EXPECT_EQ(parameters.input, "depth");
  EXPECT_EQ(parameters.output_frame, "odom");
  EXPECT_FALSE(parameters.lazy);
  EXPECT_EQ(parameters.pipeline.inflation.robot_radius, 0.2);
  EXPECT_EQ(parameters.pipeline.grid.grid_length, 4.0);
  EXPECT_EQ(parameters.pipeline.samples.samples_x, 16);
  EXPECT_EQ(parameters.pipeline.tracker.initial_up, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(parameters.pipeline.view.forward, Eigen::Vector3d(0.0, 2.0, 0.0));
}

TEST_F(NodeParametersTest, BadValuesAreRefusedWithNameValueAndRange)
{
  const std::string name = handle_.getNamespace();
  handle_.setParam("input", "colour");
  handle_.setParam("floor_frame", "/floor");
  handle_.setParam("lazy", "perhaps");
  handle_.setParam("initial_up", std::vector<double>{0.0, 0.0, 0.0});
  handle_.setParam("forward", std::vector<double>{1.0});
  handle_.setParam("samples_x", 3.5);
  handle_.setParam("max_tilt", 3);
  handle_.setParam("lower_plane_weight", "many");
  const PerceptionParameters parameters = read();
  const std::string stays = "; the default stays";
  EXPECT_EQ(errors_,
            (Texts{"parameter " + name + "/input is colour, accepted is cloud, depth" + stays,
                   "parameter " + name + "/floor_frame is /floor, accepted is a frame" + stays,
                   "parameter " + name + "/lazy is perhaps, accepted is true or false" + stays,
                   "parameter " + name +
                       "/initial_up is {0,0,0}, accepted is a list of three numbers that are not "
                       "all zero" +
                       stays,
                   "parameter " + name +
                       "/forward is {1}, accepted is an empty list, or one of three numbers that are not all "
                       "zero" +
                       stays,
                   "parameter " + name + "/samples_x is 3.5, accepted is 4 to 256 (a whole number)" + stays,
                   "parameter " + name + "/max_tilt is 3, accepted is 0.01 to 1.4 rad" + stays,
                   "parameter " + name + "/lower_plane_weight is many, accepted is 0 to 100" + stays}));
  EXPECT_EQ(parameters.input, "cloud");
  EXPECT_EQ(parameters.floor_frame, "floor");
  EXPECT_EQ(parameters.pipeline.samples.samples_x, 32);
  EXPECT_FALSE(polygonal_perception::parameters::findFault(parameters));
}

TEST_F(NodeParametersTest, BoxesAreListsOfAFrameAndTwoCorners)
{
  XmlRpc::XmlRpcValue boxes;
  boxes[0][0] = "base_link";
  for (int i = 0; i < 6; ++i) boxes[0][1 + i] = 0.5 * i;
  handle_.setParam("ignore_boxes", boxes);
  const PerceptionParameters good = read();
  EXPECT_TRUE(errors_.empty()) << errors_.front();
  ASSERT_EQ(good.ignore_boxes.size(), 1U);
  EXPECT_EQ(good.ignore_boxes[0].frame, "base_link");
  EXPECT_EQ(good.ignore_boxes[0].from, (std::array<double, 3>{0.0, 0.5, 1.0}));
  EXPECT_EQ(good.ignore_boxes[0].to, (std::array<double, 3>{1.5, 2.0, 2.5}));
  EXPECT_TRUE(good.needsTf());

  boxes[0][6] = 0.9;
  handle_.setParam("ignore_boxes", boxes);
  EXPECT_TRUE(read().ignore_boxes.empty());
  ASSERT_EQ(errors_.size(), 1U);
  EXPECT_NE(errors_[0].find(
                "accepted is a list of lists [frame, x, y, z from, x, y, z to], each from at most its to"),
            std::string::npos)
      << errors_[0];
}

TEST_F(NodeParametersTest, ANameOfOldIsRefusedWithTheNewOne)
{
  handle_.setParam("merge_distance", 0.05);
  handle_.setParam("replacement_factor", 10.0);
  const PerceptionParameters parameters = read();
  const std::string name = "parameter " + handle_.getNamespace();
  const std::string rest = ", which means something else (README.md)";
  EXPECT_EQ(errors_,
            (Texts{name +
                       "/merge_distance is refused: there is no such parameter any more, accepted is "
                       "inlier_distance" +
                       rest,
                   name +
                       "/replacement_factor is refused: there is no such parameter any more, accepted is "
                       "lower_plane_weight" +
                       rest}));
  EXPECT_TRUE(warnings_.empty()) << "said once is enough: " << warnings_.front();
  const PerceptionParameters defaults;
  EXPECT_EQ(parameters.pipeline.detector.refinement.inlier_distance,
            defaults.pipeline.detector.refinement.inlier_distance);
}

TEST_F(NodeParametersTest, TheKindOfSensorGivesItsNoise)
{
  const perception::SensorNoise xtion = read().pipeline.detector.planes.noise;
  EXPECT_NEAR(xtion.at(0.4F), 0.0012F, 1e-6F);
  EXPECT_NEAR(xtion.at(2.4F), 0.0012F + 0.0019F * 4.0F, 1e-6F);
  handle_.setParam("sensor_noise", "realsense_d435");
  const perception::SensorNoise realsense = read().pipeline.detector.planes.noise;
  EXPECT_NEAR(realsense.at(0.3515F), 0.000611F, 1e-6F);
  EXPECT_NEAR(realsense.at(2.3515F), 0.000611F + 0.003587F * 4.0F, 1e-5F);
  handle_.setParam("sensor_noise", "time_of_flight");
  EXPECT_NEAR(read().pipeline.detector.planes.noise.at(3.5F), 0.017F, 1e-3F);
  handle_.setParam("sensor_noise", "lidar");
  EXPECT_NEAR(read().pipeline.detector.planes.noise.at(20.0F), 0.022F, 1e-3F);
}

TEST_F(NodeParametersTest, ANoiseThatIsSetIsNotThatOfTheSensor)
{
  handle_.setParam("sensor_noise", "realsense_d435");
  handle_.setParam("noise_quadratic", 0.01);
  const perception::SensorNoise noise = read().pipeline.detector.planes.noise;
  EXPECT_EQ(noise.quadratic, 0.01);
  EXPECT_EQ(noise.constant, perception::SensorNoise::preset("realsense_d435")->constant);
  handle_.setParam("sensor_noise", "kinect");
  read();
  ASSERT_EQ(errors_.size(), 1U);
  EXPECT_EQ(errors_.front(),
            "parameter " + handle_.getNamespace() +
                "/sensor_noise is kinect, accepted is xtion, realsense_d435, time_of_flight, lidar; "
                "the default stays");
}

TEST_F(NodeParametersTest, ValuesThatContradictEachOtherFallBackTogether)
{
  handle_.setParam("min_height", 0.5);
  handle_.setParam("max_height", 0.4);
  handle_.setParam("robot_radius", 0.2);
  const PerceptionParameters parameters = read();
  ASSERT_EQ(errors_.size(), 1U);
  EXPECT_EQ(errors_.front(),
            "parameters in " + handle_.getNamespace() +
                ": min_height is 0.5 and max_height is 0.4, accepted is min_height < max_height; "
                "their defaults stay");
  EXPECT_EQ(parameters.pipeline.projection.min_height, 0.03);
  EXPECT_EQ(parameters.pipeline.projection.max_height, 0.6);
  EXPECT_EQ(parameters.pipeline.inflation.robot_radius, 0.2);
}

TEST_F(NodeParametersTest, SlipsOfThePenAreFound)
{
  handle_.setParam("robot_radus", 0.2);
  handle_.setParam("diagnostic_period", 2.0);
  handle_.setParam("samples/compressed/format", "png");
  read();
  EXPECT_EQ(warnings_, Texts{"parameter " + handle_.getNamespace() +
                             "/robot_radus means nothing to this node; is it misspelt?"});
}

TEST_F(NodeParametersTest, AreWrittenBack)
{
  perception::Pipeline::Parameters parameters;
  parameters.inflation.robot_radius = 0.45;
  parameters.samples.samples_y = 24;
  ros_common::writeParameters(handle_, ros_common::listParameters(parameters));
  EXPECT_EQ(handle_.param("robot_radius", 0.0), 0.45);
  EXPECT_EQ(handle_.param("samples_y", 0), 24);
  const PerceptionParameters read_back = read();
  EXPECT_EQ(read_back.pipeline.inflation.robot_radius, 0.45);
}

TEST(ShippedConfigurations, AreTakenWhole)
{
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(CONFIG_FOLDER)) {
    // test/navigation has those of costmap_2d, and drive.test that of who drives.
    const std::string name = file.path().stem().string();
    if (name.rfind("costmap_", 0) == 0 || name == "drive") continue;
    const ros::NodeHandle handle("/configurations/" + file.path().stem().string());
    ASSERT_EQ(std::system(("rosparam load " + file.path().string() + " " + handle.getNamespace()).c_str()),
              0);
    ros_common::ParameterReport report;
    ros_common::readParameters<PerceptionParameters>(handle, report);
    EXPECT_TRUE(report.errors.empty()) << file.path() << ": " << report.errors.front();
    EXPECT_TRUE(report.warnings.empty()) << file.path() << ": " << report.warnings.front();
    ++count;
  }
  EXPECT_GE(count, 4) << "in " << CONFIG_FOLDER;
}

TEST(ParameterTable, HasARowAParameter)
{
  const std::string table = PerceptionNode::parameterTable();
  EXPECT_NE(table.find("| `robot_radius` | double | 0.3 | 0 to 5 m | Radius"), std::string::npos) << table;
  EXPECT_NE(table.find("| `initial_up` | list | [0, -1, 0] | not zero |"), std::string::npos) << table;
  EXPECT_NE(table.find("| `forward` | list | [] | empty or not zero |"), std::string::npos) << table;
  EXPECT_NE(table.find("| `output_frame` | string | (empty) | a frame or empty |"), std::string::npos)
      << table;
}

TEST(ParameterTable, IsTheOneInTheReadme)
{
  std::ifstream file(README);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string begin = "<!-- parameters: begin -->\n";
  const std::size_t from = text.find(begin);
  const std::size_t to = text.find("<!-- parameters: end -->");
  ASSERT_NE(from, std::string::npos) << README;
  ASSERT_NE(to, std::string::npos) << README;
  EXPECT_EQ(text.substr(from + begin.size(), to - from - begin.size()), PerceptionNode::parameterTable())
      << "put there what polygonal_perception_parameters prints";
}

}  // namespace
}  // namespace polygonal_perception::ros_perception

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_node_parameters");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
