#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace polygonal_perception::test {

/// A folder that goes with its object.
class TemporaryFolder
{
public:
  TemporaryFolder() : folder_((std::filesystem::temp_directory_path() / "test-XXXXXX").string())
  {
    if (mkdtemp(folder_.data()) == nullptr) throw std::runtime_error("no folder " + folder_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(folder_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  /// Of a file in it.
  std::string path(const std::string& name) const { return folder_ + "/" + name; }

  /// What is in it.
  std::vector<std::string> names() const
  {
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      result.push_back(entry.path().filename().string());
    return result;
  }

private:
  std::string folder_;
};

}  // namespace polygonal_perception::test
