#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace polygonal_perception::benchmarks {

/// The unit that speed is measured in: reads every byte once, as fast as the memory gives them. (The sum only
/// keeps the compiler from leaving the reading out; there are more of them than it takes to hide the
/// additions.)
inline std::uint64_t readPass(const void* data, std::size_t size)
{
  constexpr std::size_t kSums = 16;
  std::uint64_t sums[kSums] = {};
  const auto* const bytes = static_cast<const std::uint8_t*>(data);
  for (std::size_t at = 0; at + sizeof sums <= size; at += sizeof sums) {
    std::uint64_t words[kSums];
    std::memcpy(words, bytes + at, sizeof words);
    for (std::size_t k = 0; k < kSums; ++k) sums[k] += words[k];
  }
  std::uint64_t sum = 0;
  for (const std::uint64_t s : sums) sum += s;
  return sum;
}

}  // namespace polygonal_perception::benchmarks
