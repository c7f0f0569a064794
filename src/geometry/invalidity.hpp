#pragma once

#include <cstddef>
#include <sstream>
#include <string>

#include "polygonal_perception/geometry/validity.hpp"

namespace polygonal_perception::geometry {

/// @param what  what is wrong with the ring, as its text goes on after "ring 3 "
inline Invalidity invalidity(Defect defect, std::size_t ring, const Eigen::Vector2d& place,
                             const std::string& what)
{
  std::ostringstream text;
  text << "ring " << ring << ' ' << what << " at (" << place.x() << ", " << place.y() << ")";
  return {defect, static_cast<std::uint32_t>(ring), place, text.str()};
}

}  // namespace polygonal_perception::geometry
