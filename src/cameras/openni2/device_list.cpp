#include "cameras/openni2/device_list.hpp"

#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

#include "cameras/openni2/usb_cameras.hpp"

namespace polygonal_perception::openni2 {
namespace {

std::vector<std::string> connectedDevices()
{
  openni::Array<openni::DeviceInfo> devices;
  openni::OpenNI::enumerateDevices(&devices);
  std::vector<std::string> uris;
  uris.reserve(static_cast<std::size_t>(devices.getSize()));
  for (int i = 0; i < devices.getSize(); ++i) uris.emplace_back(devices[i].getUri());
  return uris;
}

/// The bus in a URI such as 1d27/0601@3/18.
std::string busOf(const std::string& uri)
{
  const auto at = uri.find('@');
  const auto slash = uri.find('/', at == std::string::npos ? uri.size() : at);
  return slash == std::string::npos ? std::string() : uri.substr(at + 1, slash - at - 1);
}

std::string nth(const std::vector<std::string>& uris, const std::string& number)
{
  char* end = nullptr;
  const unsigned long n = std::strtoul(number.c_str(), &end, 10);
  return *end == '\0' && n >= 1 && n <= uris.size() ? uris[n - 1] : std::string();
}

/// The device of a serial number, for which each has to be opened.
std::string withSerial(const std::string& serial, const std::vector<std::string>& uris)
{
  for (const std::string& uri : uris) {
    openni::Device device;
    if (device.open(uri.c_str()) != openni::STATUS_OK) continue;
    const bool is_it = serialNumber(device) == serial;
    device.close();
    if (is_it) return uri;
  }
  return {};
}

/// "n" of "bus@n": as openni2_camera has it the device's number in its URI, 0 for any; or its place on the
/// bus.
std::string onBus(const std::string& bus, const std::string& number, const std::vector<std::string>& uris)
{
  std::vector<std::string> on_bus;
  for (const std::string& uri : uris) {
    if (busOf(uri) != bus) continue;
    if (uri.substr(uri.rfind('/') + 1) == number) return uri;
    on_bus.push_back(uri);
  }
  return nth(on_bus, number == "0" ? "1" : number);
}

/// The only one that has this in its URI.
std::string containing(const std::string& part, const std::vector<std::string>& uris)
{
  std::string found;
  for (const std::string& uri : uris) {
    if (uri.find(part) == std::string::npos) continue;
    if (!found.empty()) return {};
    found = uri;
  }
  return found;
}

std::string matching(const std::string& device_id, const std::vector<std::string>& uris)
{
  if (device_id.empty()) return nth(uris, "1");
  if (device_id[0] == '#') return nth(uris, device_id.substr(1));
  for (const std::string& uri : uris) {
    if (uri == device_id) return uri;
  }
  const auto at = device_id.find('@');
  const bool has_slash = device_id.find('/') != std::string::npos;
  if (at != std::string::npos && !has_slash)
    return onBus(device_id.substr(0, at), device_id.substr(at + 1), uris);
  const std::string of_serial = has_slash ? std::string() : withSerial(device_id, uris);
  return of_serial.empty() ? containing(device_id, uris) : of_serial;
}

}  // namespace

std::string serialNumber(openni::Device& device)
{
  char serial[ONI_MAX_STR] = "";
  int size = sizeof serial;
  if (device.getProperty(ONI_DEVICE_PROPERTY_SERIAL_NUMBER, serial, &size) != openni::STATUS_OK) return {};
  serial[sizeof serial - 1] = '\0';
  return serial;
}

DeviceChoice chooseDevice(const std::string& device_id)
{
  std::error_code ignored;
  if (std::filesystem::is_regular_file(device_id, ignored)) return {device_id, {}};
  const std::vector<std::string> uris = connectedDevices();
  const std::string uri = matching(device_id, uris);
  if (!uri.empty()) return {uri, {}};
  std::string error = "there is no OpenNI2 device '" + device_id + "'; ";
  if (uris.empty()) return {{}, error + "OpenNI2 sees none at all: " + describeUsbCameras()};
  error += "OpenNI2 sees";
  for (const std::string& seen : uris) error += " " + seen;
  return {{}, error};
}

}  // namespace polygonal_perception::openni2
