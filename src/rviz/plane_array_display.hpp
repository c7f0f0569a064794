#pragma once

#include <polygonal_perception/PlaneArray.h>

#include <memory>

#include "rviz/newest_message_display.hpp"
#include "rviz/ring_lines.hpp"
#include "rviz/triangle_mesh.hpp"

namespace rviz {
class BoolProperty;
class EnumProperty;
class FloatProperty;
}  // namespace rviz

namespace polygonal_perception::displays {

/// Shows a polygonal_perception/PlaneArray: the outline of each plane, filled, in the colour of its kind or of its id.
class PlaneArrayDisplay : public NewestMessageDisplay<PlaneArray>
{
  Q_OBJECT
public:
  PlaneArrayDisplay();
  ~PlaneArrayDisplay() override;

  void reset() override;

protected:
  void onInitialize() override;

private:
  /// Draws the last message as the properties are now.
  Q_SLOT void redraw();
  void show(const PlaneArray::ConstPtr& message) override;
  Ogre::ColourValue colorOf(const Plane& plane) const;

  // rviz owns the properties: they are children of the display.
  rviz::EnumProperty* color_by_;
  rviz::BoolProperty* floor_;
  rviz::FloatProperty* alpha_;
  rviz::FloatProperty* line_width_;

  PlaneArray::ConstPtr message_;  ///< the last; null before the first
  std::unique_ptr<TriangleMesh> areas_;
  std::unique_ptr<RingLines> outlines_;
};

}  // namespace polygonal_perception::displays
