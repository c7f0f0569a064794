#pragma once

#include <cstddef>

namespace polygonal_perception::test {

/// Counts the heap allocations of this thread since it was made, whoever makes them: operator new, Eigen and
/// OpenCV all end up in malloc and its like, which allocation_counter.cpp puts itself in front of.
class AllocationCounter
{
public:
  AllocationCounter();
  std::size_t count() const;

  /// False under a sanitizer, which needs malloc for itself.
  static bool available();

private:
  std::size_t start_;
};

}  // namespace polygonal_perception::test
