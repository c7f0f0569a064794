// ObservedCells of any content, of several sources, one after another: each is refused with a reason, or taken into a
// map whose polygons are simple and safe.
#include "byte_reader.hpp"
#include "map_check.hpp"
#include "result_check.hpp"
#include "ros/mapping/map_intake.hpp"

namespace polygonal_perception::test {
namespace {

constexpr std::size_t kSources = 3;
constexpr int kMostFrames = 20;

/// Lengths of sides of which some are no side of a cell.
constexpr float kResolutions[] = {0.05F, 0.1F, 0.025F, 0.07F, 1.0F, 0.001F, 10.0F};

/// A place within some metres mostly.
double place(ByteReader& bytes)
{
  return bytes.byte() < 250 ? 0.02 * bytes.raw<std::int8_t>() : bytes.number<double>();
}

/// Turns about z mostly.
Eigen::Quaterniond turn(ByteReader& bytes)
{
  const std::uint8_t kind = bytes.byte();
  if (kind < 240) return Eigen::Quaterniond(Eigen::AngleAxisd(kind / 38.2, Eigen::Vector3d::UnitZ()));
  const double w = bytes.number<double>(), x = bytes.number<double>(), y = bytes.number<double>();
  return {w, x, y, bytes.number<double>()};
}

std::vector<std::uint8_t> layer(ByteReader& bytes, std::size_t size)
{
  const std::uint8_t kind = bytes.byte();
  if (kind >= 250) return std::vector<std::uint8_t>(bytes.byte(), kind);
  const std::uint8_t filling = kind % 4 == 0 ? 0 : kind % 4 == 1 ? 0xFF : kind;
  std::vector<std::uint8_t> cells(size, filling);
  // Some of them by name.
  for (int k = bytes.byte() % 32; k > 0 && size > 0; --k)
    cells[bytes.raw<std::uint16_t>() % size] = bytes.byte();
  cells.shrink_to_fit();
  return cells;
}

ObservedCells anyCells(ByteReader& bytes, float resolution)
{
  ObservedCells cells;
  cells.header.frame_id = bytes.byte() < 250 ? "floor" : bytes.text();
  cells.floor_status = bytes.byte() % 4;
  cells.info.width = bytes.size() % 32;
  cells.info.height = bytes.byte() < 250 ? bytes.byte() % 32 : bytes.size();
  cells.info.resolution = bytes.byte() < 250 ? resolution : bytes.number<float>();
  cells.slab_height = bytes.byte() < 250 ? 0.1F : bytes.number<float>();
  cells.info.origin.position.x = place(bytes);
  cells.info.origin.position.y = place(bytes);
  const Eigen::Quaterniond rotation = turn(bytes);
  cells.info.origin.orientation.w = rotation.w();
  cells.info.origin.orientation.x = rotation.x();
  cells.info.origin.orientation.y = rotation.y();
  cells.info.origin.orientation.z = rotation.z();
  constexpr std::size_t kMostCells = 64 * 64;
  const std::size_t size = std::size_t{cells.info.width} * cells.info.height;
  cells.hit = layer(bytes, size > kMostCells ? 1 : size);
  cells.free = layer(bytes, size > kMostCells ? 1 : size);
  cells.floor = layer(bytes, size > kMostCells ? 1 : size);
  return cells;
}

/// A transform as ros_common::TfBridge gives it: of any numbers that are finite.
Eigen::Isometry3d anyTransform(ByteReader& bytes)
{
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  transform.linear() = turn(bytes).normalized().toRotationMatrix();
  transform.translation() << place(bytes), place(bytes), 0.0;
  return transform.matrix().allFinite() ? transform : Eigen::Isometry3d::Identity();
}

/// Sets of parameters that a client may send, as far as they keep the map small.
void anyParameters(ByteReader& bytes, double resolution, mapping::PolygonMap::Parameters& parameters)
{
  parameters.map.map_size = (1 + bytes.byte() % 20) * resolution;
  parameters.map.clear_views = 1 + bytes.byte() % 4;
  parameters.map.remember = bytes.byte() % 4 == 0 ? 0.1 * (1 + bytes.byte()) : 1.0 / 0.0;
}

}  // namespace
}  // namespace polygonal_perception::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace polygonal_perception;
  using namespace polygonal_perception::test;
  ByteReader bytes(data, size);
  const float resolution = kResolutions[bytes.byte() % std::size(kResolutions)];
  mapping::PolygonMap::Parameters parameters;
  anyParameters(bytes, resolution, parameters);
  ros_mapping::MapIntake intake(parameters, {"front", "rear", "side"});
  MapLengths lengths;
  double stamp = 100.0;
  for (int k = 0; k < kMostFrames && !bytes.empty(); ++k) {
    if (bytes.byte() % 8 == 0) anyParameters(bytes, resolution, parameters);
    if (bytes.byte() % 32 == 0) intake.clear();
    lengths.radius = bytes.raw<std::uint16_t>() % 3001;
    lengths.tolerance = bytes.raw<std::uint16_t>() % 2001;
    const std::size_t source = bytes.byte() % kSources;
    ObservedCells cells = anyCells(bytes, resolution);
    const std::uint8_t step = bytes.byte();
    stamp += step < 250 ? 0.01 * (step - 5) : bytes.raw<std::int8_t>();
    cells.header.stamp =
        step == 255 ? ros::Time(bytes.raw<std::uint32_t>(), 0) : ros::Time(std::max(0.0, stamp));

    const auto admission = intake.admit(source, cells);
    require((admission.fault == nullptr) == admission.reason.empty(), "what is refused has a reason");
    ros_mapping::MapIntake::Placement placement{std::nullopt, anyTransform(bytes)};
    if (bytes.byte() % 4 != 0) placement.grid_to_fixed = anyTransform(bytes);
    if (admission.fault != nullptr || !placement.isNear()) continue;
    // Larger maps and radii are no different, and slow to check.
    constexpr double kMostCells = 20.0;
    mapping::PolygonMap& map = intake.map();
    const double map_resolution =
        map.map().isActive() ? map.map().geometry().resolution : cells.info.resolution;
    parameters.map.map_size = std::min(parameters.map.map_size, kMostCells * map_resolution);
    lengths.setIn(parameters, map_resolution);
    intake.configure(parameters);
    intake.take(source, cells, placement, 0.3);
    lengths.setIn(parameters, map.map().geometry().resolution);  // a message has it in single precision
    intake.configure(parameters);
    mapping::PolygonMap::Products all;
    all.seen = all.polygons = true;
    const mapping::PolygonMap::Result& result = map.make(all);
    requireSound(result);
    if (bytes.empty()) requireSafe(result, lengths);
  }
  return 0;
}
