#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>

#include <string>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/ros/common/parameter_list.hpp"

namespace polygonal_perception::ros_common {

/// The values of the parameters that can be reconfigured, as dynamic_reconfigure sends them.
POLYGONAL_PERCEPTION_EXPORT dynamic_reconfigure::Config toConfig(const ParameterList& parameters);

/// Names, types, ranges, defaults and help of the parameters that can be reconfigured.
POLYGONAL_PERCEPTION_EXPORT dynamic_reconfigure::ConfigDescription describeConfig(
    const ParameterList& defaults);

/// Takes the values that a client sent over into the struct that the list points to.
/// @return what is wrong with a name or a type, or nothing; ranges are not looked at
POLYGONAL_PERCEPTION_EXPORT std::string mergeConfig(const dynamic_reconfigure::Config& config,
                                                    const ParameterList& parameters);

}  // namespace polygonal_perception::ros_common
