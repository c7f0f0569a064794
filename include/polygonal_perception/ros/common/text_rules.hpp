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

/// What the texts of several nodes may be.
inline const parameters::TextRule kFrame{"a frame", isFrame};
inline const parameters::TextRule kFrameOrEmpty{"a frame or empty", isFrameOrEmpty};
inline const parameters::TextRule kUrlOrEmpty{"a URL or empty", isAnyText};

}  // namespace polygonal_perception::ros_common
