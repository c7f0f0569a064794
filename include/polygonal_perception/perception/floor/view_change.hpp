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
  struct Parameters
  {
    /// A sample whose range has changed by more than this share shows something else.
    double other_range = 0.15;
    /// It is another view where more than this share of the samples does: in recorded and rendered sequences at 30 Hz
    /// at most a third does from frame to frame.
    double most_changed = 0.5;
    /// Where fewer than this share of the samples has a range in both frames the view counts as the same.
    double least_compared = 0.1;

    template <class Self, class Visitor>
    static void describeThresholds(Self& self, Visitor&& visit)
    {
      visit("other_range", self.other_range);
      visit("most_changed", self.most_changed);
      visit("least_compared", self.least_compared);
    }
  };

  /// @return whether most samples of the frame are at another range than in the last one
  bool update(const SampleGrid& grid, const Parameters& parameters);

  /// Forgets the last frame; the next one is no change.
  void reset() { ranges_.clear(); }

private:
  std::vector<float> ranges_;  // [m] of the last frame, 0 = no return
};

}  // namespace polygonal_perception::perception
