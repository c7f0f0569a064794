#pragma once

#include <memory>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"

namespace polygonal_perception::occupancy {

/// Turns the inflated cells into few-cornered polygons (section IV) that keep the polygon contract: simple,
/// disjoint, safe and tight.
class POLYGONAL_PERCEPTION_EXPORT Polygonizer
{
public:
  struct Parameters
  {
    double simplification_tolerance = 0.05;  ///< [m]

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      visit("simplification_tolerance", self.simplification_tolerance, parameters::Range{0.0, 1.0}, "m",
            "How far a polygon may reach beyond the inflated cells to save vertices.");
    }
  };

  explicit Polygonizer(const Parameters& parameters);
  Polygonizer(Polygonizer&&) noexcept;
  Polygonizer& operator=(Polygonizer&&) noexcept;
  ~Polygonizer();

  const Parameters& parameters() const { return parameters_; }

  /// @param occupancy     the cells before inflation
  /// @param inflated      the same grid inflated by robot_radius
  /// @param robot_radius  [m]
  /// @param polygons      filled anew; vertices in the floor frame [m]
  void polygonize(const BinaryGrid& occupancy, const BinaryGrid& inflated, double robot_radius,
                  geometry::PolygonSet& polygons);

private:
  struct Workspace;

  Parameters parameters_;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace polygonal_perception::occupancy
