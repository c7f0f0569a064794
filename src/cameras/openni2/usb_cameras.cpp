#include "cameras/openni2/usb_cameras.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <system_error>

namespace polygonal_perception::openni2 {
namespace {

// PrimeSense, whose chips ASUS uses, and Orbbec.
constexpr const char* kVendors[] = {"1d27", "2bc5"};

std::string attribute(const std::filesystem::path& device, const char* name)
{
  std::string value;
  std::ifstream(device / name) >> value;
  return value;
}

std::string nodeOf(const std::filesystem::path& device, const std::string& dev)
{
  const std::string bus = attribute(device, "busnum");
  const std::string number = attribute(device, "devnum");
  const auto padded = [](const std::string& text) {
    return std::string(text.size() < 3 ? 3 - text.size() : 0, '0') + text;
  };
  return dev + "/" + padded(bus) + "/" + padded(number);
}

}  // namespace

std::string describeUsbCameras(const std::string& sys, const std::string& dev)
{
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(sys, error)) {
    const std::string vendor = attribute(entry.path(), "idVendor");
    for (const char* known : kVendors) {
      if (vendor != known) continue;
      const std::string node = nodeOf(entry.path(), dev);
      std::string name = "USB device " + vendor + ":";
      name.append(attribute(entry.path(), "idProduct")).append(" at ").append(node);
      if (access(node.c_str(), R_OK | W_OK) != 0) {
        return name +
               " may not be opened by this user: install the udev rules of libopenni2-0, or a rule of one's "
               "own for that vendor with MODE=\"0666\", and plug it in again";
      }
      return name +
             " is there and may be opened, but no driver of OpenNI2 takes it; another program may hold it";
    }
  }
  return "no camera of PrimeSense, ASUS or Orbbec is plugged in";
}

}  // namespace polygonal_perception::openni2
