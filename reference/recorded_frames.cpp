#include "reference/recorded_frames.hpp"

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

namespace polygonal_perception::reference {

namespace {

using boost::property_tree::ptree;

std::optional<geometry::Plane> readFloor(const ptree& entry, bool& known)
{
  const auto floor = entry.get_child_optional("floor");
  known = floor && floor->data() != "unknown";
  if (!floor || floor->empty()) return std::nullopt;
  geometry::Plane plane;
  int k = 0;
  for (const auto& component : floor->get_child("n"))
    plane.normal[k++] = component.second.get_value<double>();
  plane.normal.normalize();
  plane.distance = floor->get<double>("d");
  return plane;
}

}  // namespace

std::optional<std::string> findRecordedFrames()
{
  const char* const folder = std::getenv("POLYGONAL_PERCEPTION_DATA");
  if (folder == nullptr) return std::nullopt;
  const std::string path = std::string(folder) + "/frames.json";
  if (!std::ifstream(path)) return std::nullopt;
  return path;
}

std::vector<RecordedFrame> listRecordedFrames(const std::string& frames_json)
{
  ptree list;
  boost::property_tree::read_json(frames_json, list);
  const std::string folder = frames_json.substr(0, frames_json.find_last_of('/') + 1);
  std::vector<RecordedFrame> frames;
  for (const auto& [unused, entry] : list) {
    RecordedFrame frame;
    frame.name = entry.get<std::string>("depth");
    frame.set = frame.name.substr(0, frame.name.find('/'));
    frame.path = folder + frame.name;
    frame.fx = entry.get<double>("fx");
    frame.fy = entry.get<double>("fy");
    frame.cx = entry.get<double>("cx");
    frame.cy = entry.get<double>("cy");
    frame.units_per_metre = entry.get<double>("units_per_m");
    frame.floor = readFloor(entry, frame.reference_known);
    frames.push_back(frame);
  }
  return frames;
}

LoadedFrame load(const RecordedFrame& frame)
{
  constexpr float kFarthest = 8.0F;  // [m]
  const cv::Mat raw = cv::imread(frame.path, cv::IMREAD_UNCHANGED);
  if (raw.empty() || raw.type() != CV_16UC1) {
    throw std::runtime_error("cannot read " + frame.path + " as a 16-bit depth image");
  }
  LoadedFrame loaded;
  raw.convertTo(loaded.depth, CV_32F, 1.0 / frame.units_per_metre);
  loaded.depth.setTo(0.0F, loaded.depth > kFarthest);
  loaded.rays = perception::PinholeRays::make(static_cast<std::uint32_t>(raw.cols),
                                              static_cast<std::uint32_t>(raw.rows), frame.fx, frame.fy,
                                              frame.cx, frame.cy);
  return loaded;
}

}  // namespace polygonal_perception::reference
