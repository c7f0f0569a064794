#pragma once

#include <string>
#include <vector>

#include "polygon_methods.hpp"

namespace polygonal_perception::evaluation {

/// What all methods are held against on a frame.
struct PolygonReference
{
  std::size_t vertices;  ///< of plain Douglas-Peucker on the contours of the inflated cells, as clause 5 says
  double area;           ///< [m^2] that safety needs
};

PolygonReference makePolygonReference(const PolygonTask& task);

/// Sizes, times and broken clauses of a method over a set of frames.
class PolygonScore
{
public:
  /// @param microseconds  that the method took
  void add(const PolygonTask& task, const PolygonReference& reference, const geometry::PolygonSet& polygons,
           double microseconds);
  void add(const PolygonScore& other);

  /// A row of a markdown table, without its first cells.
  std::string row() const;
  /// The head of these columns.
  static std::string head();
  static std::string rule();
  bool keepsTheContract() const { return crossing_ + unsafe_ + loose_ == 0; }

private:
  std::size_t frames_ = 0;
  std::size_t vertices_ = 0;
  std::size_t reference_vertices_ = 0;
  std::size_t large_ = 0;  // frames with over 1.2 times the reference's vertices
  double worst_vertices_ = 0.0;
  std::size_t crossing_ = 0;  // frames in which clause 1 or 2 is broken
  std::size_t unsafe_ = 0;    // clause 3
  std::size_t loose_ = 0;     // clause 4
  std::vector<double> areas_;
  std::vector<double> microseconds_;
};

}  // namespace polygonal_perception::evaluation
