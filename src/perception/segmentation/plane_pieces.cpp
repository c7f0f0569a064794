#include "perception/segmentation/plane_pieces.hpp"

namespace polygonal_perception::perception {

void PlanePieces::find(const PlaneExtraction& extraction, const PlaneExtractionParameters& parameters,
                       std::uint32_t least, double normal_margin)
{
  const NoisySamples& samples = extraction.samples();
  pieces_.clear();
  cells_.clear();
  completeEdges(extraction, parameters);
  resolveByNormal(extraction, parameters, normal_margin);
  counts_.assign(extraction.planes().size(), 0);
  for (const int plane : plane_of_) {
    if (plane != PlaneSegments::kNone) ++counts_[static_cast<std::size_t>(plane)];
  }
  for (std::size_t p = 0; p < extraction.planes().size(); ++p) {
    if (counts_[p] < least) continue;
    markCells(samples, static_cast<int>(p), ReferencePlane(extraction.planes()[p].fit.plane));
    collect(samples, static_cast<int>(p), least);
  }
}

void PlanePieces::completeEdges(const PlaneExtraction& extraction,
                                const PlaneExtractionParameters& parameters)
{
  const NoisySamples& samples = extraction.samples();
  const auto limit = static_cast<float>(parameters.inlier_sigmas * parameters.inlier_sigmas);
  plane_of_ = extraction.planeOf();
  // Twice: at a corner all neighbours are edge samples themselves.
  for (int round = 0; round < 2; ++round) {
    before_ = plane_of_;
    for (std::uint32_t k = 0; k < samples.size(); ++k) {
      if (before_[k] != PlaneSegments::kNone || !samples[k].has_point) continue;
      float nearest = limit;
      samples.forEachNeighbour(k, [&](std::uint32_t neighbour) {
        const int other = before_[neighbour];
        if (other == PlaneSegments::kNone) return;
        const ReferencePlane reference(extraction.planes()[static_cast<std::size_t>(other)].fit.plane);
        const float deviation = reference.deviation(samples[k]);
        if (!(deviation < nearest)) return;
        nearest = deviation;
        plane_of_[k] = other;
      });
    }
  }
}

/// Where two planes meet at a small angle, a ramp and the floor, samples of the one grow into the other along the line in
/// which they cross. Their normals tell, and a neighbour that went back takes those behind it along.
void PlanePieces::resolveByNormal(const PlaneExtraction& extraction,
                                  const PlaneExtractionParameters& parameters, double normal_margin)
{
  const NoisySamples& samples = extraction.samples();
  const auto limit = static_cast<float>(parameters.inlier_sigmas * parameters.inlier_sigmas);
  const auto look = [&](std::uint32_t k) {
    int& plane = plane_of_[k];
    if (plane == PlaneSegments::kNone || !samples[k].has_normal) return;
    float best = extraction.planes()[static_cast<std::size_t>(plane)].fit.plane.normal.cast<float>().dot(
                     samples[k].normal) +
                 static_cast<float>(normal_margin);
    samples.forEachNeighbour(k, [&](std::uint32_t neighbour) {
      const int other = plane_of_[neighbour];
      if (other == PlaneSegments::kNone || other == plane) return;
      const ReferencePlane reference(extraction.planes()[static_cast<std::size_t>(other)].fit.plane);
      const float cosine = reference.normal.dot(samples[k].normal);
      if (!(cosine > best) || !(reference.deviation(samples[k]) < limit)) return;
      best = cosine;
      plane = other;
    });
  };
  for (std::uint32_t k = 0; k < samples.size(); ++k) look(k);
  for (std::uint32_t k = samples.size(); k > 0; --k) look(k - 1);
}

/// The plane's samples, and those between two of them that a thing before the plane hides, or noise: the leg of a chair,
/// thinner than the grid is wide, does not part a floor.
void PlanePieces::markCells(const NoisySamples& samples, int plane, const ReferencePlane& reference)
{
  is_free_.assign(samples.size(), 0);
  const auto is_of_plane = [&](std::uint32_t k) { return plane_of_[k] == plane; };
  for (std::uint32_t k = 0; k < samples.size(); ++k) {
    if (is_of_plane(k)) {
      is_free_[k] = 1;
      continue;
    }
    const bool is_between =
        (!samples[k].begins_row && !samples[k].ends_row && is_of_plane(k - 1) && is_of_plane(k + 1)) ||
        (k >= samples.columns && k + samples.columns < samples.size() && is_of_plane(k - samples.columns) &&
         is_of_plane(k + samples.columns));
    if (is_between && (!samples[k].has_point || reference.height(samples[k].point) > 0.0F)) is_free_[k] = 1;
  }
}

void PlanePieces::collect(const NoisySamples& samples, int plane, std::uint32_t least)
{
  for (std::uint32_t k = 0; k < samples.size(); ++k) {
    if (is_free_[k] == 0) continue;
    Piece piece;
    piece.plane = static_cast<std::size_t>(plane);
    piece.first = static_cast<std::uint32_t>(cells_.size());
    const auto take = [&](std::uint32_t cell) {
      if (is_free_[cell] == 0) return;
      is_free_[cell] = 0;
      cells_.push_back(cell);
      piece.sample_count += plane_of_[cell] == plane ? 1 : 0;
    };
    take(k);
    for (std::size_t next = piece.first; next < cells_.size(); ++next)
      samples.forEachNeighbour(cells_[next], take);
    piece.size = static_cast<std::uint32_t>(cells_.size()) - piece.first;
    if (piece.sample_count >= least) {
      pieces_.push_back(piece);
    } else {
      cells_.resize(piece.first);
    }
  }
}

}  // namespace polygonal_perception::perception
