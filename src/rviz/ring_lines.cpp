#include "rviz/ring_lines.hpp"

#include <algorithm>
#include <cstdint>

namespace polygonal_perception::displays {

namespace {

/// BillboardLine keeps room for as many points a line as the longest one has, and has a limit on them: rings
/// are drawn in pieces of so many edges.
constexpr std::size_t kMaxEdges = 64;

}  // namespace

void RingLines::set(const std::vector<Ring>& rings, float width)
{
  lines_.clear();
  std::size_t pieces = 0;
  std::size_t longest = 0;
  for (const Ring& ring : rings) {
    pieces += (ring.corners.size() + kMaxEdges - 1) / kMaxEdges;
    longest = std::max(longest, std::min(ring.corners.size(), kMaxEdges));
  }
  if (pieces == 0) return;
  lines_.setNumLines(static_cast<std::uint32_t>(pieces));
  lines_.setMaxPointsPerLine(static_cast<std::uint32_t>(longest + 1));
  lines_.setLineWidth(width);

  bool first_piece = true;
  for (const Ring& ring : rings) {
    for (std::size_t begin = 0; begin < ring.corners.size(); begin += kMaxEdges) {
      if (!first_piece) lines_.newLine();
      first_piece = false;
      const std::size_t end = std::min(begin + kMaxEdges, ring.corners.size());
      for (std::size_t i = begin; i <= end; ++i) {
        lines_.addPoint(ring.corners[i < ring.corners.size() ? i : 0], ring.color);
      }
    }
  }
}

}  // namespace polygonal_perception::displays
