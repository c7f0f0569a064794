// Any set of parameters: refused with a reason, or good for a frame.
#include <cmath>
#include <vector>

#include "byte_reader.hpp"
#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/perception/pipeline.hpp"
#include "polygonal_perception/ros/common/reconfigure_messages.hpp"
#include "result_check.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::test {
namespace {

struct Entry
{
  std::string name;
  parameters::Range range;
};

/// A floor with a box on it.
PlaneScene scene()
{
  PlaneScene result(64, 48, 57.0);
  result.add(floorSeenFrom(1.0, 0.4));
  result.add({-Eigen::Vector3d::UnitZ(), 2.0},
             [](const Eigen::Vector3d& p) { return std::abs(p.x()) < 0.2; });
  return result;
}

/// Sets some of the parameters, mostly within their ranges.
dynamic_reconfigure::Config anyConfig(ByteReader& bytes)
{
  std::vector<Entry> entries;
  const perception::Pipeline::Parameters defaults;
  perception::Pipeline::Parameters::describe(
      defaults, [&](const char* name, auto /*value*/, const parameters::Range& range, const auto&...) {
        entries.push_back({name, range});
      });
  dynamic_reconfigure::Config config;
  while (!bytes.empty()) {
    const std::size_t index = bytes.byte() % (entries.size() + 1);
    const Entry entry =
        index < entries.size() ? entries[index] : Entry{bytes.text(), parameters::Range{0.0, 1.0}};
    const std::uint8_t kind = bytes.byte();
    const double share = static_cast<double>(bytes.byte()) / 255.0;
    const double within = entry.range.min + share * (entry.range.max - entry.range.min);
    if (kind % 2 == 0) {
      config.doubles.emplace_back();
      config.doubles.back().name = entry.name;
      config.doubles.back().value = kind < 16 ? bytes.number<double>() : within;
    } else {
      config.ints.emplace_back();
      config.ints.back().name = entry.name;
      config.ints.back().value = kind < 16 ? bytes.raw<std::int32_t>() : static_cast<std::int32_t>(within);
    }
  }
  return config;
}

}  // namespace
}  // namespace polygonal_perception::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace polygonal_perception;
  using namespace polygonal_perception::test;
  static const PlaneScene frame = scene();
  ByteReader bytes(data, size);
  // A small grid: the default one takes most of the time, and shows nothing more.
  perception::Pipeline::Parameters parameters;
  parameters.grid.grid_length = parameters.grid.grid_width = 2.5;
  perception::Pipeline pipeline{parameters};
  const Eigen::Vector3d up(bytes.number<double>(), bytes.number<double>(), bytes.number<double>());
  if (bytes.byte() % 4 == 0) parameters.tracker.initial_up = up;
  if (!ros_common::mergeConfig(anyConfig(bytes), ros_common::listParameters(parameters)).empty()) return 0;
  if (const auto fault = parameters::findFault(parameters)) {
    require(!fault->reason.empty() && !fault->names.empty(), "what is refused has a reason");
    return 0;
  }
  // Larger ones are no different, and slow.
  constexpr std::size_t kMostCells = 5000;
  constexpr int kMostSamples = 3000;
  if (occupancy::GridGeometry(parameters.grid).size() > kMostCells) return 0;
  if (parameters.samples.samples_x * parameters.samples.samples_y > kMostSamples) return 0;
  pipeline.process({frame.view(), 0.0, {}}, kAllProducts);
  pipeline.configure(parameters);
  requireSound(pipeline.process({frame.view(), 0.03, {}}, kAllProducts), parameters.detector);
  pipeline.reset();
  requireSound(pipeline.process({frame.view(), 0.06, {}}, kAllProducts), parameters.detector);
  return 0;
}
