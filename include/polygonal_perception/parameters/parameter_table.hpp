#pragma once

#include <limits>
#include <string>

namespace polygonal_perception::parameters {

/// How a struct describes its parameters, once, for everybody who needs to know them.
///
/// A `Parameters` struct holds the defaults as member initialisers and has one static function template
///
///     template <class Self, class Visitor>
///     static void describe(Self& self, Visitor&& visit);
///
/// that calls, for each member, one of
///
///     visit(name, self.number, Range{min, max}, unit, help);     int or double
///     visit(name, self.text, TextRule{accepted, accepts}, help); std::string
///     visit(name, self.flag, help);                              bool
///     visit(name, self.direction, help);                         Eigen::Vector3d, any but the zero vector,
///                                                                or std::optional of it
///     visit(name, self.boxes, help);                             std::vector<FrameBox>
///     visit(name, self.names, help);                             std::vector<std::string>, none of them empty or twice
///
/// Names are those of the ROS parameters, unique within a node. ROS nodes read, check and document their
/// parameters through it, and let dynamic_reconfigure change the numbers, except for those whose range says
/// atStart().

/// The values that a numeric parameter may take, both ends included.
struct Range
{
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool at_start = false;  ///< read when the node starts, and never changed after that

  /// Written so that NaN is in no range.
  constexpr bool contains(double number) const { return number >= min && number <= max; }
  constexpr Range atStart() const { return {min, max, true}; }
};

/// What a text parameter may be.
struct TextRule
{
  const char* accepted;  ///< for messages and tables
  bool (*accepts)(const std::string& text);
};

/// A name that a parameter had once. A struct may list them in a static function retired(); who still sets one is told
/// the new name, and that it means something else.
struct RetiredName
{
  const char* name;
  const char* instead;
};

}  // namespace polygonal_perception::parameters
