#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"
#include "polygonal_perception/occupancy/grid/observed_cells.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/perception/grid/ground_map.hpp"
#include "polygonal_perception/perception/grid/height_noise.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::perception {

class NearestStanding;
struct ProjectionKernel;

/// What else decides whether a point stands on the ground; null: not asked.
struct HeightRules
{
  const HeightNoise* noise = nullptr;  ///< for height_sigmas; none: heights are exact
  const GroundMap* ground = nullptr;   ///< that heights count from; none: the floor
};

/// What else is wanted of a frame as it is projected; null: not wanted.
struct Observation
{
  /// Its floor is where points less than min_height above the ground or below it were seen, and between two that are
  /// neighbours in a column of the image and lie at most three cells apart; its hits are in occupied cells.
  occupancy::ObservedCells* cells = nullptr;
  /// In all directions, in the grid and beyond it (with min_points_per_cell > 1 in the grid alone). Only with cells.
  NearestStanding* nearest = nullptr;
};

/// Transforms every point of a frame into the floor frame and marks the cells of the grid in which something
/// stands (section IV).
///
/// A point stands in the grid when min_height <= height <= max_height and its cell is one of the grid's; NaN
/// never does. This is decided in single precision, in an order of operations that is fixed
/// (projection_kernel.hpp), so that the same frame gives the same grid on every processor.
class POLYGONAL_PERCEPTION_EXPORT Projection
{
public:
  struct Parameters
  {
    double min_height = 0.03;     ///< [m] lower points are floor
    double max_height = 0.60;     ///< [m] higher points are nothing the robot could touch
    int min_points_per_cell = 1;  ///< a cell with fewer points stays free
    double height_sigmas = 0.0;   ///< points that are not higher than so many standard deviations are floor

    /// [m] Of the slabs in which ObservedCells has what stands.
    double slabHeight() const { return (max_height - min_height) / occupancy::ObservedCells::kSlabs; }

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      visit("min_height", self.min_height, parameters::Range{-1.0, 5.0}, "m",
            "Points lower than this are floor.");
      visit("max_height", self.max_height, parameters::Range{0.0, 10.0}, "m",
            "Points higher than this are passed under by the robot.");
      visit("min_points_per_cell", self.min_points_per_cell, parameters::Range{1, 255}, "",
            "A cell with fewer points than this stays free.");
      visit("height_sigmas", self.height_sigmas, parameters::Range{0.0, 20.0}, "",
            "Points that are not higher than so many standard deviations of their height are floor, too: far "
            "noise makes "
            "no obstacles, and far low obstacles are not seen.");
    }
  };

  /// With the widest kernel that this processor can run.
  explicit Projection(const Parameters& parameters);
  /// With a certain kernel; it must outlive the projection.
  Projection(const Parameters& parameters, const ProjectionKernel& kernel);
  Projection(Projection&& other) noexcept;
  Projection& operator=(Projection&& other) noexcept;
  ~Projection();

  const Parameters& parameters() const { return parameters_; }

  /// Marks the cells in which at least min_points_per_cell points of the frame stand.
  /// @param points          the frame; pixels without a return count for nothing
  /// @param to_floor_frame  from the input's frame into the floor frame
  /// @param occupancy       keeps its geometry; its cells are set anew
  void project(const PointView& points, const Eigen::Isometry3d& to_floor_frame,
               occupancy::BinaryGrid& occupancy, const HeightRules& rules = {},
               const Observation& wanted = {});

  /// Collects the points that stand in a grid, however few there are in a cell.
  /// @param geometry  of the grid
  /// @param standing  filled anew, in the floor frame [m]
  void collect(const PointView& points, const Eigen::Isometry3d& to_floor_frame,
               const occupancy::GridGeometry& geometry, std::vector<Eigen::Vector3f>& standing,
               const HeightRules& rules = {});

private:
  struct Workspace;

  void begin(const PointView& points, const Eigen::Isometry3d& to_floor_frame,
             const occupancy::GridGeometry& geometry, const HeightRules& rules, const Observation& wanted);
  void markAny(std::uint32_t rows, occupancy::BinaryGrid& occupancy);
  void markLayers(std::uint32_t rows, occupancy::BinaryGrid& occupancy, const Observation& wanted);
  void markMany(std::uint32_t rows, occupancy::BinaryGrid& occupancy);

  Parameters parameters_;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace polygonal_perception::perception
