#pragma once

#include <string>
#include <vector>

#include "floor_methods.hpp"
#include "polygonal_perception/geometry/plane.hpp"

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

private:
  std::vector<double> degrees_;
  std::vector<double> millimetres_;
  int frames_ = 0;
  int wrong_ = 0;    // over 5 degrees or 5 cm, in a frame with at least 2 % floor
  int missed_ = 0;   // NOT_FOUND in such a frame
  int held_ = 0;     // HELD in such a frame
  int guessed_ = 0;  // a wrong plane in a frame with less floor, or none
};

}  // namespace polygonal_perception::evaluation
