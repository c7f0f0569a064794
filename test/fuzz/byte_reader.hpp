#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace polygonal_perception::test {

/// Takes values off the bytes that the fuzzer made; zeros where they are used up.
class ByteReader
{
public:
  ByteReader(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}

  bool empty() const { return at_ == end_; }

  template <class T>
  T raw()
  {
    T value{};
    const std::size_t size = std::min(sizeof value, left());
    std::memcpy(&value, at_, size);
    at_ += size;
    return value;
  }

  std::uint8_t byte() { return raw<std::uint8_t>(); }

  /// 0 to 99 mostly, so that sizes often fit one another; else any number.
  std::uint32_t size()
  {
    constexpr std::uint8_t kMostSmall = 100;
    const std::uint8_t small = byte();
    return small < kMostSmall ? small : raw<std::uint32_t>();
  }

  /// A depth of some metres mostly, else a value of the kind that breaks things, or any pattern of bits.
  template <class T>
  T number()
  {
    using Limits = std::numeric_limits<T>;
    constexpr T kOdd[] = {T(0),
                          -T(0),
                          -T(1),
                          T(1e30),
                          -T(1e30),
                          Limits::max(),
                          Limits::lowest(),
                          Limits::min(),
                          Limits::denorm_min(),
                          Limits::infinity(),
                          -Limits::infinity(),
                          Limits::quiet_NaN()};
    constexpr std::uint8_t kAnyBits = 255;
    constexpr auto kFirstOdd = static_cast<std::uint8_t>(kAnyBits - std::size(kOdd));
    const std::uint8_t kind = byte();
    if (kind == kAnyBits) return raw<T>();
    if (kind >= kFirstOdd) return kOdd[kind - kFirstOdd];
    return T(0.02) * static_cast<T>(kind);
  }

  std::string text()
  {
    std::string result(byte() % 8, '\0');
    for (char& letter : result) letter = static_cast<char>(byte());
    return result;
  }

  /// All that is left, in memory of exactly its size.
  std::vector<std::uint8_t> rest() { return {at_, end_}; }

private:
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

}  // namespace polygonal_perception::test
