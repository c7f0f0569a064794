#pragma once

#include <nodelet/nodelet.h>
#include <ros/ros.h>

#include <exception>
#include <memory>
#include <string>

namespace polygonal_perception::ros_common {

/// A node class in a nodelet manager, best the one whose nodelets publish what it reads: messages are then
/// read where they lie.
///
/// @tparam Node  made of a handle and a private handle; it may throw when it cannot start
template <class Node>
class NodeletOf : public nodelet::Nodelet
{
private:
  void onInit() override
  {
    // An exception from here would take the manager down, and with it the camera's driver.
    try {
      node_ = std::make_unique<Node>(getNodeHandle(), getPrivateNodeHandle());
    } catch (const std::exception& error) {
      NODELET_ERROR("could not start: %s", error.what());
    } catch (...) {
      NODELET_ERROR("could not start, for an unknown reason");
    }
  }

  std::unique_ptr<Node> node_;
};

/// The same class as a program: runs until it is told to end.
/// @return the program's exit code
template <class Node>
int runNode(int argc, char** argv, const std::string& name)
{
  ros::init(argc, argv, name);
  // They outlive the node: with the last of them the console goes, and with it the message below.
  const ros::NodeHandle handle;
  const ros::NodeHandle private_handle("~");
  try {
    const Node node(handle, private_handle);
    ros::spin();
  } catch (const std::exception& error) {
    ROS_FATAL("%s has failed: %s", name.c_str(), error.what());
    return 1;
  } catch (...) {
    ROS_FATAL("%s has failed, for an unknown reason", name.c_str());
    return 1;
  }
  return 0;
}

}  // namespace polygonal_perception::ros_common
