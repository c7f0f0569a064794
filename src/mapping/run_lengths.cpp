#include "mapping/run_lengths.hpp"

namespace polygonal_perception::mapping {

std::optional<std::string> RunDecoder::take(std::uint64_t number)
{
  const bool is_count = taken_ % 2 == 0;
  if (is_count) {
    if (number == 0) return refuse(std::to_string(number));
    if (number > most_ - values_.size()) {
      return "entry " + std::to_string(taken_) + " is a count of " + std::to_string(number) +
             ", and there can be no more than " + std::to_string(most_ - values_.size()) + " values";
    }
    count_ = number;
  } else {
    if (number > UINT8_MAX) return refuse(std::to_string(number));
    values_.insert(values_.end(), static_cast<std::size_t>(count_), static_cast<std::uint8_t>(number));
  }
  ++taken_;
  return std::nullopt;
}

std::string RunDecoder::refuse(const std::string& entry) const
{
  return "entry " + std::to_string(taken_) + " is " + entry + ", accepted is " +
         (taken_ % 2 == 0 ? "a count, a whole number from 1" : "a value, a whole number from 0 to 255");
}

std::optional<std::string> RunDecoder::end() const
{
  if (taken_ % 2 == 0) return std::nullopt;
  return "the last count has no value";
}

}  // namespace polygonal_perception::mapping
