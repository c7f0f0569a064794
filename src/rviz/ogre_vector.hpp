#pragma once

#include <OgreVector3.h>

#include <Eigen/Core>

namespace polygonal_perception::displays {

inline Ogre::Vector3 toOgre(const Eigen::Vector3d& p)
{
  return {static_cast<Ogre::Real>(p.x()), static_cast<Ogre::Real>(p.y()), static_cast<Ogre::Real>(p.z())};
}

}  // namespace polygonal_perception::displays
