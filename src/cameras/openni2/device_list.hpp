#pragma once

#include <OpenNI.h>

#include <string>

namespace polygonal_perception::openni2 {

/// The URI for a device's name as SourceOptions has it, or why there is none.
struct DeviceChoice
{
  std::string uri;    ///< empty: none
  std::string error;  ///< with the devices that were seen
};

/// Of a device that is open; empty where it tells none.
std::string serialNumber(openni::Device& device);

DeviceChoice chooseDevice(const std::string& device_id);

}  // namespace polygonal_perception::openni2
