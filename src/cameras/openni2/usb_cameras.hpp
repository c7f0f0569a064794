#pragma once

#include <string>

namespace polygonal_perception::openni2 {

/// What the system knows of OpenNI2 cameras on its USB ports, when OpenNI itself finds none: that there is
/// none, or that there is one which this user may not open, and the cure.
/// @param sys  the folder with an entry for each USB device
/// @param dev  the folder with the devices' nodes
std::string describeUsbCameras(const std::string& sys = "/sys/bus/usb/devices",
                               const std::string& dev = "/dev/bus/usb");

}  // namespace polygonal_perception::openni2
