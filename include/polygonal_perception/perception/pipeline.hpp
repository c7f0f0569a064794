#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"
#include "polygonal_perception/occupancy/grid/inflation.hpp"
#include "polygonal_perception/occupancy/polygons/polygonizer.hpp"
#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/perception/floor/floor_detector.hpp"
#include "polygonal_perception/perception/floor/floor_tracker.hpp"
#include "polygonal_perception/perception/floor/ground_planes.hpp"
#include "polygonal_perception/perception/floor/view_axes.hpp"
#include "polygonal_perception/perception/grid/drop_offs.hpp"
#include "polygonal_perception/perception/grid/look_through.hpp"
#include "polygonal_perception/perception/grid/projection.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"
#include "polygonal_perception/perception/planes/sample_grid.hpp"
#include "polygonal_perception/perception/products.hpp"
#include "polygonal_perception/perception/scan/floor_scanner.hpp"
#include "polygonal_perception/perception/segmentation/plane_segmentation.hpp"
#include "polygonal_perception/perception/stage_times.hpp"

namespace polygonal_perception::perception {

/// A frame and what its publisher knows about it.
struct Frame
{
  PointView points;
  double stamp = 0.0;  ///< [s]
  FloorHints hints;
  IgnoredBoxes ignored = {};  ///< the robot's own parts
};

/// The way of a frame, from points to polygons.
class POLYGONAL_PERCEPTION_EXPORT Pipeline
{
public:
  struct Parameters
  {
    RangeLimits range;
    SampleGrid::Parameters samples;
    FloorTracker::Parameters tracker;
    FloorDetector::Parameters detector;
    ViewAxesParameters view;
    GroundPlanes::Parameters ground;
    PlaneSegmentation::Parameters segmentation;
    occupancy::GridParameters grid;
    Projection::Parameters projection;
    DropOffs::Parameters drop_offs;
    FloorScanner::Parameters scan;
    occupancy::Inflation::Parameters inflation;
    occupancy::Polygonizer::Parameters polygonizer;

    /// Visits the parameters of every stage.
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      RangeLimits::describe(self.range, visit);
      SampleGrid::Parameters::describe(self.samples, visit);
      FloorTracker::Parameters::describe(self.tracker, visit);
      FloorDetector::Parameters::describe(self.detector, visit);
      GroundPlanes::Parameters::describe(self.ground, visit);
      occupancy::GridParameters::describe(self.grid, visit);
      Projection::Parameters::describe(self.projection, visit);
      DropOffs::Parameters::describe(self.drop_offs, visit);
      FloorScanner::Parameters::describe(self.scan, visit);
      occupancy::Inflation::Parameters::describe(self.inflation, visit);
      occupancy::Polygonizer::Parameters::describe(self.polygonizer, visit);
    }

    /// @return which parameters contradict one another though each is within its range, or nothing
    POLYGONAL_PERCEPTION_EXPORT std::optional<parameters::ParameterFault> conflict() const;
  };

  /// All that a frame gave. It lives in the pipeline until the next frame.
  struct Result
  {
    explicit Result(const SampleGrid::Parameters& parameters) : samples(parameters) {}

    Products
        products;  ///< what was asked for, with all that it is made of; none: the frame was not looked at
    FloorState floor;
    ViewAxes view;     ///< where the camera looks, in the input's frame
    ViewAxes heading;  ///< what is ahead: the same, or by the parameter `forward`
    /// From the input's frame into the floor frame; meaningful unless NOT_FOUND.
    Eigen::Isometry3d to_floor_frame = Eigen::Isometry3d::Identity();
    SampleGrid samples;               ///< of the frame
    std::vector<SampleLabel> labels;  ///< of each sample; empty where nobody asked
    SegmentedPlanes planes;           ///< also where no floor was found
    std::vector<Eigen::Vector3f>
        floor_hull;  ///< [m] in the input's frame; a held floor's is the one it was found with
    occupancy::BinaryGrid occupancy;    ///< free everywhere when NOT_FOUND or not asked for
    occupancy::ObservedCells observed;  ///< in the grid's cells; empty when NOT_FOUND or not asked for
    LevelScan scan;  ///< in the floor frame; all unknown when NOT_FOUND, empty where nobody has asked yet
    std::vector<Eigen::Vector3f> obstacle_points;  ///< [m] in the floor frame
    occupancy::BinaryGrid inflated;
    geometry::PolygonSet polygons;  ///< [m] in the floor frame
    StageTimes times;
  };

  explicit Pipeline(const Parameters& parameters);

  /// @param products  what is wanted; nothing else is paid for
  /// @return the result, valid until the next call
  const Result& process(const Frame& frame, Products products = Product::kPolygons);

  /// Leaves a frame out: the result is that of a frame that was not looked at, and the next one finds all that was
  /// known before.
  void skip();

  /// Forgets the floor and where the camera looks. The result is that of a frame that was not looked
  /// at.
  void reset();

  /// Takes on new parameters with the next frame and keeps the floor.
  void configure(const Parameters& parameters);

  /// Whether a frame of that stamp [s] has no floor to start from, and so wants an up vector from tf if there
  /// is one.
  bool needsSeed(double stamp) const { return tracker_.needsSeed(stamp); }

  const Parameters& parameters() const { return parameters_; }
  const Result& result() const { return result_; }

private:
  void clearResult(Products products);
  void findFloor(const Frame& frame);
  void listPlanes(const Frame& frame);
  void findViewAxes(const Frame& frame);
  /// The scan where there is no floor.
  void makeUnknownScan(const Frame& frame);
  /// What heights count from beside the floor; nullptr: nothing.
  const GroundMap* mapGround();

  template <class Stage>
  void run(Product product, StageTimes::Duration StageTimes::*time, Stage&& stage);

  Parameters parameters_;
  FloorTracker tracker_;
  PlaneSegmentation segmentation_;
  GroundPlanes ground_planes_;
  std::vector<GroundSurface> ground_surfaces_;
  GroundMap ground_map_;
  Projection projection_;
  DropOffs drop_offs_;
  LookThrough look_through_;
  FloorScanner scanner_;
  occupancy::Inflation inflation_;
  occupancy::Polygonizer polygonizer_;
  std::optional<Pinhole> pinhole_;  // of the first cloud whose pixels told it
  int pinhole_tries_ = 0;
  Result result_;
};

}  // namespace polygonal_perception::perception
