#pragma once

#include <rviz/display_context.h>
#include <rviz/message_filter_display.h>

#include <algorithm>
#include <boost/function.hpp>
#include <cstddef>
#include <deque>

#include "rviz/placement.hpp"

namespace polygonal_perception::displays {

/// Once a frame of rviz, draws the newest message that has arrived and can be placed.
///
/// rviz's own MessageFilterDisplay hands over every message, one or two frames after it has arrived. Grids
/// and clouds are shown at once: on a slow screen polygons would stand beside the cells that they were made
/// from. Its filter only tells in the status here which messages were given up for want of a transform.
template <class Message>
class NewestMessageDisplay : public rviz::MessageFilterDisplay<Message>
{
public:
  using MessageConstPtr = typename Message::ConstPtr;

  void reset() override
  {
    Base::reset();
    waiting_.clear();
  }

  void update(float /*wall_dt*/, float /*ros_dt*/) override
  {
    const auto newest =
        std::find_if(waiting_.rbegin(), waiting_.rend(), [this](const MessageConstPtr& message) {
          return placeInFrame(message->header, *this->context_->getFrameManager(), *this->scene_node_);
        });
    if (newest == waiting_.rend()) return;
    const MessageConstPtr message = *newest;
    waiting_.erase(waiting_.begin(), newest.base());  // with those before it
    show(message);
  }

protected:
  using Base = rviz::MessageFilterDisplay<Message>;

  void onInitialize() override
  {
    Base::onInitialize();
    this->sub_.registerCallback(
        boost::function<void(const MessageConstPtr&)>([this](const MessageConstPtr& message) {
          waiting_.push_back(message);
          const auto limit = static_cast<std::size_t>(std::max(this->queue_size_property_->getInt(), 1));
          if (waiting_.size() > limit) waiting_.pop_front();
        }));
  }

  /// Draws a message; the display's scene node stands in its frame.
  virtual void show(const MessageConstPtr& message) = 0;

private:
  /// What the filter has let through has been shown by update(), or a newer message has.
  void processMessage(const MessageConstPtr& /*message*/) final {}

  std::deque<MessageConstPtr> waiting_;  ///< the newest last; all of them later than what is shown
};

}  // namespace polygonal_perception::displays
