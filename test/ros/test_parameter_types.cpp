// Whatever the parameter server holds: what a parameter cannot take is refused, and its default stays.
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "polygonal_perception/ros/common/parameter_holder.hpp"
#include "ros/perception/perception_parameters.hpp"

namespace polygonal_perception::ros_perception {
namespace {

using XmlRpc::XmlRpcValue;

/// Every parameter, with what it is now and whether it may have a value from the server.
struct Entry
{
  std::string name;
  std::string now;
  std::function<bool(XmlRpcValue&)> accepts;
};

class Entries
{
public:
  template <class T>
  void operator()(const char* name, T& value, const parameters::Range& range, const char* /*unit*/,
                  const char* /*help*/)
  {
    add(name, value, [range](XmlRpcValue& from) {
      const double number = numberOf(from);
      const bool is_whole = number == std::floor(number);
      return number >= range.min && number <= range.max && (is_whole || !std::is_integral_v<T>);
    });
  }
  void operator()(const char* name, std::string& value, const parameters::TextRule& rule,
                  const char* /*help*/)
  {
    add(name, value, [rule](XmlRpcValue& from) {
      return from.getType() == XmlRpcValue::TypeString && rule.accepts(static_cast<std::string>(from));
    });
  }
  void operator()(const char* name, bool& value, const char* /*help*/)
  {
    add(name, value, [](XmlRpcValue& from) { return from.getType() == XmlRpcValue::TypeBoolean; });
  }
  void operator()(const char* name, Eigen::Vector3d& value, const char* /*help*/)
  {
    add(name, value.transpose(), isDirection);
  }
  void operator()(const char* name, std::optional<Eigen::Vector3d>& value, const char* /*help*/)
  {
    add(name, value.value_or(Eigen::Vector3d::Zero()).transpose(), [](XmlRpcValue& from) {
      return (from.getType() == XmlRpcValue::TypeArray && from.size() == 0) || isDirection(from);
    });
  }

  void operator()(const char* name, std::vector<parameters::FrameBox>& value, const char* /*help*/)
  {
    add(name, value.size(), [](XmlRpcValue& from) {
      if (from.getType() != XmlRpcValue::TypeArray) return false;
      for (int i = 0; i < from.size(); ++i) {
        if (!isBox(from[i])) return false;
      }
      return true;
    });
  }

  std::vector<Entry> entries;

private:
  static bool isBox(XmlRpcValue& from)
  {
    if (from.getType() != XmlRpcValue::TypeArray || from.size() != 7) return false;
    if (from[0].getType() != XmlRpcValue::TypeString) return false;
    const auto frame = static_cast<std::string>(from[0]);
    if (frame.empty() || frame.front() == '/') return false;
    for (int i = 1; i <= 3; ++i) {
      const double low = numberOf(from[i]);
      const double high = numberOf(from[i + 3]);
      if (!std::isfinite(low) || !std::isfinite(high) || low > high) return false;
    }
    return true;
  }
  static bool isDirection(XmlRpcValue& from)
  {
    if (from.getType() != XmlRpcValue::TypeArray || from.size() != 3) return false;
    const Eigen::Vector3d vector(numberOf(from[0]), numberOf(from[1]), numberOf(from[2]));
    return vector.allFinite() && !vector.isZero(0.0);
  }

  static double numberOf(XmlRpcValue& from)
  {
    if (from.getType() == XmlRpcValue::TypeInt) return static_cast<int>(from);
    return from.getType() == XmlRpcValue::TypeDouble ? static_cast<double>(from) : NAN;
  }
  template <class T>
  void add(const char* name, const T& value, std::function<bool(XmlRpcValue&)> accepts)
  {
    std::ostringstream now;
    now << value;
    entries.push_back({name, now.str(), std::move(accepts)});
  }
};

std::vector<Entry> entriesOf(PerceptionParameters parameters)
{
  Entries entries;
  PerceptionParameters::describe(parameters, entries);
  return entries.entries;
}

/// A list on the parameter server.
template <class... Items>
XmlRpcValue list(const Items&... items)
{
  XmlRpcValue result;
  result.setSize(0);
  const XmlRpcValue values[] = {XmlRpcValue(items)..., XmlRpcValue()};
  for (int i = 0; i < static_cast<int>(sizeof...(items)); ++i) result[i] = values[i];
  return result;
}

/// One of each type that the server knows, and numbers beyond all bounds.
std::vector<XmlRpcValue> valuesOfAllTypes()
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  XmlRpcValue space;
  space["a"]["b"] = 1.0;
  char bytes[] = "bytes";
  std::tm date{};
  date.tm_year = 126;
  date.tm_mday = 1;
  return {"much",
          "",
          "/slash",
          true,
          false,
          -7,
          0,
          1,
          std::numeric_limits<int>::max(),
          std::numeric_limits<int>::min(),
          0.5,
          3.5,
          -1e300,
          1e300,
          5e-324,
          kInfinity,
          -kInfinity,
          NAN,
          list(),
          list("a", "b", "c"),
          list(1, 2),
          list(0, 0, 0),
          list(0, 0, 1),
          list(NAN, 0.0, 1.0),
          list(list("base_link", 0, 0, 0, 1, 1, 1), list("arm", 0.5, -1.0, 0, 0.5, -0.5, 1)),
          list("base_link", 0, 0, 0, 1, 1, 1),
          list(list("base_link", 0, 0, 0, 1, 1)),
          list(list("base_link", 0, 0, 0, 1, -1, 1)),
          list(list("/base_link", 0, 0, 0, 1, 1, 1)),
          list(list("base_link", 0, 0, NAN, 1, 1, 1)),
          list(kInfinity, 0.0, 1.0),
          list(1.0, "a", 2.0),
          list(list(1.0), list(2.0), list(3.0)),
          space,
          XmlRpcValue(bytes, sizeof bytes),
          XmlRpcValue(&date)};
}

/// A private namespace of its own a test.
class ParameterTypes : public testing::Test
{
protected:
  PerceptionParameters read()
  {
    ros_common::ParameterReport report;
    const auto parameters = ros_common::readParameters<PerceptionParameters>(handle_, report);
    errors_ = report.errors;
    return parameters;
  }

  ros::NodeHandle handle_{std::string("/") + testing::UnitTest::GetInstance()->current_test_info()->name()};
  std::vector<std::string> errors_;
};

TEST_F(ParameterTypes, EveryParameterRefusesWhatItCannotTakeAndKeepsItsDefault)
{
  const std::vector<Entry> defaults = entriesOf(PerceptionParameters{});
  ASSERT_GT(defaults.size(), 25U);
  for (std::size_t k = 0; k < defaults.size(); ++k) {
    const std::string name = handle_.resolveName(defaults[k].name);
    for (XmlRpcValue value : valuesOfAllTypes()) {
      SCOPED_TRACE(name + " = " + value.toXml());
      handle_.setParam(name, value);
      const Entry entry = entriesOf(read())[k];
      // Those of one that contradicts another begin otherwise.
      const bool refused = !errors_.empty() && errors_.front().rfind("parameter " + name + " is ", 0) == 0;
      EXPECT_EQ(refused, !entry.accepts(value));
      if (!refused) continue;
      EXPECT_EQ(errors_.size(), 1U);
      EXPECT_NE(errors_.front().find(", accepted is "), std::string::npos) << errors_.front();
      EXPECT_EQ(entry.now, defaults[k].now);
    }
    handle_.deleteParam(name);
  }
}

TEST_F(ParameterTypes, ANamespaceThatIsNoneAndNamesBelowAParameterAreSurvived)
{
  for (const XmlRpcValue& value : valuesOfAllTypes()) {
    ros::param::set(handle_.getNamespace(), value);
    EXPECT_EQ(read().pipeline.inflation.robot_radius, 0.3) << value.toXml();
    EXPECT_TRUE(errors_.empty()) << errors_.front();
  }
  ros::param::del(handle_.getNamespace());
  handle_.setParam("robot_radius/of/something", 0.2);
  EXPECT_EQ(read().pipeline.inflation.robot_radius, 0.3);
  ASSERT_EQ(errors_.size(), 1U);
  EXPECT_NE(errors_.front().find("robot_radius is "), std::string::npos) << errors_.front();
}

}  // namespace
}  // namespace polygonal_perception::ros_perception

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_parameter_types");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
