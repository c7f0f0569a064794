#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::geometry {

/// Sweeps a line over all edges, from left to right, and stops at the first contact: a point that two edges have in common,
/// but for the vertex of two that follow one another. (M. I. Shamos and D. Hoey, *Geometric Intersection Problems*, 1976.)
/// Where there is none it knows which ring lies in which.
///
/// The line leans by an infinitely small angle: of points with one x the one with the least y comes first, so that no edge
/// lies along it. Up to the first contact the edges that it crosses have an order, from below, and those that meet are
/// neighbours before they do. So neighbours are all that has to be compared: n log n for n edges, wherever they lie.
class RingSweep
{
public:
  static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

  /// Of all rings of a set, of at least 3 finite vertices each, none repeated.
  explicit RingSweep(const PolygonSet& polygons) : RingSweep(polygons, 0, polygons.rings.size()) {}
  /// Of one of its rings.
  RingSweep(const PolygonSet& polygons, std::size_t ring) : RingSweep(polygons, ring, ring + 1) {}
  RingSweep(const RingSweep&) = delete;
  RingSweep& operator=(const RingSweep&) = delete;

  /// An edge, and where it is from.
  struct PlacedEdge
  {
    Edge edge;
    std::uint32_t ring;
  };
  /// Two edges that meet, in the order in which the set has them.
  struct Contact
  {
    PlacedEdge first;
    PlacedEdge second;
  };

  /// @return the first contact from the left, or one of those that begin there
  std::optional<Contact> run();

  /// Of each ring the innermost one around it, or kNone. @pre run() has found no contact
  const std::vector<std::uint32_t>& around() const { return around_; }

private:
  // Vertices have numbers from 0 on, ring after ring, and edges those of the vertices that they begin with.

  RingSweep(const PolygonSet& polygons, std::size_t first, std::size_t last);

  /// The order in which the line crosses edges.
  struct Below
  {
    const RingSweep& sweep;
    bool operator()(std::uint32_t a, std::uint32_t b) const;
  };
  using Crossed = std::set<std::uint32_t, Below>;

  std::uint32_t next(std::uint32_t vertex) const;
  std::uint32_t previous(std::uint32_t vertex) const;
  bool isBefore(std::uint32_t a, std::uint32_t b) const;
  /// Of an edge its first end from the left, and its last.
  std::uint32_t left(std::uint32_t edge) const { return isBefore(edge, next(edge)) ? edge : next(edge); }
  std::uint32_t right(std::uint32_t edge) const { return isBefore(edge, next(edge)) ? next(edge) : edge; }
  Contact contact(std::uint32_t a, std::uint32_t b) const;
  std::optional<Contact> contactOf(std::uint32_t a, std::uint32_t b) const;
  std::optional<Contact> pass(std::uint32_t vertex);
  std::optional<Contact> leave(std::uint32_t edge);
  std::optional<Contact> enter(std::uint32_t edge);
  void noteRing(std::uint32_t vertex);

  std::uint32_t first_ring_;  // of the set; from it on rings have numbers from 0 on here, too
  std::vector<Eigen::Vector2d> vertices_;
  std::vector<std::uint32_t> ring_of_;  // of each vertex
  std::vector<std::uint32_t> begin_;    // of each ring's vertices, and where the last one's end
  std::vector<std::uint32_t> order_;    // vertices from left to right
  std::vector<std::uint32_t> around_;   // by ring
  std::vector<bool> is_known_;          // by ring: whether the line has come to it
  std::vector<bool> runs_left_;  // by ring: whether what it encloses lies above its edges that run left
  Crossed crossed_;
  std::vector<Crossed::iterator> places_;  // of each edge that is crossed
};

}  // namespace polygonal_perception::geometry
