#include "map_check.hpp"

#include "polygonal_perception/geometry/validity.hpp"
#include "result_check.hpp"

namespace polygonal_perception::test {

void requireSound(const mapping::PolygonMap::Result& result)
{
  const occupancy::GridGeometry& geometry = result.occupied.geometry();
  require(
      geometry.size() > 0 && result.inflated.geometry() == geometry && result.seen.size() == geometry.size(),
      "all grids are the map's");
  for (std::size_t k = 0; k < geometry.size(); ++k) {
    require(result.occupied.cells()[k] <= result.inflated.cells()[k], "an occupied cell is inflated");
    require(result.seen[k] <= 1, "a cell was seen or not");
  }
  const auto defect = geometry::findDefect(result.polygons);
  require(!defect, defect ? defect->text.c_str() : "");
}

void requireSafe(const mapping::PolygonMap::Result& result, const MapLengths& lengths)
{
  const reference::PolygonChecker checker(result.occupied, result.polygons, lengths.radiusInCells(),
                                          lengths.limitInCells());
  for (const auto& fault :
       {checker.notOnLattice(), checker.notSimple(), checker.wrongNesting(), checker.unsafe()})
    require(!fault, fault ? fault->c_str() : "");
}

}  // namespace polygonal_perception::test
