#pragma once

#include <cstdio>
#include <string>

namespace polygonal_perception::ros_perception {

/// As snprintf, for texts that are at most 400 characters long.
template <class... Values>
std::string printed(const char* format, Values... values)
{
  char text[400];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace polygonal_perception::ros_perception
