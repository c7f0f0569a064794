#pragma once

#include <rviz/ogre_helpers/arrow.h>

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "rviz/ring_lines.hpp"
#include "rviz/triangle_mesh.hpp"

namespace rviz {
class MovableText;
}

namespace polygonal_perception::displays {

/// How a floor is drawn.
struct FloorStyle
{
  Ogre::ColourValue color;     ///< its alpha is that of the outline and the normal
  float alpha = 0.3F;          ///< of the area
  float line_width = 0.02F;    ///< [m]
  bool normal = true;          ///< whether to draw it
  float normal_length = 0.5F;  ///< [m]
  float text_size = 0.1F;      ///< [m] height of a letter
};

/// A floor in a scene: an area, the normal as an arrow, and a text over it.
class FloorShape
{
public:
  FloorShape(Ogre::SceneManager& scene, Ogre::SceneNode& parent);
  ~FloorShape();
  FloorShape(const FloorShape&) = delete;
  FloorShape& operator=(const FloorShape&) = delete;

  /// Replaces what was shown.
  ///
  /// @param area    corners of the convex area, in the frame of the parent node
  /// @param foot    where the normal stands
  /// @param normal  unit vector
  /// @param text    at the tip of the normal; empty for none
  void set(const std::vector<Eigen::Vector3d>& area, const Eigen::Vector3d& foot,
           const Eigen::Vector3d& normal, const std::string& text, const FloorStyle& style);

  void clear();

private:
  void setArea(const std::vector<Eigen::Vector3d>& area, const FloorStyle& style);

  Ogre::SceneManager& scene_;
  TriangleMesh mesh_;
  RingLines outlines_;
  Ogre::SceneNode* parent_;              ///< the display's
  Ogre::SceneNode* text_node_;           ///< the scene's
  std::unique_ptr<rviz::Arrow> normal_;  ///< null where it is not shown: rviz shows all that hangs on a node
  std::unique_ptr<rviz::MovableText> text_;
};

}  // namespace polygonal_perception::displays
