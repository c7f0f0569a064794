#include "rviz/floor_shape.hpp"

#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <rviz/ogre_helpers/movable_text.h>

#include "rviz/ogre_vector.hpp"

namespace polygonal_perception::displays {

namespace {

std::unique_ptr<rviz::Arrow> makeNormal(Ogre::SceneManager& scene, Ogre::SceneNode& parent,
                                        const Eigen::Vector3d& foot, const Eigen::Vector3d& direction,
                                        const FloorStyle& style)
{
  // Lengths and diameters as shares of the whole length.
  const float length = style.normal_length;
  auto arrow = std::make_unique<rviz::Arrow>(&scene, &parent, 0.75F * length, 0.06F * length, 0.25F * length,
                                             0.14F * length);
  arrow->setPosition(toOgre(foot));
  arrow->setDirection(toOgre(direction));
  arrow->setColor(style.color);
  return arrow;
}

}  // namespace

FloorShape::FloorShape(Ogre::SceneManager& scene, Ogre::SceneNode& parent)
    : scene_(scene),
      mesh_(scene, parent),
      outlines_(scene, parent),
      parent_(&parent),
      text_node_(parent.createChildSceneNode())
{
}

FloorShape::~FloorShape()
{
  clear();
  scene_.destroySceneNode(text_node_);
}

void FloorShape::set(const std::vector<Eigen::Vector3d>& area, const Eigen::Vector3d& foot,
                     const Eigen::Vector3d& normal, const std::string& text, const FloorStyle& style)
{
  clear();
  setArea(area, style);
  if (style.normal) normal_ = makeNormal(scene_, *parent_, foot, normal, style);
  if (text.empty()) return;
  text_ = std::make_unique<rviz::MovableText>(text, "Liberation Sans", style.text_size);
  text_->setTextAlignment(rviz::MovableText::H_CENTER, rviz::MovableText::V_ABOVE);
  text_->setSpaceWidth(0.3F * style.text_size);
  text_node_->attachObject(text_.get());
  const double tip = (style.normal ? style.normal_length : 0.0F) + style.text_size / 2.0F;
  text_node_->setPosition(toOgre(foot + tip * normal));
}

void FloorShape::setArea(const std::vector<Eigen::Vector3d>& area, const FloorStyle& style)
{
  if (area.size() < 3) return;
  Ogre::ColourValue fill = style.color;
  fill.a *= style.alpha;
  std::vector<TriangleMesh::Corner> corners;
  for (std::size_t i = 2; i < area.size(); ++i) {
    for (const Eigen::Vector3d& corner : {area[0], area[i - 1], area[i]})
      corners.push_back({toOgre(corner), fill});
  }
  mesh_.set(corners);

  RingLines::Ring outline;
  outline.color = style.color;
  for (const Eigen::Vector3d& corner : area) outline.corners.push_back(toOgre(corner));
  outlines_.set({outline}, style.line_width);
}

void FloorShape::clear()
{
  mesh_.clear();
  outlines_.clear();
  normal_.reset();
  text_node_->detachAllObjects();
  text_.reset();
}

}  // namespace polygonal_perception::displays
