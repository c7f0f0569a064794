#include "rviz/triangle_mesh.hpp"

#include <OgreMaterialManager.h>
#include <OgreResourceGroupManager.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreTechnique.h>

#include <algorithm>

namespace polygonal_perception::displays {

namespace {

/// Materials are found by their names, in all of rviz.
std::string uniqueMaterialName()
{
  static unsigned int count = 0;
  return "polygonal_perception/TriangleMesh/" + std::to_string(count++);
}

}  // namespace

TriangleMesh::TriangleMesh(Ogre::SceneManager& scene, Ogre::SceneNode& parent)
    : scene_(scene),
      material_name_(uniqueMaterialName()),
      material_(Ogre::MaterialManager::getSingleton().create(
          material_name_, Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME)),
      object_(scene.createManualObject())
{
  material_->setReceiveShadows(false);
  material_->setCullingMode(Ogre::CULL_NONE);
  material_->getTechnique(0)->setLightingEnabled(false);
  object_->setDynamic(true);
  parent.attachObject(object_);
}

TriangleMesh::~TriangleMesh()
{
  scene_.destroyManualObject(object_);
  Ogre::MaterialManager::getSingleton().remove(material_name_);
}

void TriangleMesh::set(const std::vector<Corner>& corners)
{
  clear();
  if (corners.empty()) return;
  const bool opaque = std::all_of(corners.begin(), corners.end(),
                                  [](const Corner& corner) { return corner.color.a >= 1.0F; });
  material_->setSceneBlending(opaque ? Ogre::SBT_REPLACE : Ogre::SBT_TRANSPARENT_ALPHA);
  // What is behind a pane of glass must not vanish because it is drawn later.
  material_->setDepthWriteEnabled(opaque);

  object_->estimateVertexCount(corners.size());
  object_->begin(material_name_, Ogre::RenderOperation::OT_TRIANGLE_LIST);
  for (const Corner& corner : corners) {
    object_->position(corner.position);
    object_->colour(corner.color);
  }
  object_->end();
}

void TriangleMesh::clear()
{
  object_->clear();
}

}  // namespace polygonal_perception::displays
