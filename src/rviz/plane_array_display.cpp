#include "rviz/plane_array_display.hpp"

#include <rviz/properties/bool_property.h>
#include <rviz/properties/enum_property.h>
#include <rviz/properties/float_property.h>

#include <cmath>
#include <pluginlib/class_list_macros.hpp>
#include <vector>

#include "rviz/message_geometry.hpp"
#include "rviz/message_status.hpp"
#include "rviz/ogre_vector.hpp"

namespace polygonal_perception::displays {

namespace {

enum PlaneColor
{
  kKind,
  kId
};

Ogre::ColourValue hue(float hue)
{
  Ogre::ColourValue color;
  color.setHSB(hue, 0.8F, 0.95F);
  return color;
}

}  // namespace

PlaneArrayDisplay::PlaneArrayDisplay()
{
  color_by_ = new rviz::EnumProperty("Color By", "Kind",
                                     "Kind: the floor is green, what is level cyan, upright violet, sloped "
                                     "yellow, and grey where nobody knows. Id: "
                                     "another color for each plane.",
                                     this, SLOT(redraw()));
  color_by_->addOption("Kind", kKind);
  color_by_->addOption("Id", kId);
  floor_ = new rviz::BoolProperty("Floor", true, "Show the floor, too.", this, SLOT(redraw()));
  alpha_ = new rviz::FloatProperty("Alpha", 0.35F, "Of the areas; 1 is opaque.", this, SLOT(redraw()));
  alpha_->setMin(0.0F);
  alpha_->setMax(1.0F);
  line_width_ = new rviz::FloatProperty("Line Width", 0.02F, "[m] of the outlines.", this, SLOT(redraw()));
  line_width_->setMin(0.001F);
}

PlaneArrayDisplay::~PlaneArrayDisplay() = default;

void PlaneArrayDisplay::onInitialize()
{
  NewestMessageDisplay::onInitialize();
  areas_ = std::make_unique<TriangleMesh>(*scene_manager_, *scene_node_);
  outlines_ = std::make_unique<RingLines>(*scene_manager_, *scene_node_);
}

void PlaneArrayDisplay::reset()
{
  NewestMessageDisplay::reset();
  message_.reset();
  areas_->clear();
  outlines_->clear();
}

void PlaneArrayDisplay::show(const PlaneArray::ConstPtr& message)
{
  message_ = message;
  redraw();
}

void PlaneArrayDisplay::redraw()
{
  if (!message_) return;
  std::size_t malformed = 0;
  std::vector<TriangleMesh::Corner> corners;
  std::vector<RingLines::Ring> rings;
  for (const Plane& plane : message_->planes) {
    if (!isDrawable(plane)) {
      ++malformed;
      continue;
    }
    if (plane.kind == Plane::FLOOR && !floor_->getBool()) continue;
    RingLines::Ring& ring = rings.emplace_back();
    ring.color = colorOf(plane);
    for (const Eigen::Vector3d& p : boundaryOf(plane)) ring.corners.push_back(toOgre(p));
    Ogre::ColourValue fill = ring.color;
    fill.a = alpha_->getFloat();
    for (const Eigen::Vector3d& p : trianglesOf(plane)) corners.push_back({toOgre(p), fill});
  }
  areas_->set(corners);
  outlines_->set(rings, line_width_->getFloat());
  const StatusLine status = planeStatus(*message_, malformed);
  setStatus(status.level, "Planes", status.text);
  context_->queueRender();
}

Ogre::ColourValue PlaneArrayDisplay::colorOf(const Plane& plane) const
{
  // Ids that follow one another get hues far apart.
  constexpr double kGoldenRatio = 0.618033988749895;
  if (color_by_->getOptionInt() == kId)
    return hue(static_cast<float>(std::fmod(plane.id * kGoldenRatio, 1.0)));
  switch (plane.kind) {
    case Plane::FLOOR:
      return hue(0.36F);
    case Plane::HORIZONTAL:
      return hue(0.52F);
    case Plane::VERTICAL:
      return hue(0.77F);
    case Plane::SLOPED:
      return hue(0.14F);
    default:
      return Ogre::ColourValue(0.6F, 0.6F, 0.6F);
  }
}

}  // namespace polygonal_perception::displays

PLUGINLIB_EXPORT_CLASS(polygonal_perception::displays::PlaneArrayDisplay, rviz::Display)
