#include "rviz/polygon_array_display.hpp"

#include <rviz/properties/bool_property.h>
#include <rviz/properties/color_property.h>
#include <rviz/properties/enum_property.h>
#include <rviz/properties/float_property.h>

#include <cmath>
#include <pluginlib/class_list_macros.hpp>
#include <string>

#include "polygonal_perception/geometry/measures.hpp"
#include "polygonal_perception/ros/common/polygon_messages.hpp"
#include "rviz/message_status.hpp"

namespace polygonal_perception::displays {

namespace {

enum PolygonColor
{
  kFixed,
  kPolygon
};

constexpr float kHeldPolygonAlpha = 0.4F;  // polygons on a floor that is not seen are paler
// The extent stays behind the polygons: grey and thin, yet over a pixel wide from above, lest parts go
// missing.
constexpr float kExtentWidth = 0.015F;  // [m]
const Ogre::ColourValue kExtentColor(0.6F, 0.6F, 0.6F, 0.6F);

/// Those polygons that can be drawn, white.
///
/// @param error  what is wrong with the last of the others; untouched where there is none
std::vector<PolygonShape::Polygon> polygonsOf(const PolygonArray& array, std::string& error)
{
  std::vector<PolygonShape::Polygon> polygons;
  for (const ObstaclePolygon& message : array.polygons) {
    const auto rings = ros_common::toPolygonSet(message);
    if (rings) {
      polygons.push_back({*rings, Ogre::ColourValue::White});
    } else {
      error = rings.error();
    }
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
  extent_ = new rviz::BoolProperty("Extent", true,
                                   "Draw the outline of what was looked at; nothing is known outside.", this,
                                   SLOT(redraw()));
  offset_ = new rviz::FloatProperty(
      "Offset", 0.005F, "[m] that the polygons are raised, so that the floor does not cover them.", this,
      SLOT(redraw()));
}

PolygonArrayDisplay::~PolygonArrayDisplay() = default;

void PolygonArrayDisplay::onInitialize()
{
  NewestMessageDisplay::onInitialize();
  shape_ = std::make_unique<PolygonShape>(*scene_manager_, *scene_node_);
  extent_line_ = std::make_unique<RingLines>(*scene_manager_, *scene_node_);
}

void PolygonArrayDisplay::reset()
{
  NewestMessageDisplay::reset();
  message_.reset();
  shape_->clear();
  extent_line_->clear();
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

  std::string error;
  std::vector<PolygonShape::Polygon> polygons = polygonsOf(*message_, error);
  const StatusLine status = polygonStatus(*message_, message_->polygons.size() - polygons.size(), error);
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
  drawExtent();
  context_->queueRender();
}

void PolygonArrayDisplay::drawExtent()
{
  RingLines::Ring ring;
  ring.color = kExtentColor;
  for (const geometry_msgs::Point32& p : message_->extent.points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return extent_line_->clear();
    ring.corners.emplace_back(p.x, p.y, offset_->getFloat());
  }
  if (!extent_->getBool()) ring.corners.clear();
  extent_line_->set({ring}, kExtentWidth);
}

void PolygonArrayDisplay::paint(std::vector<PolygonShape::Polygon>& polygons)
{
  if (color_by_->getOptionInt() == kFixed) {
    for (PolygonShape::Polygon& polygon : polygons) polygon.color = color_->getOgreColor();
  } else {
    std::vector<Eigen::Vector2d> centers;
    centers.reserve(polygons.size());
    for (const PolygonShape::Polygon& polygon : polygons)
      centers.push_back(geometry::bounds(polygon.rings).center());
    const std::vector<float> hues = colors_.assign(centers);
    for (std::size_t i = 0; i < polygons.size(); ++i) polygons[i].color.setHSB(hues[i], 0.8F, 0.95F);
  }
  if (message_->floor_status == FloorPlane::FOUND) return;
  for (PolygonShape::Polygon& polygon : polygons) polygon.color.a = kHeldPolygonAlpha;
}

}  // namespace polygonal_perception::displays

PLUGINLIB_EXPORT_CLASS(polygonal_perception::displays::PolygonArrayDisplay, rviz::Display)
