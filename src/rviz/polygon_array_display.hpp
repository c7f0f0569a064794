#pragma once

#include <polygonal_perception/PolygonArray.h>

#include <memory>
#include <vector>

#include "rviz/newest_message_display.hpp"
#include "rviz/polygon_colors.hpp"
#include "rviz/polygon_shape.hpp"
#include "rviz/ring_lines.hpp"

namespace rviz {
class BoolProperty;
class ColorProperty;
class EnumProperty;
class FloatProperty;
}  // namespace rviz

namespace polygonal_perception::displays {

/// Shows a polygonal_perception/PolygonArray: each polygon filled, holes left open, with its outline; and the
/// outline of what was looked at.
class PolygonArrayDisplay : public NewestMessageDisplay<PolygonArray>
{
  Q_OBJECT
public:
  PolygonArrayDisplay();
  ~PolygonArrayDisplay() override;

  void reset() override;

protected:
  void onInitialize() override;

private:
  /// Draws the last message as the properties are now.
  Q_SLOT void redraw();
  void show(const PolygonArray::ConstPtr& message) override;
  void paint(std::vector<PolygonShape::Polygon>& polygons);
  void drawExtent();

  // rviz owns the properties: they are children of the display.
  rviz::EnumProperty* color_by_;
  rviz::ColorProperty* color_;
  rviz::BoolProperty* fill_;
  rviz::FloatProperty* alpha_;
  rviz::BoolProperty* outline_;
  rviz::FloatProperty* line_width_;
  rviz::FloatProperty* height_;
  rviz::BoolProperty* extent_;
  rviz::FloatProperty* offset_;

  PolygonArray::ConstPtr message_;  ///< the last; null before the first
  PolygonColors colors_;
  std::unique_ptr<PolygonShape> shape_;
  std::unique_ptr<RingLines> extent_line_;
};

}  // namespace polygonal_perception::displays
