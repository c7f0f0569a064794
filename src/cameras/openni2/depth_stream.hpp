#pragma once

#include <OpenNI.h>

#include <chrono>
#include <functional>
#include <string>

#include "polygonal_perception/cameras/openni2/openni2_source.hpp"

namespace polygonal_perception::openni2 {

/// An opened device and its depth stream. Errors are texts; empty = none.
class DepthStream
{
public:
  enum class Read
  {
    kFrame,
    kNothing,  ///< in that time
    kEnd,      ///< of a recording that is not to begin again; its thread still plays until stop()
    kFailed
  };

  /// Finds and opens the device, and sets its mode.
  /// @return why it could not
  std::string open(const SourceOptions& options);
  void close();

  bool isFile() const { return device_.isFile(); }
  const std::string& uri() const { return uri_; }
  /// What was opened and in which mode.
  std::string description() const;

  /// @return why it could not
  std::string start();
  void stop();

  /// Waits for a frame, and hands it over.
  Read read(std::chrono::milliseconds timeout, const std::function<void(const DepthFrame&)>& on_frame);

private:
  std::string configure(const SourceOptions& options);
  std::string setMode(const SourceOptions& options);
  void setIntrinsics(DepthFrame& frame) const;

  std::string uri_;
  std::string serial_;
  bool registered_ = false;
  bool loop_ = true;
  int last_index_ = -1;  // of the frames of a recording
  // In this order: the stream goes before its device.
  openni::Device device_;
  openni::VideoStream stream_;
  openni::VideoStream color_;  // with registration, for its field of view; it never runs
  openni::VideoFrameRef frame_;
};

}  // namespace polygonal_perception::openni2
