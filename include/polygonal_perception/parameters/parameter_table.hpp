#pragma once

#include <limits>

namespace polygonal_perception::parameters {

/// The values that a numeric parameter may take, both ends included.
struct Range
{
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};

/// How every stage describes its parameters, once, for everybody who needs to know them.
///
/// A stage's `Parameters` struct holds the defaults as member initialisers and has one static function
/// template
///
///     template <class Self, class Visitor>
///     static void describe(Self& self, Visitor&& visit);
///
/// that calls `visit(name, self.member, Range{min, max}, unit, help)` for each member. The ROS side reads,
/// checks, reconfigures and documents parameters through it; names are unique across all stages.
///
/// This visitor remembers the first parameter that is out of its range.
class RangeCheck
{
public:
  template <class T>
  void operator()(const char* name, const T& value, const Range& range, const char* /*unit*/,
                  const char* /*help*/)
  {
    const auto number = static_cast<double>(value);
    // Written so that NaN fails.
    if (!(number >= range.min && number <= range.max) && offender_ == nullptr) offender_ = name;
  }

  /// The name of the first parameter that is out of its range, or nullptr when all are good.
  const char* offender() const { return offender_; }

private:
  const char* offender_ = nullptr;
};

}  // namespace polygonal_perception::parameters
