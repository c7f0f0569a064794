#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "perception/planes/plane_extraction.hpp"

namespace polygonal_perception::perception {

/// Which samples of a frame belong to which plane, and in which connected pieces.
class PlanePieces
{
public:
  struct Piece
  {
    std::size_t plane = 0;           // an extracted plane
    std::uint32_t sample_count = 0;  // without what was bridged
    std::uint32_t first = 0;         // its cells are cells()[first .. first + size), indices into the grid
    std::uint32_t size = 0;
  };

  /// Finds the pieces of a frame anew.
  /// @param least          samples that make a piece
  /// @param normal_margin  by which the cosine with a neighbour's plane must be larger for a sample to go over to it
  void find(const PlaneExtraction& extraction, const PlaneExtractionParameters& parameters,
            std::uint32_t least, double normal_margin);

  /// Leaves out pieces of the frame.
  template <class Predicate>
  void removeIf(Predicate&& predicate)
  {
    pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(), predicate), pieces_.end());
  }

  void remove(std::size_t index) { pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(index)); }

  const std::vector<Piece>& pieces() const { return pieces_; }
  const std::vector<std::uint32_t>& cells() const { return cells_; }
  /// The plane of each sample, or PlaneSegments::kNone. More samples have one here than in the extraction: at the edge
  /// of a plane a sample has no normal of its own, or a wrong one.
  const std::vector<int>& planeOf() const { return plane_of_; }

private:
  void completeEdges(const PlaneExtraction& extraction, const PlaneExtractionParameters& parameters);
  void resolveByNormal(const PlaneExtraction& extraction, const PlaneExtractionParameters& parameters,
                       double normal_margin);
  void markCells(const NoisySamples& samples, int plane, const ReferencePlane& reference);
  void collect(const NoisySamples& samples, int plane, std::uint32_t least);

  std::vector<int> plane_of_;
  std::vector<int> before_;            // the same, before a round of completion
  std::vector<std::uint32_t> counts_;  // samples of each plane
  std::vector<std::uint8_t> is_free_;  // of each sample: a cell of the plane at hand, in no piece yet
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> cells_;
};

}  // namespace polygonal_perception::perception
