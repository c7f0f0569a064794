#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "perception/segmentation/plane_pieces.hpp"
#include "polygonal_perception/perception/segmentation/segmented_planes.hpp"

namespace polygonal_perception::perception {

/// Gives the pieces of a frame the ids that they had in the last one: a piece takes the id of that which lay at the same
/// place of the image, as far as the camera has not moved it, and faced the same way.
class PlaneIdentities
{
public:
  /// @param pieces    of the frame
  /// @param planes    one a piece, in the same order; their ids are set
  /// @param id_angle  [rad] by how much the normal of one plane may turn
  void assign(const NoisySamples& samples, const PlanePieces& pieces, double id_angle,
              std::vector<SegmentedPlane>& planes);

  void reset() { last_.clear(); }

private:
  struct Overlap
  {
    std::uint32_t cells = 0;
    std::size_t piece = 0;
    std::uint32_t last = 0;  // index into last_
  };
  struct Known
  {
    std::uint32_t id = 0;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    bool is_taken = false;
  };
  static constexpr std::uint32_t kNone = UINT32_MAX;

  void findOverlaps(const NoisySamples& samples, const PlanePieces& pieces);

  std::uint32_t next_id_ = 1;
  std::vector<Known> last_;                // the pieces of the last frame
  std::vector<std::uint32_t> last_piece_;  // of each sample, an index into last_, or kNone
  std::vector<std::uint32_t> counts_;  // of cells that a piece has in common with each of the last frame's
  std::vector<Overlap> overlaps_;
};

}  // namespace polygonal_perception::perception
