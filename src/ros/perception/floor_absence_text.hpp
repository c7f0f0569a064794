#pragma once

#include <string>

#include "polygonal_perception/perception/floor/floor_absence.hpp"

namespace polygonal_perception::ros_perception {

/// Tells a user why there is no floor, and which parameter says otherwise.
std::string absenceText(const perception::FloorAbsence& absence);

}  // namespace polygonal_perception::ros_perception
