#include <sstream>

#include "polygonal_perception/perception/parameter_check.hpp"
#include "ros/perception/node_parameters.hpp"

namespace polygonal_perception::ros_perception {

namespace {

/// Writes a row a parameter.
class TableWriter
{
public:
  explicit TableWriter(std::ostream& out) : out_(out) {}

  template <class T>
  void operator()(const char* name, const T& value, const parameters::Range& range, const char* unit,
                  const char* help)
  {
    row(name, std::is_integral_v<T> ? "int" : "double", perception::numberText(static_cast<double>(value)),
        perception::rangeText(range, unit), help);
  }
  void operator()(const char* name, const std::string& value, const TextRule& rule, const char* help)
  {
    row(name, "string", value.empty() ? "(empty)" : value, rule.accepted, help);
  }
  void operator()(const char* name, bool value, const char* help)
  {
    row(name, "bool", value ? "true" : "false", "", help);
  }
  void operator()(const char* name, const Eigen::Vector3d& value, const char* help)
  {
    row(name, "list",
        "[" + perception::numberText(value.x()) + ", " + perception::numberText(value.y()) + ", " +
            perception::numberText(value.z()) + "]",
        "not zero", help);
  }

private:
  void row(const std::string& name, const std::string& type, const std::string& value,
           const std::string& accepted, const std::string& help)
  {
    out_ << "| `" << name << "` | " << type << " | " << value << " | " << accepted << " | " << help << " |\n";
  }

  std::ostream& out_;
};

}  // namespace

std::string parameterTable()
{
  std::ostringstream table;
  table << "| Parameter | Type | Default | Accepted | Meaning |\n|---|---|---|---|---|\n";
  TableWriter writer(table);
  const NodeParameters defaults;
  NodeParameters::describe(defaults, writer);
  return table.str();
}

}  // namespace polygonal_perception::ros_perception
