#include "polygonal_perception/perception/pipeline.hpp"

#include <Eigen/LU>
#include <chrono>

#include "polygonal_perception/perception/floor/floor_frame.hpp"
#include "polygonal_perception/perception/floor/floor_hull.hpp"

namespace polygonal_perception::perception {

namespace {

FloorTracker::Parameters trackerParameters(const Pipeline::Parameters& parameters)
{
  FloorTracker::Parameters tracker = parameters.tracker;
  tracker.mount.has_slopes = parameters.ground.max_slope > 0.0;
  return tracker;
}

/// From directions in the input's frame to pixels: (u, v, 1) up to a positive factor. Nothing where nobody knows.
std::optional<Eigen::Matrix3f> pixelsOfDirections(const PointView& points,
                                                  const std::optional<Pinhole>& pinhole)
{
  if (points.layout() != PointLayout::kCloud) return points.rays()->pixelOfDirection();
  if (!pinhole) return std::nullopt;
  return pinhole->direction_of_pixel.inverse().cast<float>();
}

}  // namespace

Pipeline::Pipeline(const Parameters& parameters)
    : parameters_(parameters),
      tracker_(trackerParameters(parameters), parameters.detector),
      segmentation_(parameters.segmentation),
      ground_planes_(parameters.ground),
      projection_(parameters.projection),
      drop_offs_(parameters.drop_offs),
      look_through_(parameters.detector.planes.noise),
      scanner_(parameters.scan),
      inflation_(parameters.inflation),
      polygonizer_(parameters.polygonizer),
      result_(parameters.samples)
{
}

/// Runs a stage if its product is asked for, and says how long it took.
template <class Stage>
void Pipeline::run(Product product, StageTimes::Duration StageTimes::*time, Stage&& stage)
{
  if (!result_.products.has(product)) return;
  const auto start = std::chrono::steady_clock::now();
  stage();
  result_.times.*time =
      std::chrono::duration_cast<StageTimes::Duration>(std::chrono::steady_clock::now() - start);
}

const Pipeline::Result& Pipeline::process(const Frame& whole_frame, Products products)
{
  using Times = StageTimes;
  Result& r = result_;
  Frame frame = whole_frame;
  frame.points = whole_frame.points.within(parameters_.range).without(whole_frame.ignored);
  clearResult(products);

  // Section III-A; III-B to III-D
  run(Product::kFloor, &Times::samples, [&] { r.samples.update(frame.points); });
  run(Product::kFloor, &Times::floor, [&] { findFloor(frame); });
  // III-B, last lines. Frames that nobody asked for planes of part those before from those after.
  if (!r.products.has(Product::kPlanes)) segmentation_.reset();
  run(Product::kPlanes, &Times::planes, [&] { listPlanes(frame); });
  if (r.floor.status == FloorStatus::kNotFound) {
    run(Product::kScan, &Times::scan, [&] { makeUnknownScan(frame); });
    return r;
  }

  // Figure 3
  run(Product::kFloorHull, &Times::floor_hull, [&] {
    if (r.floor.status == FloorStatus::kFound)
      r.floor_hull = floorHull(r.samples, r.labels, r.floor.floor.plane);
  });

  const HeightNoise noise(parameters_.detector.planes.noise, r.floor.floor.plane, r.floor.floor.covariance);
  // Section IV: into the floor frame and onto the grid, grown by the robot's radius, as polygons
  HeightRules rules{&noise, nullptr};
  if (ground_planes_.isActive()) run(Product::kGround, &Times::ground, [&] { rules.ground = mapGround(); });
  const auto pixels = pixelsOfDirections(frame.points, pinhole_);
  const FloorScanner::View view{frame.points, pixels, r.to_floor_frame};
  const FloorPointNoise floor_noise = noise.onFloor(r.to_floor_frame);
  run(Product::kOccupancy, &Times::projection, [&] {
    Observation wanted;
    if (r.products.has(Product::kObserved)) wanted.cells = &r.observed;
    if (r.products.has(Product::kScan)) {
      scanner_.cover(view);
      wanted.nearest = &scanner_.beginFrame(view, floor_noise);
    }
    projection_.project(frame.points, r.to_floor_frame, r.occupancy, rules, wanted);
    drop_offs_.mark(frame.points, r.to_floor_frame, r.occupancy, rules.ground);
  });
  run(Product::kScan, &Times::scan, [&] { scanner_.finishFrame(view, r.occupancy, r.observed, r.scan); });
  run(Product::kLookedThrough, &Times::looked_through, [&] {
    look_through_.look(frame.points, pixels, r.to_floor_frame,
                       {r.occupancy.geometry(), parameters_.projection, rules.ground}, r.observed.free);
  });
  run(Product::kObstaclePoints, &Times::obstacle_points, [&] {
    projection_.collect(frame.points, r.to_floor_frame, r.occupancy.geometry(), r.obstacle_points, rules);
  });
  run(Product::kInflation, &Times::inflation, [&] { inflation_.inflate(r.occupancy, r.inflated); });
  run(Product::kPolygons, &Times::polygons, [&] {
    polygonizer_.polygonize(r.occupancy, r.inflated, parameters_.inflation.robot_radius, r.polygons);
  });
  return r;
}

void Pipeline::clearResult(Products products)
{
  const occupancy::GridGeometry geometry(parameters_.grid);
  result_.products = products;
  result_.times = StageTimes{};
  result_.labels.clear();
  result_.planes.clear();
  result_.occupancy.reset(geometry);
  result_.observed.clear();
  result_.scan.ranges.clear();
  result_.obstacle_points.clear();
  result_.inflated.reset(geometry);
  result_.polygons.clear();
}

void Pipeline::findFloor(const Frame& frame)
{
  result_.floor = tracker_.update(frame.points, result_.samples, frame.stamp, frame.hints);
  if (result_.products.has(Product::kSampleLabels)) result_.labels = tracker_.detector().labels();
  if (result_.floor.status != FloorStatus::kHeld) result_.floor_hull.clear();
  findViewAxes(frame);
  if (result_.floor.status == FloorStatus::kNotFound) return;
  result_.to_floor_frame = floorFrame(result_.floor.floor.plane, result_.heading);
}

void Pipeline::listPlanes(const Frame& frame)
{
  std::optional<Eigen::Vector3d> up;
  if (frame.hints.up) up = frame.hints.up->normalized();
  if (result_.floor.status != FloorStatus::kNotFound) up = result_.floor.floor.plane.normal;
  segmentation_.segment(frame.points, result_.samples, tracker_.detector(), result_.floor, up,
                        result_.planes);
}

void Pipeline::findViewAxes(const Frame& frame)
{
  // What has not looked like a pinhole's pixels in so many frames with a floor is none: a lidar's, say.
  constexpr int kMostTries = 30;
  const Eigen::Vector3d& initial_up = parameters_.tracker.initial_up;
  const PointLayout layout = frame.points.layout();
  const bool may_try = layout == PointLayout::kCloud && result_.floor.status != FloorStatus::kNotFound;
  if (may_try && !pinhole_ && pinhole_tries_ < kMostTries) {
    ++pinhole_tries_;
    pinhole_ = fitPinhole(result_.samples);
  }
  const bool is_read_off = layout == PointLayout::kCloud && pinhole_;
  result_.view = is_read_off ? viewAxesOf(*pinhole_) : conventionalViewAxes(layout, initial_up);
  const auto& forward = parameters_.view.forward;
  result_.heading = forward ? viewAxesAlong(*forward, initial_up) : result_.view;
}

void Pipeline::makeUnknownScan(const Frame& frame)
{
  // As many bins as there would be if the camera stood as it does at the start.
  const Eigen::Vector3d up = parameters_.tracker.initial_up.normalized();
  const auto pixels = pixelsOfDirections(frame.points, pinhole_);
  scanner_.cover({frame.points, pixels, floorFrame({up, 0.0}, result_.heading)});
  scanner_.makeUnknown(result_.scan);
}

const GroundMap* Pipeline::mapGround()
{
  const auto& planes = ground_planes_.find(tracker_.detector(), result_.floor.floor.plane);
  if (planes.size() < 2) return nullptr;
  const Eigen::Isometry3f to_floor_frame = result_.to_floor_frame.cast<float>();
  ground_surfaces_.resize(planes.size());
  for (std::size_t k = 0; k < planes.size(); ++k) {
    GroundSurface& surface = ground_surfaces_[k];
    surface.setPlane(planes[k].plane, result_.to_floor_frame);
    surface.samples.clear();
    for (const Eigen::Vector3f& sample : planes[k].samples)
      surface.samples.emplace_back((to_floor_frame * sample).head<2>());
  }
  ground_map_.build(result_.occupancy.geometry(), ground_surfaces_);
  return &ground_map_;
}

void Pipeline::skip()
{
  clearResult({});
  result_.floor = FloorState{};
  if (scanner_.bins().count > 0) scanner_.makeUnknown(result_.scan);
}

void Pipeline::reset()
{
  tracker_.reset();
  segmentation_.reset();
  pinhole_.reset();
  pinhole_tries_ = 0;
  scanner_.reset();
  skip();
  result_.floor_hull.clear();
}

void Pipeline::configure(const Parameters& parameters)
{
  parameters_ = parameters;
  result_.samples = SampleGrid(parameters.samples);
  tracker_.configure(trackerParameters(parameters), parameters.detector);
  segmentation_.configure(parameters.segmentation);
  ground_planes_ = GroundPlanes(parameters.ground);
  projection_ = Projection(parameters.projection);
  drop_offs_ = DropOffs(parameters.drop_offs);
  look_through_ = LookThrough(parameters.detector.planes.noise);
  scanner_ = FloorScanner(parameters.scan);
  inflation_ = occupancy::Inflation(parameters.inflation);
  polygonizer_ = occupancy::Polygonizer(parameters.polygonizer);
}

}  // namespace polygonal_perception::perception
