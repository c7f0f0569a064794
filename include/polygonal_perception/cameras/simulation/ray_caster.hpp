#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

#include "polygonal_perception/cameras/simulation/pinhole_camera.hpp"
#include "polygonal_perception/cameras/simulation/scene.hpp"
#include "polygonal_perception/cameras/simulation/scene_planes.hpp"
#include "polygonal_perception/export.hpp"

namespace polygonal_perception::simulation {

/// What an ideal camera sees, a value a pixel, row by row.
struct RayImage
{
  std::vector<float> depth;        ///< [m] along the optical axis; NaN where the ray meets nothing
  std::vector<float> cosine;       ///< of the angle between the ray and the surface's normal
  std::vector<float> reflectance;  ///< of the surface
  std::vector<Surface> surface;
  std::vector<std::uint16_t>
      plane;  ///< which of RayCaster::planes() the surface is part of, or ScenePlanes::kNone
};

/// Casts a ray through the centre of each pixel of a camera in a scene.
class POLYGONAL_PERCEPTION_EXPORT RayCaster
{
public:
  /// @param scene  must outlive the caster
  explicit RayCaster(const Scene& scene);
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /// @param camera_to_world  from the optical frame (x right, y down, z forward) into the world
  /// @param time             [s] moves the people
  /// @param image            resized if need be
  void cast(const PinholeCamera& camera, const Eigen::Isometry3d& camera_to_world, double time,
            RayImage& image);

  /// The planes of all that stands still.
  const ScenePlanes& planes() const;

private:
  class Device;
  std::unique_ptr<Device> device_;
};

}  // namespace polygonal_perception::simulation
