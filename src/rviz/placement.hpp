#pragma once

#include <std_msgs/Header.h>

namespace rviz {
class Display;
class DisplayContext;
}  // namespace rviz

namespace polygonal_perception {

/// Puts a display's scene node where a message's frame is, seen from rviz's fixed frame at the message's
/// stamp, and tells in the display's status if nobody knows.
///
/// @return whether it is known; if not, nothing has moved
bool placeInFrame(const std_msgs::Header& header, rviz::DisplayContext& context, rviz::Display& display);

}  // namespace polygonal_perception
