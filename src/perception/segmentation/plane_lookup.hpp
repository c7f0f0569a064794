#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "perception/planes/plane_extraction.hpp"

namespace polygonal_perception::perception {

/// Says which plane a point of the cloud lies on: of those of the samples around it the nearest, in standard deviations.
/// Where two planes meet, and where one lies a little before another, neither takes the other's points.
class PlaneLookup
{
public:
  static constexpr int kNone = PlaneSegments::kNone;

  /// Takes the planes of a frame.
  /// @param plane_of  of each sample
  void take(const PlaneExtraction& extraction, const std::vector<int>& plane_of,
            const PlaneExtractionParameters& parameters);

  /// Replaces a plane by a better fit.
  void set(std::size_t plane, const geometry::Plane& fit) { references_[plane] = ReferencePlane(fit); }
  std::size_t size() const { return references_.size(); }

  /// Whether no other plane than this comes into question near a sample.
  bool isSettled(std::size_t sample, std::optional<std::size_t> plane) const
  {
    const Near& near = near_[sample];
    return near.count == 0 || (near.count == 1 && plane && near.planes[0] == static_cast<int>(*plane));
  }

  struct Answer
  {
    int plane = kNone;
    float variance = 0.0F;   ///< [m^2] of the point's distance from it
    bool is_close = false;   ///< whether it is near enough to be fitted
    bool is_on_own = false;  ///< whether it lies on the sample's plane, be it nearer to another or not
  };

  /// Looks for the plane of a point.
  /// @param sample  next to it
  Answer planeOf(std::size_t sample, const Eigen::Vector3f& point) const
  {
    Answer answer;
    const Near& near = near_[sample];
    const float range = point.norm();
    const float relative_noise = noise_.at(range) / range;
    const float model = error_ + slope_ * range;
    float least = squared_sigmas_;
    for (std::uint32_t k = 0; k < near.count; ++k) {
      const int plane = near.planes[k];
      const ReferencePlane& reference = references_[static_cast<std::size_t>(plane)];
      const float along = reference.normal.dot(point);
      const float height = along + reference.distance;
      const float noise = relative_noise * along;
      const float variance = noise * noise + model * model;
      const float deviation = height * height / variance;
      answer.is_on_own |= plane == near.own && deviation < squared_sigmas_;
      // Written so that NaN lies on none.
      if (!(deviation < least)) continue;
      least = deviation;
      answer.is_close = height * height <
                        squared_sigmas_ * (noise * noise + fitting_share_ * fitting_share_ * model * model);
      answer.plane = plane;
      answer.variance = variance;
    }
    return answer;
  }

private:
  /// The planes of a sample and its eight neighbours.
  struct Near
  {
    int own = kNone;
    std::uint32_t count = 0;
    std::array<int, 9> planes{};
  };

  SensorNoise noise_;
  float squared_sigmas_ = 0.0F;
  float fitting_share_ = 0.0F;  // of the model's error
  float error_ = 0.0F;          // [m], [m/m] what the noise does not hold
  float slope_ = 0.0F;
  std::vector<ReferencePlane> references_;
  std::vector<Near> near_;
};

}  // namespace polygonal_perception::perception
