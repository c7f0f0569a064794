#include "rviz/placement.hpp"

#include <OgreSceneNode.h>
#include <rviz/frame_manager.h>

namespace polygonal_perception::displays {

bool placeInFrame(const std_msgs::Header& header, rviz::FrameManager& frames, Ogre::SceneNode& node)
{
  Ogre::Vector3 position;
  Ogre::Quaternion orientation;
  if (!frames.getTransform(header, position, orientation)) return false;
  node.setPosition(position);
  node.setOrientation(orientation);
  return true;
}

}  // namespace polygonal_perception::displays
