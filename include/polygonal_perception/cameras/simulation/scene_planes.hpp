#pragma once

#include <cstdint>
#include <vector>

#include "polygonal_perception/cameras/simulation/solid.hpp"
#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/plane.hpp"

namespace polygonal_perception::simulation {

/// Which plane of a scene each triangle lies on. Triangles of one plane have one number, whatever they are part of: those
/// of a floor of several pieces, the fronts of two cupboards side by side.
class POLYGONAL_PERCEPTION_EXPORT ScenePlanes
{
public:
  /// Of what is curved: it lies on no plane.
  static constexpr std::uint16_t kNone = 0;

  ScenePlanes() = default;
  explicit ScenePlanes(const std::vector<Solid>& solids);

  /// The number of each triangle's plane, or kNone, in the order of the solids.
  const std::vector<std::uint16_t>& ofTriangles() const { return of_triangles_; }

  /// Plane number n, in the world frame; its normal may point to either side. @pre n != kNone
  const geometry::Plane& plane(std::uint16_t n) const { return planes_[n - 1U]; }
  /// Planes are numbered from 1 to this.
  std::size_t count() const { return planes_.size(); }

private:
  std::uint16_t numberOf(const geometry::Plane& plane);

  std::vector<geometry::Plane> planes_;
  std::vector<std::uint16_t> of_triangles_;
};

}  // namespace polygonal_perception::simulation
