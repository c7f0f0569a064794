#pragma once

#include <std_msgs/Header.h>

namespace Ogre {
class SceneNode;
}
namespace rviz {
class FrameManager;
}

namespace polygonal_perception::displays {

/// Puts a scene node where a message's frame is, seen from rviz's fixed frame at the message's stamp.
///
/// @return whether that is known; if not, nothing has moved
bool placeInFrame(const std_msgs::Header& header, rviz::FrameManager& frames, Ogre::SceneNode& node);

}  // namespace polygonal_perception::displays
