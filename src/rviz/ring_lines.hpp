#pragma once

#include <OgreColourValue.h>
#include <rviz/ogre_helpers/billboard_line.h>

#include <vector>

namespace polygonal_perception::displays {

/// Closed lines of a width in a scene.
class RingLines
{
public:
  struct Ring
  {
    std::vector<Ogre::Vector3> corners;  ///< in the frame of the parent node; the first is not repeated
    Ogre::ColourValue color;
  };

  RingLines(Ogre::SceneManager& scene, Ogre::SceneNode& parent) : lines_(&scene, &parent) {}

  /// Replaces what was shown.
  ///
  /// @param width  [m]
  void set(const std::vector<Ring>& rings, float width);

  void clear() { lines_.clear(); }

private:
  rviz::BillboardLine lines_;
};

}  // namespace polygonal_perception::displays
