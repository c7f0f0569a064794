#include "rviz/polygon_shape.hpp"

#include "polygonal_perception/geometry/triangulation.hpp"

namespace polygonal_perception::displays {

namespace {

using Corners = std::vector<TriangleMesh::Corner>;

constexpr float kWallBrightness = 0.75F;     // tells walls from tops, as nothing is lit
constexpr float kOutlineClearance = 0.004F;  // [m] above the fill, lest they flicker through one another

Ogre::Vector3 at(const Eigen::Vector2d& p, float z)
{
  return {static_cast<Ogre::Real>(p.x()), static_cast<Ogre::Real>(p.y()), z};
}

void appendTop(const geometry::PolygonSet& polygon, float z, const Ogre::ColourValue& color, Corners& corners)
{
  for (const Eigen::Vector2d& corner : geometry::triangulate(polygon))
    corners.push_back({at(corner, z), color});
}

void appendWalls(const geometry::PolygonSet& polygon, float bottom, float top, const Ogre::ColourValue& color,
                 Corners& corners)
{
  for (const geometry::PolygonSet::Ring& ring : polygon.rings) {
    for (const auto [a, b] : polygon.view(ring).edges()) {
      for (const Ogre::Vector3& corner :
           {at(a, bottom), at(b, bottom), at(b, top), at(a, bottom), at(b, top), at(a, top)}) {
        corners.push_back({corner, color});
      }
    }
  }
}

void appendOutlines(const geometry::PolygonSet& polygon, float z, const Ogre::ColourValue& color,
                    std::vector<RingLines::Ring>& outlines)
{
  for (const geometry::PolygonSet::Ring& ring : polygon.rings) {
    RingLines::Ring& outline = outlines.emplace_back();
    outline.color = color;
    for (const Eigen::Vector2d& vertex : polygon.view(ring)) outline.corners.push_back(at(vertex, z));
  }
}

}  // namespace

void PolygonShape::set(const std::vector<Polygon>& polygons, const PolygonStyle& style)
{
  const float top = style.offset + style.height;
  Corners corners;
  std::vector<RingLines::Ring> outlines;
  for (const Polygon& polygon : polygons) {
    Ogre::ColourValue fill = polygon.color;
    fill.a *= style.alpha;
    Ogre::ColourValue wall = fill * kWallBrightness;
    wall.a = fill.a;
    if (style.fill) appendTop(polygon.rings, top, fill, corners);
    if (style.height > 0.0F) appendWalls(polygon.rings, style.offset, top, wall, corners);
    if (style.outline) appendOutlines(polygon.rings, top + kOutlineClearance, polygon.color, outlines);
  }
  mesh_.set(corners);
  outlines_.set(outlines, style.line_width);
}

void PolygonShape::clear()
{
  mesh_.clear();
  outlines_.clear();
}

}  // namespace polygonal_perception::displays
