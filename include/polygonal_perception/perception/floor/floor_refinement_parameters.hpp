#pragma once

#include "polygonal_perception/parameters/parameter_table.hpp"

namespace polygonal_perception::perception {

/// What decides the final fit of the floor. What each is worth is measured in doc/floor_ablation.md.
struct FloorRefinementParameters
{
  /// A pixel counts as one of the floor within this many standard deviations of its height, but within
  /// inlier_distance [m].
  double inlier_sigmas = 3.0;
  double inlier_distance = 0.1;
  /// [m], [m/m] What the noise does not hold, quantisation and a lens that bends far floors, as a standard deviation:
  /// so much, and so much more for each metre of range. Without it the nearest points would decide alone, and a far
  /// floor would stand out of a plane that is tangential to the near one.
  double model_error = 0.003;
  double model_error_slope = 0.003;
  /// Sine of 20 degrees: where the surface between two rows runs more steeply than this, beyond the noise in so many
  /// standard deviations, it is the foot of a wall, which lies in the floor's band too but would tilt the fit.
  double steepest = 0.35;
  double steepest_sigmas = 2.0;
  /// What lies farther off than this many times the median distance (2.5 standard deviations) is dropped: the foot of a lamp is nearer to the floor than the noise alone could tell.
  double clip = 3.7;
  /// A fit through this many pixels errs by less than a camera's own calibration.
  double enough_pixels = 700;
  /// [rad] More uncertain than this it is no floor.
  double largest_normal_sigma = 0.02;
  /// Share of the pixels in the floor's band along which the surface runs. The plane along the noses of a staircase
  /// has many points near it, but the surface runs along it in a fifth to two fifths, on floors in more than half.
  double least_flat = 0.5;
  /// Planes that claim the pixels that lie nearer to them are parallel to this [rad], and so far off [m].
  double rival_angle = 0.35;
  double nearest_rival = 0.015;
  double farthest_rival = 0.4;

  /// A strip of floor that is narrower than the samples lie apart, below a platform: pixels so clearly below it, in
  /// standard deviations, with this model error [m/m], which is that of a camera's calibration: shiny and far floors
  /// have points below them, too.
  double strip_sigmas = 4.0;
  double strip_error_slope = 0.006;
  /// Of all pixels: fewer are no strip.
  double strip_support = 0.012;
  /// Their heights lie within this many standard deviations.
  double strip_width = 4.0;
  /// And so many times as densely as what lies between them and the platform, from so many standard deviations below it
  /// on: a floor that bends down has no gap.
  double strip_contrast = 2.0;
  double strip_gap_sigmas = 2.5;
  /// [rad] A strip is too narrow to know its own tilt: what lies under a platform is parallel to it, to this.
  double strip_normal_sigma = 0.005;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    visit("inlier_distance", self.inlier_distance, parameters::Range{0.001, 1.0}, "m",
          "What lies farther than this from the floor is not fitted to it, however uncertain it is.");
  }

  /// The rest, which users leave alone: for the ablation.
  template <class Self, class Visitor>
  static void describeThresholds(Self& self, Visitor&& visit)
  {
    visit("fit_sigmas", self.inlier_sigmas);
    visit("inlier_distance", self.inlier_distance);
    visit("fit_model_error", self.model_error);
    visit("fit_model_error_slope", self.model_error_slope);
    visit("steepest", self.steepest);
    visit("steepest_sigmas", self.steepest_sigmas);
    visit("clip", self.clip);
    visit("enough_pixels", self.enough_pixels);
    visit("largest_normal_sigma", self.largest_normal_sigma);
    visit("least_flat", self.least_flat);
    visit("rival_angle", self.rival_angle);
    visit("nearest_rival", self.nearest_rival);
    visit("farthest_rival", self.farthest_rival);
    visit("strip_sigmas", self.strip_sigmas);
    visit("strip_error_slope", self.strip_error_slope);
    visit("strip_support", self.strip_support);
    visit("strip_width", self.strip_width);
    visit("strip_contrast", self.strip_contrast);
    visit("strip_gap_sigmas", self.strip_gap_sigmas);
    visit("strip_normal_sigma", self.strip_normal_sigma);
  }
};

}  // namespace polygonal_perception::perception
