#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>

#include <string>

#include "polygonal_perception/pipeline.hpp"

namespace polygonal_perception {

/// The values of the pipeline's parameters as dynamic_reconfigure sends them.
dynamic_reconfigure::Config toConfig(const Pipeline::Parameters& parameters);

/// Names, types, ranges, defaults and help of the pipeline's parameters.
dynamic_reconfigure::ConfigDescription describeConfig();

/// Takes over the values that a client sent.
/// @return what is wrong with a name or a type, or nothing; ranges are not looked at
std::string mergeConfig(const dynamic_reconfigure::Config& config, Pipeline::Parameters& parameters);

}  // namespace polygonal_perception
