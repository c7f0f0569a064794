#pragma once

#include <cstdint>
#include <vector>

#include "polygonal_perception/cameras/simulation/pinhole_camera.hpp"
#include "polygonal_perception/cameras/simulation/ray_caster.hpp"
#include "polygonal_perception/export.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"

namespace polygonal_perception::simulation {

/// Turns ideal depth into what a structured-light sensor of the PrimeSense family (Xtion, first Kinect)
/// returns.
///
/// Every effect has its own switch. A frame's noise depends on the seed and the frame's number alone.
class POLYGONAL_PERCEPTION_EXPORT DepthNoise
{
public:
  struct Parameters
  {
    double sigma_base = 0.0012;       ///< [m] sigma_z = base + quadratic (z - onset)^2
    double sigma_quadratic = 0.0019;  ///< [1/m] 0, with sigma_base 0: no random error
    double sigma_onset = 0.4;         ///< [m]
    double correlation =
        1.5;  ///< [px] standard deviation of the kernel that makes neighbours alike; 0 = white
    double baseline = 0.075;         ///< [m] from camera to projector
    double disparity_focal = 570.3;  ///< [px] focal length at the resolution at which the sensor matches
    double disparity_step = 0.125;   ///< [px] 0: no steps
    bool shadows = true;             ///< what the projector does not light has no return
    double edge_loss = 0.5;          ///< share of the pixels beside a jump of depth that have no return
    int edge_width = 2;              ///< [px] on each side of a jump
    double edge_jitter = 2.0;        ///< [px] how ragged edges are
    double blobs = 6.0;              ///< holes a frame, on average
    double blob_radius = 12.0;       ///< [px] at a width of 640; drawn up to twice and down to a fifth of it
    int dead_columns = 8;  ///< [px] at the right end, at a width of 640: the matcher's window ends there
    double grazing_cosine = 0.10;  ///< surfaces seen flatter than about this have no return
    double dark_range =
        11.0;                ///< [m] a surface of reflectance r is seen up to this times sqrt(r); 0 = all are
    double min_range = 0.4;  ///< [m]
    double max_range = 8.0;  ///< [m]

    /// No effect but the limits of range that the rays have anyway.
    static Parameters none();

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit)
    {
      visit("sigma_base", self.sigma_base, parameters::Range{0.0, 0.1}, "m", "Depth error at sigma_onset.");
      visit("sigma_quadratic", self.sigma_quadratic, parameters::Range{0.0, 0.1}, "1/m",
            "Growth of the error with depth squared.");
      visit("sigma_onset", self.sigma_onset, parameters::Range{0.0, 5.0}, "m",
            "Depth from which the error grows.");
      visit("correlation", self.correlation, parameters::Range{0.0, 8.0}, "px",
            "Smoothness of the error across the image.");
      visit("baseline", self.baseline, parameters::Range{0.001, 1.0}, "m", "From camera to projector.");
      visit("disparity_focal", self.disparity_focal, parameters::Range{10.0, 5000.0}, "px",
            "Focal length of the matcher.");
      visit("disparity_step", self.disparity_step, parameters::Range{0.0, 4.0}, "px",
            "Quantisation of disparity; 0 = none.");
      visit("edge_loss", self.edge_loss, parameters::Range{0.0, 1.0}, "",
            "Share of the pixels at edges that are lost.");
      visit("edge_width", self.edge_width, parameters::Range{1, 20}, "px",
            "How far edges reach to each side.");
      visit("edge_jitter", self.edge_jitter, parameters::Range{0.0, 8.0}, "px", "Raggedness of edges.");
      visit("blobs", self.blobs, parameters::Range{0.0, 1000.0}, "", "Holes a frame.");
      visit("blob_radius", self.blob_radius, parameters::Range{0.0, 200.0}, "px",
            "Their size at a width of 640.");
      visit("dead_columns", self.dead_columns, parameters::Range{0, 640}, "px",
            "At the right end, at a width of 640.");
      visit("grazing_cosine", self.grazing_cosine, parameters::Range{0.0, 1.0}, "",
            "Flatter surfaces are lost.");
      visit("dark_range", self.dark_range, parameters::Range{0.0, 100.0}, "m",
            "Range on a perfectly bright surface; 0 = any.");
      visit("min_range", self.min_range, parameters::Range{0.0, 10.0}, "m", "Nearer surfaces are lost.");
      visit("max_range", self.max_range, parameters::Range{0.0, 1000.0}, "m", "Farther surfaces are lost.");
    }
  };

  /// @throws std::invalid_argument, naming the parameter, when one is out of its range
  DepthNoise(const Parameters& parameters, std::uint64_t seed);
  const Parameters& parameters() const { return parameters_; }

  /// @param frame  the frame's number; each has noise of its own
  /// @param depth  [m], NaN where there is no return; resized if need be
  void apply(const PinholeCamera& camera, const RayImage& image, std::uint32_t frame,
             std::vector<float>& depth);

private:
  void markDropouts(const PinholeCamera& camera, const RayImage& image, std::uint64_t frame_seed);
  /// Normal numbers that are the same over a patch of pixels.
  float patchField(const PinholeCamera& camera, std::size_t u, std::size_t v) const;
  /// The pixel whose surface is taken for that of (u, v), at an edge.
  std::size_t strayed(const PinholeCamera& camera, std::size_t u, std::size_t v, std::uint64_t bits) const;
  bool reflects(const RayImage& image, std::size_t i, float field) const;
  float measured(float depth, float field) const;

  Parameters parameters_;
  std::uint64_t seed_;
  std::vector<float> field_;  // correlated, standard normal
  std::vector<float> scratch_;
  std::vector<float> disparity_;  // [px] of the ideal image, 0 = no return
  std::vector<std::uint8_t> lost_;
  std::vector<std::uint8_t> edge_;
};

}  // namespace polygonal_perception::simulation
