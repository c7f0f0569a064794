#include "placement.hpp"

#include <OgreSceneNode.h>
#include <rviz/display.h>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>

#include <string>

namespace polygonal_perception {

bool placeInFrame(const std_msgs::Header& header, rviz::DisplayContext& context, rviz::Display& display)
{
  rviz::FrameManager& frames = *context.getFrameManager();
  Ogre::Vector3 position;
  Ogre::Quaternion orientation;
  if (!frames.getTransform(header, position, orientation)) {
    std::string reason;
    if (!frames.transformHasProblems(header.frame_id, header.stamp, reason)) reason = "unknown reason";
    display.setStatusStd(
        rviz::StatusProperty::Error, "Transform",
        "No transform from [" + header.frame_id + "] to [" + frames.getFixedFrame() + "]: " + reason);
    return false;
  }
  display.setStatus(rviz::StatusProperty::Ok, "Transform", "OK");
  display.getSceneNode()->setPosition(position);
  display.getSceneNode()->setOrientation(orientation);
  return true;
}

}  // namespace polygonal_perception
