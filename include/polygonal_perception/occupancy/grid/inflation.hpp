#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"

namespace polygonal_perception::occupancy {

class BitGrid;

/// Grows the occupied cells by the robot's radius (section IV), so that the robot can be planned for as a
/// point.
class POLYGONAL_PERCEPTION_EXPORT Inflation
{
public:
  struct Parameters
  {
    double robot_radius = 0.30;  ///< [m]

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      visit("robot_radius", self.robot_radius, parameters::Range{0.0, 5.0}, "m",
            "Radius of the robot's footprint, by which obstacles are inflated.");
    }
  };

  explicit Inflation(const Parameters& parameters);
  Inflation(Inflation&&) noexcept;
  Inflation& operator=(Inflation&&) noexcept;
  ~Inflation();

  const Parameters& parameters() const { return parameters_; }

  /// A cell of `inflated` is set when its square comes within robot_radius of the square of an occupied cell
  /// (closer than it, so that a radius of 0 leaves the grid as it is). Nothing is lost at the border.
  /// @param inflated  takes on the occupancy's geometry; must be another grid
  void inflate(const BinaryGrid& occupancy, BinaryGrid& inflated);

private:
  void measureDisc(double resolution);

  Parameters parameters_;
  double disc_resolution_ = 0.0;  ///< [m] that half_widths_ was made for; 0: none yet
  std::vector<int> half_widths_;  ///< of the inflated disc's row that lies d rows from the occupied cell
  std::unique_ptr<BitGrid> occupied_;
  std::unique_ptr<BitGrid> grown_;
};

}  // namespace polygonal_perception::occupancy
