#include "polygonal_perception/ros/common/published_type.hpp"

#include <ros/master.h>
#include <ros/this_node.h>

namespace polygonal_perception::ros_common {

std::string publishedType(const std::string& topic)
{
  // ros::master::getTopics() waits for a roscore that is gone.
  constexpr bool kWaitForMaster = false;
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue topics;
  request[0] = ros::this_node::getName();
  request[1] = "";
  if (!ros::master::execute("getPublishedTopics", request, response, topics, kWaitForMaster)) return {};
  for (int k = 0; k < topics.size(); ++k) {
    if (static_cast<std::string>(topics[k][0]) == topic) return topics[k][1];
  }
  return {};
}

}  // namespace polygonal_perception::ros_common
