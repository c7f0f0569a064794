#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace polygonal_perception::mapping {

/// Calls visit(count, value) for each run of equal values.
template <class Visit>
void forEachRun(const std::vector<std::uint8_t>& values, Visit&& visit)
{
  for (std::size_t first = 0, end = 0; first < values.size(); first = end) {
    while (end < values.size() && values[end] == values[first]) ++end;
    visit(end - first, values[first]);
  }
}

/// Makes the values again from numbers that are a count and a value in turn.
class RunDecoder
{
public:
  /// @param most  no more values than that, whatever the counts say
  explicit RunDecoder(std::size_t most) : most_(most) {}

  /// @return what is wrong with the next number, or nothing
  std::optional<std::string> take(std::uint64_t number);

  /// What is wrong with a next entry that is no such number.
  std::string refuse(const std::string& entry) const;

  /// @return what is wrong with an end here, or nothing
  std::optional<std::string> end() const;

  std::vector<std::uint8_t>& values() { return values_; }

private:
  std::size_t most_;
  std::size_t taken_ = 0;  // numbers
  std::uint64_t count_ = 0;
  std::vector<std::uint8_t> values_;
};

}  // namespace polygonal_perception::mapping
