#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "perception/planes/plane_extraction.hpp"
#include "perception/segmentation/curvature_fit.hpp"
#include "perception/segmentation/plane_lookup.hpp"
#include "polygonal_perception/perception/input/point_view.hpp"

namespace polygonal_perception::perception {

/// Fits the planes of a frame through many more pixels than the samples by which they were found, as the floor is
/// (algorithm 2, line 16): thirty samples 4 m away leave a degree of the normal open.
class PixelFit
{
public:
  struct Fit
  {
    PlaneFit::Result plane;
    Eigen::Matrix4d covariance;  // of the normal's three components [1] and the distance [m]
    /// Share of the points next to its samples that lie on it; 0 where they span no plane.
    double support = 0.0;
    CurvatureFit::Result bend;  // of a small plane's pixels
  };

  /// Fits all planes of a frame anew. Where the pixels of one span no plane, that of the samples stays.
  /// @param plane_of  of each sample
  /// @param known     a plane that is known better, the floor: nobody looks at pixels that can only be of it
  /// @param bending   planes of at most so many samples are looked at for curvature
  /// @param lookup    knows the planes by their samples, and then by the pixels; the known one stays what it is
  void fit(const PointView& points, const PlaneExtraction& extraction, const std::vector<int>& plane_of,
           const std::optional<std::size_t>& known, std::uint32_t bending, PlaneLookup& lookup);

  const Fit& operator[](std::size_t plane) const { return fits_[plane]; }

private:
  struct Pixel
  {
    std::uint32_t u = 0;       // its column
    std::uint32_t sample = 0;  // next to it
  };

  void takePlanes(const PlaneExtraction& extraction, const std::vector<int>& plane_of, std::uint32_t bending);
  void addPixels(const PointView& points, const NoisySamples& samples, const std::vector<int>& plane_of,
                 const std::optional<std::size_t>& known, const PlaneLookup& lookup);

  std::vector<Pixel> pixels_;           // of a row of the image, to look at
  std::vector<std::uint32_t> samples_;  // of each plane
  std::vector<PlaneFit> points_;
  std::vector<std::optional<CurvatureFit>> bends_;  // of the small ones
  std::vector<std::uint32_t> looked_at_;            // pixels next to the samples of each plane
  std::vector<std::uint32_t> on_;                   // those of them that lie on it
  std::vector<Fit> fits_;
};

}  // namespace polygonal_perception::perception
