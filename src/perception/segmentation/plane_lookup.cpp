#include "perception/segmentation/plane_lookup.hpp"

#include <algorithm>

namespace polygonal_perception::perception {

void PlaneLookup::take(const PlaneExtraction& extraction, const std::vector<int>& plane_of,
                       const PlaneExtractionParameters& parameters)
{
  noise_ = parameters.noise;
  error_ = static_cast<float>(parameters.model_error);
  slope_ = static_cast<float>(parameters.model_error_slope);
  fitting_share_ = static_cast<float>(parameters.fitting_model_share);
  squared_sigmas_ = static_cast<float>(parameters.inlier_sigmas * parameters.inlier_sigmas);
  references_.clear();
  for (const ExtractedPlane& plane : extraction.planes()) references_.emplace_back(plane.fit.plane);

  const std::size_t columns = extraction.samples().columns;
  const std::size_t rows = plane_of.size() / columns;
  near_.resize(plane_of.size());
  for (std::size_t y = 0; y < rows; ++y) {
    for (std::size_t x = 0; x < columns; ++x) {
      Near& near = near_[y * columns + x];
      near.own = plane_of[y * columns + x];
      near.count = 0;
      int last = kNone;  // most often all nine are of one plane
      for (std::size_t at_y = y > 0 ? y - 1 : 0; at_y <= std::min(rows - 1, y + 1); ++at_y) {
        for (std::size_t at_x = x > 0 ? x - 1 : 0; at_x <= std::min(columns - 1, x + 1); ++at_x) {
          const int plane = plane_of[at_y * columns + at_x];
          if (plane == kNone || plane == last) continue;
          last = plane;
          const auto end = near.planes.begin() + near.count;
          if (std::find(near.planes.begin(), end, plane) == end) near.planes[near.count++] = plane;
        }
      }
    }
  }
}

}  // namespace polygonal_perception::perception
