#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"
#include "polygonal_perception/mapping/rolling_map.hpp"
#include "polygonal_perception/occupancy/grid/inflation.hpp"
#include "polygonal_perception/occupancy/polygons/polygonizer.hpp"

namespace polygonal_perception::mapping {

/// The rolling map and what is made of it, by the stages that a frame's grid goes through (section IV).
class POLYGONAL_PERCEPTION_EXPORT PolygonMap
{
public:
  struct Parameters
  {
    RollingMap::Parameters map;
    occupancy::Inflation::Parameters inflation;
    occupancy::Polygonizer::Parameters polygonizer;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      RollingMap::Parameters::describe(self.map, visit);
      occupancy::Inflation::Parameters::describe(self.inflation, visit);
      occupancy::Polygonizer::Parameters::describe(self.polygonizer, visit);
    }
  };

  /// What is asked for; each with what it is made of.
  struct Products
  {
    bool occupied = false;
    bool seen = false;
    bool inflated = false;
    bool polygons = false;

    Products& operator|=(const Products& other)
    {
      occupied |= other.occupied;
      seen |= other.seen;
      inflated |= other.inflated;
      polygons |= other.polygons;
      return *this;
    }
  };

  /// How long each stage of an update took.
  struct StageTimes
  {
    using Duration = std::chrono::nanoseconds;
    Duration update{0};
    Duration grids{0};
    Duration inflation{0};
    Duration polygons{0};

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      visit("update", self.update);
      visit("grids", self.grids);
      visit("inflation", self.inflation);
      visit("polygons", self.polygons);
    }
  };

  /// What was asked for, in the map's frame.
  struct Result
  {
    Products products;
    occupancy::BinaryGrid occupied;
    std::vector<std::uint8_t> seen;  ///< in the order of the grid: 1 where the floor was seen
    occupancy::BinaryGrid inflated;
    geometry::PolygonSet polygons;  ///< [m]
    StageTimes times;
  };

  explicit PolygonMap(const Parameters& parameters);

  void configure(const Parameters& parameters);
  const Parameters& parameters() const { return parameters_; }

  RollingMap& map() { return map_; }
  const RollingMap& map() const { return map_; }

  /// Rolls, and takes in a frame; the first one gives the map its resolution.
  /// @param middle  [m] where the robot is
  void update(const Observation& observation, const Eigen::Vector2d& middle);

  /// Makes what is asked for of the map as it is. @pre map().isActive()
  /// @return valid until the next call
  const Result& make(Products products);

private:
  Parameters parameters_;
  RollingMap map_;
  occupancy::Inflation inflation_;
  occupancy::Polygonizer polygonizer_;
  Result result_;
};

}  // namespace polygonal_perception::mapping
