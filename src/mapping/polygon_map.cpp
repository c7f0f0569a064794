#include "polygonal_perception/mapping/polygon_map.hpp"

namespace polygonal_perception::mapping {

namespace {

template <class Stage>
PolygonMap::StageTimes::Duration timeOf(Stage&& stage)
{
  const auto start = std::chrono::steady_clock::now();
  stage();
  return std::chrono::duration_cast<PolygonMap::StageTimes::Duration>(std::chrono::steady_clock::now() -
                                                                      start);
}

}  // namespace

PolygonMap::PolygonMap(const Parameters& parameters)
    : parameters_(parameters),
      map_(parameters.map),
      inflation_(parameters.inflation),
      polygonizer_(parameters.polygonizer)
{
}

void PolygonMap::configure(const Parameters& parameters)
{
  parameters_ = parameters;
  map_.configure(parameters.map);
  inflation_ = occupancy::Inflation(parameters.inflation);
  polygonizer_ = occupancy::Polygonizer(parameters.polygonizer);
}

void PolygonMap::update(const Observation& observation, const Eigen::Vector2d& middle)
{
  result_.times = StageTimes{};
  result_.times.update = timeOf([&] {
    if (!map_.isActive()) map_.reset(observation.geometry.resolution);
    map_.moveTo(middle);
    map_.add(observation);
    map_.forgetOld(observation.stamp);
  });
}

const PolygonMap::Result& PolygonMap::make(Products products)
{
  Result& r = result_;
  r.products = products;
  r.products.inflated |= products.polygons;
  r.products.occupied |= products.seen || r.products.inflated;
  r.polygons.clear();
  r.times.grids = timeOf([&] {
    if (r.products.occupied) map_.copyOccupied(r.occupied);
    if (r.products.seen) map_.copySeen(r.seen);
  });
  r.times.inflation = timeOf([&] {
    if (r.products.inflated) inflation_.inflate(r.occupied, r.inflated);
  });
  r.times.polygons = timeOf([&] {
    if (r.products.polygons)
      polygonizer_.polygonize(r.occupied, r.inflated, parameters_.inflation.robot_radius, r.polygons);
  });
  return r;
}

}  // namespace polygonal_perception::mapping
