#pragma once

#include <polygonal_perception/FloorPlane.h>

#include <memory>
#include <string>

#include "rviz/floor_shape.hpp"
#include "rviz/newest_message_display.hpp"

namespace rviz {
class BoolProperty;
class ColorProperty;
class EnumProperty;
class FloatProperty;
}  // namespace rviz

namespace polygonal_perception::displays {

/// Shows a polygonal_perception/FloorPlane: the hull of its samples or a patch of the plane, the normal under
/// the camera and the camera's height.
class FloorPlaneDisplay : public NewestMessageDisplay<FloorPlane>
{
  Q_OBJECT
public:
  FloorPlaneDisplay();
  ~FloorPlaneDisplay() override;

  void reset() override;

protected:
  void onInitialize() override;

private:
  /// Draws the last message as the properties are now.
  Q_SLOT void redraw();
  void show(const FloorPlane::ConstPtr& message) override;
  std::string text() const;

  // rviz owns the properties: they are children of the display.
  rviz::EnumProperty* area_;
  rviz::FloatProperty* patch_size_;
  rviz::ColorProperty* color_;
  rviz::FloatProperty* alpha_;
  rviz::FloatProperty* line_width_;
  rviz::BoolProperty* show_normal_;
  rviz::FloatProperty* normal_length_;
  rviz::BoolProperty* show_height_;
  rviz::FloatProperty* text_size_;

  FloorPlane::ConstPtr message_;  ///< the last; null before the first
  std::unique_ptr<FloorShape> shape_;
};

}  // namespace polygonal_perception::displays
