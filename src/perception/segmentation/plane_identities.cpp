#include "perception/segmentation/plane_identities.hpp"

#include <algorithm>
#include <cmath>

namespace polygonal_perception::perception {

void PlaneIdentities::assign(const NoisySamples& samples, const PlanePieces& pieces, double id_angle,
                             std::vector<SegmentedPlane>& planes)
{
  if (last_piece_.size() != samples.size()) reset();
  findOverlaps(samples, pieces);
  std::sort(overlaps_.begin(), overlaps_.end(), [](const Overlap& a, const Overlap& b) {
    if (a.cells != b.cells) return a.cells > b.cells;
    return a.piece != b.piece ? a.piece < b.piece : a.last < b.last;
  });
  const double least_cosine = std::cos(id_angle);
  for (SegmentedPlane& plane : planes) plane.id = 0;
  for (const Overlap& overlap : overlaps_) {
    SegmentedPlane& plane = planes[overlap.piece];
    Known& known = last_[overlap.last];
    if (plane.id != 0 || known.is_taken || plane.plane.normal.dot(known.normal) < least_cosine) continue;
    plane.id = known.id;
    known.is_taken = true;
  }

  last_.clear();
  last_piece_.assign(samples.size(), kNone);
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (planes[p].id == 0) planes[p].id = next_id_++;
    last_.push_back({planes[p].id, planes[p].plane.normal, false});
    const PlanePieces::Piece& piece = pieces.pieces()[p];
    for (std::uint32_t c = piece.first; c < piece.first + piece.size; ++c)
      last_piece_[pieces.cells()[c]] = static_cast<std::uint32_t>(p);
  }
}

void PlaneIdentities::findOverlaps(const NoisySamples& samples, const PlanePieces& pieces)
{
  overlaps_.clear();
  if (last_.empty()) return;
  for (std::size_t p = 0; p < pieces.pieces().size(); ++p) {
    const PlanePieces::Piece& piece = pieces.pieces()[p];
    counts_.assign(last_.size(), 0);
    const auto count = [&](std::uint32_t k) {
      if (last_piece_[k] != kNone) ++counts_[last_piece_[k]];
    };
    for (std::uint32_t c = piece.first; c < piece.first + piece.size; ++c) {
      // And its neighbours: what is one sample high may have moved by one.
      count(pieces.cells()[c]);
      samples.forEachNeighbour(pieces.cells()[c], count);
    }
    for (std::uint32_t last = 0; last < counts_.size(); ++last) {
      if (counts_[last] > 0) overlaps_.push_back({counts_[last], p, last});
    }
  }
}

}  // namespace polygonal_perception::perception
