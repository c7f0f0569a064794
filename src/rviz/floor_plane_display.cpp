#include "rviz/floor_plane_display.hpp"

#include <rviz/properties/bool_property.h>
#include <rviz/properties/color_property.h>
#include <rviz/properties/enum_property.h>
#include <rviz/properties/float_property.h>

#include <pluginlib/class_list_macros.hpp>

#include "rviz/message_geometry.hpp"
#include "rviz/message_status.hpp"

namespace polygonal_perception::displays {

namespace {

enum Area
{
  kHull,
  kPatch,
  kNoArea
};

constexpr float kHeldFloorAlpha = 0.4F;  // a floor that is not seen is paler

}  // namespace

FloorPlaneDisplay::FloorPlaneDisplay()
{
  area_ = new rviz::EnumProperty("Area", "Hull",
                                 "The hull of the floor's samples, a square patch of the plane, or none.",
                                 this, SLOT(redraw()));
  area_->addOption("Hull", kHull);
  area_->addOption("Patch", kPatch);
  area_->addOption("None", kNoArea);
  patch_size_ =
      new rviz::FloatProperty("Patch Size", 4.0F, "[m] length of its sides.", area_, SLOT(redraw()), this);
  patch_size_->setMin(0.01F);
  color_ =
      new rviz::ColorProperty("Color", QColor(26, 102, 255), "Of area and normal.", this, SLOT(redraw()));
  alpha_ = new rviz::FloatProperty("Alpha", 0.2F, "Of the area; 1 is opaque.", this, SLOT(redraw()));
  alpha_->setMin(0.0F);
  alpha_->setMax(1.0F);
  line_width_ =
      new rviz::FloatProperty("Line Width", 0.02F, "[m] of the area's outline.", this, SLOT(redraw()));
  line_width_->setMin(0.001F);
  show_normal_ = new rviz::BoolProperty(
      "Normal", true, "Draw the normal where the floor is under the camera.", this, SLOT(redraw()));
  normal_length_ =
      new rviz::FloatProperty("Length", 0.5F, "[m] of the normal.", show_normal_, SLOT(redraw()), this);
  normal_length_->setMin(0.01F);
  show_height_ = new rviz::BoolProperty("Height", true, "Write the camera's height above the floor.", this,
                                        SLOT(redraw()));
  text_size_ = new rviz::FloatProperty("Text Size", 0.12F, "[m] height of a letter.", show_height_,
                                       SLOT(redraw()), this);
  text_size_->setMin(0.01F);
}

FloorPlaneDisplay::~FloorPlaneDisplay() = default;

void FloorPlaneDisplay::onInitialize()
{
  NewestMessageDisplay::onInitialize();
  shape_ = std::make_unique<FloorShape>(*scene_manager_, *scene_node_);
}

void FloorPlaneDisplay::reset()
{
  NewestMessageDisplay::reset();
  message_.reset();
  shape_->clear();
}

void FloorPlaneDisplay::show(const FloorPlane::ConstPtr& message)
{
  message_ = message;
  const StatusLine status = floorStatus(*message);
  setStatus(status.level, "Floor", status.text);
  redraw();
}

void FloorPlaneDisplay::redraw()
{
  patch_size_->setHidden(area_->getOptionInt() != kPatch);
  if (!message_) return;
  context_->queueRender();
  if (message_->status == FloorPlane::NOT_FOUND || !isDrawable(*message_)) {
    shape_->clear();
    return;
  }

  FloorStyle style;
  style.color = color_->getOgreColor();
  if (message_->status != FloorPlane::FOUND) style.color.a = kHeldFloorAlpha;
  style.alpha = alpha_->getFloat();
  style.line_width = line_width_->getFloat();
  style.normal = show_normal_->getBool();
  style.normal_length = normal_length_->getFloat();
  style.text_size = text_size_->getFloat();

  std::vector<Eigen::Vector3d> area;
  if (area_->getOptionInt() == kHull) area = hullOf(*message_);
  if (area_->getOptionInt() == kPatch) area = patchOf(*message_, patch_size_->getFloat());
  const Eigen::Vector3d normal(message_->normal.x, message_->normal.y, message_->normal.z);
  shape_->set(area, footOf(*message_), normal, text(), style);
}

std::string FloorPlaneDisplay::text() const
{
  if (!show_height_->getBool()) return {};
  const QString height = QString("%1 m").arg(message_->distance, 0, 'f', 2);
  if (message_->status == FloorPlane::ASSUMED) return (height + " (assumed)").toStdString();
  return (message_->status == FloorPlane::HELD ? height + " (held)" : height).toStdString();
}

}  // namespace polygonal_perception::displays

PLUGINLIB_EXPORT_CLASS(polygonal_perception::displays::FloorPlaneDisplay, rviz::Display)
