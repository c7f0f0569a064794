#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/geometry/plane.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::reference {

/// A recorded depth image with its reference floor, as a frames.json lists it: an array of
/// {"depth": path, "fx", "fy", "cx", "cy", "units_per_m", "floor": {"n": [..], "d"} | null | "unknown"}.
struct RecordedFrame
{
  std::string set;   ///< the folder that it belongs to
  std::string name;  ///< its path below the folder of the frames.json
  std::string path;
  double fx = 0, fy = 0, cx = 0, cy = 0;
  double units_per_metre = 1000.0;
  bool reference_known = true;           ///< false: nobody can say whether and where a floor is in view
  std::optional<geometry::Plane> floor;  ///< none: no floor is in view
};

/// A recorded frame in memory.
struct LoadedFrame
{
  cv::Mat1f depth;  ///< [m], 0 = no return
  perception::PinholeRays rays;

  perception::PointView view() const
  {
    return perception::PointView::depth(depth.ptr<float>(), depth.step, rays);
  }
};

/// @return the path of the frames.json in the folder POLYGONAL_PERCEPTION_DATA; nothing where that is not set
///         or has none
std::optional<std::string> findRecordedFrames();

/// @throws std::runtime_error that says what cannot be read
std::vector<RecordedFrame> listRecordedFrames(const std::string& frames_json);

/// Reads the image; depth beyond 8 m, which no camera of the kind measures, becomes no return.
/// @throws std::runtime_error that says what cannot be read
LoadedFrame load(const RecordedFrame& frame);

}  // namespace polygonal_perception::reference
