#pragma once

#include "polygonal_perception/geometry/polygon_set.hpp"
#include "rviz/ring_lines.hpp"
#include "rviz/triangle_mesh.hpp"

namespace polygonal_perception::displays {

/// How polygons are drawn.
struct PolygonStyle
{
  bool fill = true;
  bool outline = true;
  float alpha = 0.5F;        ///< of the fill and the walls
  float line_width = 0.02F;  ///< [m]
  float offset = 0.0F;       ///< [m] of the bottom, along z
  float height = 0.0F;       ///< [m] of walls from the bottom up; 0 draws flat polygons
};

/// Polygons with holes in a scene: flat areas, or prisms.
class PolygonShape
{
public:
  /// A polygon with its holes, in the frame of the parent node.
  struct Polygon
  {
    geometry::PolygonSet rings;
    Ogre::ColourValue color;  ///< its alpha is that of the outline
  };

  PolygonShape(Ogre::SceneManager& scene, Ogre::SceneNode& parent)
      : mesh_(scene, parent), outlines_(scene, parent)
  {
  }

  /// Replaces what was shown.
  void set(const std::vector<Polygon>& polygons, const PolygonStyle& style);

  void clear();

private:
  TriangleMesh mesh_;
  RingLines outlines_;
};

}  // namespace polygonal_perception::displays
