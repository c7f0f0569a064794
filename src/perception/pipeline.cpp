#include "polygonal_perception/perception/pipeline.hpp"

#include "polygonal_perception/perception/floor/floor_frame.hpp"

namespace polygonal_perception::perception {

namespace {

/// Runs a stage and says how long it took.
template <class Stage>
StageTimes::Duration timed(Stage&& stage)
{
  const auto start = std::chrono::steady_clock::now();
  stage();
  return std::chrono::duration_cast<StageTimes::Duration>(std::chrono::steady_clock::now() - start);
}

}  // namespace

Pipeline::Pipeline(const Parameters& parameters)
    : parameters_(parameters),
      samples_(parameters.samples),
      tracker_(parameters.tracker, parameters.detector),
      projection_(parameters.projection),
      drop_offs_(parameters.drop_offs),
      inflation_(parameters.inflation),
      polygonizer_(parameters.polygonizer)
{
}

const Pipeline::Result& Pipeline::process(const Frame& frame, Goal goal)
{
  const GridGeometry geometry(parameters_.grid);
  result_.times = StageTimes{};
  result_.occupancy.reset(geometry);
  result_.inflated.reset(geometry);
  result_.polygons.clear();

  result_.times.samples = timed([&] { samples_.update(frame.points); });
  result_.times.floor =
      timed([&] { result_.floor = tracker_.update(frame.points, samples_, frame.stamp, frame.up_from_tf); });
  if (!forward_) forward_ = forwardAxis(samples_, parameters_.tracker.initial_up);
  if (result_.floor.status == FloorStatus::kNotFound || !forward_) return result_;
  result_.to_floor_frame = floorFrame(result_.floor.floor.plane, *forward_);

  if (goal == Goal::kFloor) return result_;
  result_.times.projection = timed([&] {
    projection_.project(frame.points, result_.to_floor_frame, result_.occupancy);
    drop_offs_.mark(frame.points, result_.to_floor_frame, result_.occupancy);
  });
  if (goal == Goal::kOccupancy) return result_;
  result_.times.inflation = timed([&] { inflation_.inflate(result_.occupancy, result_.inflated); });
  if (goal == Goal::kInflation) return result_;
  result_.times.polygons = timed([&] {
    polygonizer_.polygonize(result_.occupancy, result_.inflated, parameters_.inflation.robot_radius,
                            result_.polygons);
  });
  return result_;
}

void Pipeline::reset()
{
  tracker_.reset();
  forward_.reset();
}

void Pipeline::configure(const Parameters& parameters)
{
  parameters_ = parameters;
  samples_ = SampleGrid(parameters.samples);
  tracker_.configure(parameters.tracker, parameters.detector);
  projection_ = Projection(parameters.projection);
  drop_offs_ = DropOffs(parameters.drop_offs);
  inflation_ = Inflation(parameters.inflation);
  polygonizer_ = Polygonizer(parameters.polygonizer);
}

}  // namespace polygonal_perception::perception
