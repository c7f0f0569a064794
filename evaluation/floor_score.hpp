#pragma once

#include <array>
#include <string>
#include <vector>

#include "floor_methods.hpp"
#include "polygonal_perception/geometry/plane.hpp"
#include "reference/error_statistics.hpp"

namespace polygonal_perception::evaluation {

/// Counts and errors of a method over a set of frames, as section "Floor" of the contract counts them.
class FloorScore
{
public:
  /// @param truth           nothing where no floor is in view
  /// @param floor_fraction  of the image that is floor
  void add(const Answer& answer, const std::optional<geometry::Plane>& truth, double floor_fraction);
  void add(const FloorScore& other);

  /// A row of a markdown table, without its first cells.
  std::string row() const;
  /// The head of these columns.
  static std::string head();
  static std::string rule();

  /// How honest the covariances were: the share of frames in which all three quantities lay within three standard
  /// deviations, and for each three of those over the error's 99 % quantile. Empty where the method gives none.
  std::string covarianceText() const;

  int wrong() const { return wrong_; }
  int off() const { return off_; }
  int missed() const { return missed_ + held_; }
  int guessed() const { return guessed_; }
  /// [deg] A quantile of the normals' errors.
  double degrees(double share) const;

private:
  std::vector<double> degrees_;
  std::vector<double> millimetres_;
  std::vector<std::array<reference::ErrorAndSigma, 3>> uncertainties_;
  int frames_ = 0;
  int wrong_ = 0;    // over 5 degrees or 5 cm, in a frame with at least 2 % floor
  int off_ = 0;      // right, but over 0.3 degrees or 5 mm
  int missed_ = 0;   // NOT_FOUND in such a frame
  int held_ = 0;     // HELD in such a frame
  int guessed_ = 0;  // a wrong plane in a frame with less floor, or none
};

}  // namespace polygonal_perception::evaluation
