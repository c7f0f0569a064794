#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include "polygonal_perception/perception/pipeline.hpp"

namespace polygonal_perception::test {

/// The pipeline's numbers in a file of config/, which has one `name: value` a line.
inline perception::Pipeline::Parameters shippedParameters(const std::string& path)
{
  std::map<std::string, double> values;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string name;
    double value = 0.0;
    if (words >> name >> value) values[name.substr(0, name.find(':'))] = value;
  }
  if (values.empty()) throw std::runtime_error("no parameters in " + path);
  perception::Pipeline::Parameters parameters;
  perception::Pipeline::Parameters::describe(
      parameters, [&values](const char* name, auto& parameter, const auto& /*range*/, const char* /*unit*/,
                            const char* /*help*/) {
        const auto entry = values.find(name);
        if (entry != values.end()) parameter = static_cast<std::decay_t<decltype(parameter)>>(entry->second);
      });
  return parameters;
}

}  // namespace polygonal_perception::test
