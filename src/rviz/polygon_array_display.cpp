#include "rviz/polygon_array_display.hpp"

#include <rviz/properties/bool_property.h>
#include <rviz/properties/color_property.h>
#include <rviz/properties/enum_property.h>
#include <rviz/properties/float_property.h>

#include <Eigen/Geometry>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <utility>

#include "rviz/message_geometry.hpp"
#include "rviz/message_status.hpp"

namespace polygonal_perception::displays {

namespace {

enum ColorBy
{
  kFixed,
  kPolygon
};

constexpr float kHeldAlpha = 0.4F;  // polygons on a floor that is only HELD are paler

/// The middle of the boundary's bounding box.
Eigen::Vector2d centerOf(const geometry::PolygonSet& polygon)
{
  const geometry::PolygonSet::Ring& boundary = polygon.rings.front();
  Eigen::AlignedBox2d box;
  for (std::uint32_t i = 0; i < boundary.size; ++i) box.extend(polygon.vertices[boundary.first + i]);
  return box.center();
}

/// Those polygons that can be drawn, white.
std::vector<PolygonShape::Polygon> polygonsOf(const PolygonArray& array)
{
  std::vector<PolygonShape::Polygon> polygons;
  for (const ObstaclePolygon& message : array.polygons) {
    std::optional<geometry::PolygonSet> rings = toPolygonSet(message);
    if (rings) polygons.push_back({std::move(*rings), Ogre::ColourValue::White});
  }
  return polygons;
}

}  // namespace

PolygonArrayDisplay::PolygonArrayDisplay()
{
  color_by_ = new rviz::EnumProperty(
      "Color By", "Fixed", "One color for all, or another one for each polygon.", this, SLOT(redraw()));
  color_by_->addOption("Fixed", kFixed);
  color_by_->addOption("Polygon", kPolygon);
  color_ = new rviz::ColorProperty("Color", QColor(230, 77, 26), "Of all polygons, where the color is fixed.",
                                   this, SLOT(redraw()));
  fill_ = new rviz::BoolProperty("Fill", true, "Fill the polygons, except for their holes.", this,
                                 SLOT(redraw()));
  alpha_ =
      new rviz::FloatProperty("Alpha", 0.4F, "Of the fill and the walls; 1 is opaque.", this, SLOT(redraw()));
  alpha_->setMin(0.0F);
  alpha_->setMax(1.0F);
  outline_ = new rviz::BoolProperty("Outline", true, "Draw the boundaries and the edges of the holes.", this,
                                    SLOT(redraw()));
  line_width_ =
      new rviz::FloatProperty("Line Width", 0.02F, "[m] of the outlines.", outline_, SLOT(redraw()), this);
  line_width_->setMin(0.001F);
  height_ = new rviz::FloatProperty("Height", 0.0F, "[m] of walls around the polygons; 0 for flat polygons.",
                                    this, SLOT(redraw()));
  height_->setMin(0.0F);
  offset_ = new rviz::FloatProperty(
      "Offset", 0.005F, "[m] that the polygons are raised, so that the floor does not cover them.", this,
      SLOT(redraw()));
}

PolygonArrayDisplay::~PolygonArrayDisplay() = default;

void PolygonArrayDisplay::onInitialize()
{
  NewestMessageDisplay::onInitialize();
  shape_ = std::make_unique<PolygonShape>(*scene_manager_, *scene_node_);
}

void PolygonArrayDisplay::reset()
{
  NewestMessageDisplay::reset();
  message_.reset();
  shape_->clear();
}

void PolygonArrayDisplay::show(const PolygonArray::ConstPtr& message)
{
  message_ = message;
  const StatusLine floor = floorStatus(*message);
  setStatus(floor.level, "Floor", floor.text);
  redraw();
}

void PolygonArrayDisplay::redraw()
{
  color_->setHidden(color_by_->getOptionInt() != kFixed);
  if (!message_) return;

  std::vector<PolygonShape::Polygon> polygons = polygonsOf(*message_);
  const StatusLine status = polygonStatus(*message_, message_->polygons.size() - polygons.size());
  setStatus(status.level, "Polygons", status.text);
  paint(polygons);

  PolygonStyle style;
  style.fill = fill_->getBool();
  style.outline = outline_->getBool();
  style.alpha = alpha_->getFloat();
  style.line_width = line_width_->getFloat();
  style.offset = offset_->getFloat();
  style.height = height_->getFloat();
  shape_->set(polygons, style);
  context_->queueRender();
}

void PolygonArrayDisplay::paint(std::vector<PolygonShape::Polygon>& polygons)
{
  if (color_by_->getOptionInt() == kFixed) {
    for (PolygonShape::Polygon& polygon : polygons) polygon.color = color_->getOgreColor();
  } else {
    std::vector<Eigen::Vector2d> centers;
    centers.reserve(polygons.size());
    for (const PolygonShape::Polygon& polygon : polygons) centers.push_back(centerOf(polygon.rings));
    const std::vector<float> hues = colors_.assign(centers);
    for (std::size_t i = 0; i < polygons.size(); ++i) polygons[i].color.setHSB(hues[i], 0.8F, 0.95F);
  }
  if (message_->floor_status == FloorPlane::FOUND) return;
  for (PolygonShape::Polygon& polygon : polygons) polygon.color.a = kHeldAlpha;
}

}  // namespace polygonal_perception::displays

PLUGINLIB_EXPORT_CLASS(polygonal_perception::displays::PolygonArrayDisplay, rviz::Display)
