#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>

#include <string>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/perception/pipeline.hpp"

namespace polygonal_perception::ros_common {

/// The values of the pipeline's parameters as dynamic_reconfigure sends them.
POLYGONAL_PERCEPTION_EXPORT dynamic_reconfigure::Config toConfig(
    const perception::Pipeline::Parameters& parameters);

/// Names, types, ranges, defaults and help of the pipeline's parameters.
POLYGONAL_PERCEPTION_EXPORT dynamic_reconfigure::ConfigDescription describeConfig();

/// Takes over the values that a client sent.
/// @return what is wrong with a name or a type, or nothing; ranges are not looked at
POLYGONAL_PERCEPTION_EXPORT std::string mergeConfig(const dynamic_reconfigure::Config& config,
                                                    perception::Pipeline::Parameters& parameters);

}  // namespace polygonal_perception::ros_common
