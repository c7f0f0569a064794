#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "polygonal_perception/mapping/map_file.hpp"

namespace polygonal_perception::mapping {

/// "cannot write PATH: REASON", and the same with "read".
MapFileError writeFailure(const std::string& path, const std::string& reason);
MapFileError readFailure(const std::string& path, const std::string& reason);

/// A file that is written beside its place, and takes it when it is complete: who reads it finds the old one
/// or the new one, whatever happens in between.
class PendingFile
{
public:
  explicit PendingFile(std::string path) : path_(std::move(path)) {}
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// Removes it where it has not taken its place.
  ~PendingFile();

  /// @return nothing when it is on the disc, else the reason and the path
  std::optional<MapFileError> write(const std::string& contents);

  /// @return nothing when it is in its place, else the reason and the path
  std::optional<MapFileError> takePlace();

private:
  std::string path_;
  std::string beside_;  // where it is until then; empty when it is not
};

/// Writes one file: whole, or not at all.
std::optional<MapFileError> writeWhole(const std::string& path, const std::string& contents);

/// @return the contents, or the path and the reason; no directory and no device has any
std::variant<std::string, MapFileError> readWhole(const std::string& path, std::size_t most_bytes);

}  // namespace polygonal_perception::mapping
