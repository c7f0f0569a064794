#pragma once

#include <string>

#include "polygonal_perception/export.hpp"

namespace polygonal_perception::ros_common {

/// The type under which a topic is published now, as roscore knows it; empty where nobody publishes it or roscore does not
/// answer.
/// @param topic  resolved
POLYGONAL_PERCEPTION_EXPORT std::string publishedType(const std::string& topic);

}  // namespace polygonal_perception::ros_common
