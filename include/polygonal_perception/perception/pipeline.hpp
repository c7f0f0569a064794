#pragma once

#include <Eigen/Geometry>
#include <chrono>
#include <optional>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"
#include "polygonal_perception/perception/floor/floor_detector.hpp"
#include "polygonal_perception/perception/floor/floor_tracker.hpp"
#include "polygonal_perception/perception/floor/sample_grid.hpp"
#include "polygonal_perception/perception/grid/binary_grid.hpp"
#include "polygonal_perception/perception/grid/drop_offs.hpp"
#include "polygonal_perception/perception/grid/inflation.hpp"
#include "polygonal_perception/perception/grid/projection.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"
#include "polygonal_perception/perception/polygons/polygonizer.hpp"

namespace polygonal_perception::perception {

/// A frame and what its publisher knows about it.
struct Frame
{
  PointView points;
  double stamp = 0.0;                         ///< [s]
  std::optional<Eigen::Vector3d> up_from_tf;  ///< in the input's frame
};

/// How long each stage of a frame took; a stage that was left out took nothing.
struct StageTimes
{
  using Duration = std::chrono::nanoseconds;
  Duration samples{0};
  Duration floor{0};
  Duration projection{0};
  Duration inflation{0};
  Duration polygons{0};

  Duration total() const { return samples + floor + projection + inflation + polygons; }
};

/// The way of a frame, from points to polygons.
class POLYGONAL_PERCEPTION_EXPORT Pipeline
{
public:
  struct Parameters
  {
    SampleGrid::Parameters samples;
    FloorTracker::Parameters tracker;
    FloorDetector::Parameters detector;
    GridParameters grid;
    Projection::Parameters projection;
    DropOffs::Parameters drop_offs;
    Inflation::Parameters inflation;
    Polygonizer::Parameters polygonizer;

    /// Visits the parameters of every stage.
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      SampleGrid::Parameters::describe(self.samples, visit);
      FloorTracker::Parameters::describe(self.tracker, visit);
      FloorDetector::Parameters::describe(self.detector, visit);
      GridParameters::describe(self.grid, visit);
      Projection::Parameters::describe(self.projection, visit);
      DropOffs::Parameters::describe(self.drop_offs, visit);
      Inflation::Parameters::describe(self.inflation, visit);
      Polygonizer::Parameters::describe(self.polygonizer, visit);
    }
  };

  /// How far down the pipeline a frame is followed; what is not asked for costs nothing.
  enum class Goal
  {
    kFloor,
    kOccupancy,
    kInflation,
    kPolygons
  };

  /// What a frame gave. It lives in the pipeline until the next frame.
  struct Result
  {
    FloorState floor;
    /// From the input's frame into the floor frame; meaningful unless NOT_FOUND.
    Eigen::Isometry3d to_floor_frame = Eigen::Isometry3d::Identity();
    BinaryGrid occupancy;  ///< free everywhere when NOT_FOUND or not asked for
    BinaryGrid inflated;
    geometry::PolygonSet polygons;
    StageTimes times;
  };

  explicit Pipeline(const Parameters& parameters);

  /// @return the result, valid until the next call
  const Result& process(const Frame& frame, Goal goal = Goal::kPolygons);

  /// Forgets the floor and the camera's forward direction.
  void reset();

  /// Takes on new parameters with the next frame and keeps the floor.
  void configure(const Parameters& parameters);

  const Parameters& parameters() const { return parameters_; }
  const Result& result() const { return result_; }
  const SampleGrid& samples() const { return samples_; }
  const FloorTracker& tracker() const { return tracker_; }
  Projection& projection() { return projection_; }

private:
  Parameters parameters_;
  SampleGrid samples_;
  FloorTracker tracker_;
  Projection projection_;
  DropOffs drop_offs_;
  Inflation inflation_;
  Polygonizer polygonizer_;
  std::optional<Eigen::Vector3d> forward_;
  Result result_;
};

}  // namespace polygonal_perception::perception
