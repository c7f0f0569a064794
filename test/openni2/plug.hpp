#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "virtual_driver/virtual_camera.hpp"

namespace polygonal_perception::virtual_device {

/// The virtual device's plug, put in and pulled by the test.
class Plug
{
public:
  explicit Plug(std::string path) : path_(std::move(path)) {}
  ~Plug() { pull(); }
  Plug(const Plug&) = delete;
  Plug& operator=(const Plug&) = delete;

  void putIn() const { std::ofstream(path_) << "in"; }
  void pull() const
  {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

private:
  std::string path_;
};

}  // namespace polygonal_perception::virtual_device
