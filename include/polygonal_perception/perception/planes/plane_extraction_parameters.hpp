#pragma once

#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/perception/input/sensor_noise.hpp"

namespace polygonal_perception::perception {

/// What decides which samples make a plane. What each is worth is measured in doc/floor_ablation.md.
struct PlaneExtractionParameters
{
  SensorNoise noise;

  /// [m] tau_l of algorithm 1: neighbours nearer by plane distance (eq. 5) lie on one surface.
  double cluster_distance = 0.01;
  /// The same where noise alone would part neighbours: both terms of eq. 5 hold the noise of two points and of a
  /// normal made of two more.
  double cluster_sigmas = 3.0;
  /// A sample of a plane has a normal whose cosine with the plane's is at least this: 26 degrees, two and a half
  /// times the noise of a sample's normal 4 m away.
  double normal_cosine = 0.9;
  /// A plane grows by samples within this many standard deviations of it.
  double growing_sigmas = 3.0;
  /// The share of the model's error, below, that holds while a plane grows and for the pixels it is fitted through: what
  /// a lens bends is nearly the same for neighbours. With all of it, planes 1.5 cm apart grow together 1 m away. Bent
  /// planes that fall into pieces are joined.
  double fitting_model_share = 0.3;
  /// What has grown, and what lies about, belongs to a plane within this many standard deviations: a little more
  /// than it grew by, for the final fit lies elsewhere.
  double inlier_sigmas = 3.5;
  /// [m], [m/m] What the noise does not hold, quantisation and lenses that bend, as a standard deviation: so much,
  /// and so much more for each metre of range.
  double model_error = 0.002;
  double model_error_slope = 0.0015;
  /// Samples that make a plane: fewer fit one by chance.
  double least_samples = 6;
  /// [rad] No surface is seen flatter than this: the samples of one row of the image lie on a plane through the
  /// camera, whatever they are of.
  double least_view_angle = 0.01;
  /// Pieces are one plane where the normals agree and the middle of each lies on the other, to this many standard
  /// deviations and what lenses bend: [rad]; [m]; [m/m] for each metre between the pieces. For pieces that touch it is
  /// enough that the planes agree there, to the model's error.
  double joining_sigmas = 3.0;
  double joining_angle = 0.035;
  double joining_offset = 0.004;
  double joining_offset_slope = 0.004;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    SensorNoise::describe(self.noise, visit);
    visit("cluster_distance", self.cluster_distance, parameters::Range{0.0, 1.0}, "m",
          "Plane distance below which neighbouring samples lie on one surface (tau_l).");
  }

  /// The rest, which users leave alone: for the ablation.
  template <class Self, class Visitor>
  static void describeThresholds(Self& self, Visitor&& visit)
  {
    visit("cluster_distance", self.cluster_distance);
    visit("cluster_sigmas", self.cluster_sigmas);
    visit("normal_cosine", self.normal_cosine);
    visit("growing_sigmas", self.growing_sigmas);
    visit("fitting_model_share", self.fitting_model_share);
    visit("inlier_sigmas", self.inlier_sigmas);
    visit("model_error", self.model_error);
    visit("model_error_slope", self.model_error_slope);
    visit("least_samples", self.least_samples);
    visit("least_view_angle", self.least_view_angle);
    visit("joining_sigmas", self.joining_sigmas);
    visit("joining_angle", self.joining_angle);
    visit("joining_offset", self.joining_offset);
    visit("joining_offset_slope", self.joining_offset_slope);
  }
};

}  // namespace polygonal_perception::perception
