#pragma once

#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/perception/planes/sample_grid.hpp"

namespace polygonal_perception::perception {

/// Tells a camera that moves from one that was put elsewhere between two frames: carried off with its lens
/// covered, held up by a stall, or played from another recording. What was known about the last view says
/// nothing about the new one.
class POLYGONAL_PERCEPTION_EXPORT ViewChange
{
public:
  /// @return whether most samples of the frame are at another range than in the last one: more than half of
  ///         them by more than 15 %. Where fewer than a tenth of the samples can be compared the view counts
  ///         as the same. In recorded and rendered sequences at 30 Hz at most a third of the samples change
  ///         so much.
  bool update(const SampleGrid& grid);

  /// Forgets the last frame; the next one is no change.
  void reset() { ranges_.clear(); }

private:
  std::vector<float> ranges_;  // [m] of the last frame, 0 = no return
};

}  // namespace polygonal_perception::perception
