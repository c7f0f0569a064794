#include "polygonal_perception/perception/parameter_check.hpp"

#include <sstream>

namespace polygonal_perception::perception {

namespace {

/// Beyond this a frame would take seconds and hundreds of megabytes.
constexpr double kMostCells = 4e6;

struct FindOutOfRange
{
  std::optional<ParameterFault> fault;

  template <class T>
  void operator()(const char* name, const T& value, const parameters::Range& range, const char* unit,
                  const char* /*help*/)
  {
    const auto number = static_cast<double>(value);
    // Written so that NaN fails.
    if (fault || (number >= range.min && number <= range.max)) return;
    fault = ParameterFault{
        {name}, std::string(name) + " is " + numberText(number) + ", accepted is " + rangeText(range, unit)};
  }
};

std::optional<ParameterFault> findDisorder(const char* lower_name, double lower, const char* upper_name,
                                           double upper)
{
  if (lower < upper) return std::nullopt;
  return ParameterFault{{lower_name, upper_name},
                        std::string(lower_name) + " is " + numberText(lower) + " and " + upper_name + " is " +
                            numberText(upper) + ", accepted is " + lower_name + " < " + upper_name};
}

}  // namespace

std::string numberText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string rangeText(const parameters::Range& range, const std::string& unit)
{
  return numberText(range.min) + " to " + numberText(range.max) + (unit.empty() ? "" : " " + unit);
}

std::optional<ParameterFault> findFault(const Pipeline::Parameters& parameters)
{
  FindOutOfRange check;
  Pipeline::Parameters::describe(parameters, check);
  if (check.fault) return check.fault;

  const auto& projection = parameters.projection;
  if (auto fault = findDisorder("min_height", projection.min_height, "max_height", projection.max_height))
    return fault;
  const auto& detector = parameters.detector;
  if (auto fault = findDisorder("min_camera_height", detector.min_camera_height, "max_camera_height",
                                detector.max_camera_height)) {
    return fault;
  }
  const GridParameters& grid = parameters.grid;
  const double cells = grid.grid_length / grid.grid_resolution * (grid.grid_width / grid.grid_resolution);
  if (cells > kMostCells) {
    return ParameterFault{{"grid_length", "grid_width", "grid_resolution"},
                          "grid_length " + numberText(grid.grid_length) + " and grid_width " +
                              numberText(grid.grid_width) + " at grid_resolution " +
                              numberText(grid.grid_resolution) + " make " + numberText(cells) +
                              " cells, accepted are at most " + numberText(kMostCells)};
  }
  if (!(parameters.tracker.initial_up.norm() > 0.0)) {
    return ParameterFault{{"initial_up"}, "initial_up is a zero vector, accepted is any other direction"};
  }
  return std::nullopt;
}

}  // namespace polygonal_perception::perception
