#pragma once

#include <optional>
#include <string>
#include <utility>

namespace polygonal_perception::ros_common {

/// A value, or the text that says why there is none.
template <class T>
class Expected
{
public:
  // Implicit, so that a function that may fail returns its value as it is.
  Expected(T value) : value_(std::move(value)) {}  // NOLINT(google-explicit-constructor)

  static Expected failure(const std::string& reason)
  {
    Expected failed;
    failed.error_ = reason;
    return failed;
  }

  explicit operator bool() const { return value_.has_value(); }
  const T& operator*() const { return *value_; }
  const T* operator->() const { return &*value_; }

  /// Why there is no value; empty where there is one.
  const std::string& error() const { return error_; }

private:
  Expected() = default;

  std::optional<T> value_;
  std::string error_;
};

}  // namespace polygonal_perception::ros_common
