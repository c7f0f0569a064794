#pragma once

#include <string>

#include "polygonal_perception/parameters/parameter_table.hpp"

namespace polygonal_perception::ros_common {

inline bool isAnyText(const std::string& /*text*/)
{
  return true;
}
/// tf2 knows no frame with a leading slash.
inline bool isFrame(const std::string& text)
{
  return !text.empty() && text.front() != '/';
}
inline bool isFrameOrEmpty(const std::string& text)
{
  return text.empty() || isFrame(text);
}

/// What is wrong with the frame_id of a message, or empty.
inline std::string frameIdError(const std::string& frame_id)
{
  if (frame_id.empty()) return "header.frame_id is empty, accepted is the name of a tf frame";
  if (isFrame(frame_id)) return {};
  return "header.frame_id is '" + frame_id +
         "', accepted is a name without a leading slash (tf2 knows none with one)";
}

/// What the texts of several nodes may be.
inline const parameters::TextRule kFrame{"a frame", isFrame};
inline const parameters::TextRule kFrameOrEmpty{"a frame or empty", isFrameOrEmpty};
inline const parameters::TextRule kUrlOrEmpty{"a URL or empty", isAnyText};

}  // namespace polygonal_perception::ros_common
