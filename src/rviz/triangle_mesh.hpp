#pragma once

#include <OgreColourValue.h>
#include <OgreManualObject.h>
#include <OgreMaterial.h>

#include <string>
#include <vector>

namespace polygonal_perception::displays {

/// Triangles in a scene, each corner with its colour, unlit and seen from both sides.
class TriangleMesh
{
public:
  struct Corner
  {
    Ogre::Vector3 position;  ///< in the frame of the parent node
    Ogre::ColourValue color;
  };

  TriangleMesh(Ogre::SceneManager& scene, Ogre::SceneNode& parent);
  ~TriangleMesh();
  TriangleMesh(const TriangleMesh&) = delete;
  TriangleMesh& operator=(const TriangleMesh&) = delete;

  /// Replaces what the mesh has shown.
  ///
  /// @param corners  three a triangle
  void set(const std::vector<Corner>& corners);

  void clear();

private:
  Ogre::SceneManager& scene_;
  std::string material_name_;
  Ogre::MaterialPtr material_;
  Ogre::ManualObject* object_;  ///< the scene's
};

}  // namespace polygonal_perception::displays
