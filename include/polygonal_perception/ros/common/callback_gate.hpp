#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace polygonal_perception::ros_common {

/// Lets callbacks in, one at a time, until it is closed.
///
/// roscpp may start a callback even after its service was shut down: a call that is on its way into the queue
/// at that moment is not taken back. So the object behind a callback may be gone, and its mutex with it,
/// whatever it did in its destructor. A callback that owns the gate with the object, and looks there first,
/// is safe.
class CallbackGate
{
public:
  /// @return a lock to keep while the object is used; one that owns nothing once the gate is closed
  std::unique_lock<std::mutex> enter()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    if (!is_open_) lock.unlock();
    return lock;
  }

  /// Waits for the callback that is inside; after this none comes in.
  void close()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_open_ = false;
  }

  /// The same from inside, by who holds the lock: who waits outside does not come in any more.
  void closeInside() { is_open_ = false; }

private:
  std::mutex mutex_;
  bool is_open_ = true;
};

/// A callback that runs `action` only inside the gate.
template <class Action>
auto gated(const std::shared_ptr<CallbackGate>& gate, Action action)
{
  return [gate, action = std::move(action)](auto&&... arguments) {
    const std::unique_lock<std::mutex> inside = gate->enter();
    if (inside.owns_lock()) action(std::forward<decltype(arguments)>(arguments)...);
  };
}

}  // namespace polygonal_perception::ros_common
