#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <iterator>
#include <vector>

namespace polygonal_perception::geometry {

/// An edge of a ring, from one vertex to the next.
struct Edge
{
  const Eigen::Vector2d& from;
  const Eigen::Vector2d& to;
};

/// The edges of a ring, to go through once.
class RingEdges
{
public:
  class Iterator
  {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Edge;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = Edge;

    Iterator(const Eigen::Vector2d* at, const Eigen::Vector2d* first, const Eigen::Vector2d* end)
        : at_(at), first_(first), end_(end)
    {
    }

    Edge operator*() const { return {*at_, at_ + 1 == end_ ? *first_ : *(at_ + 1)}; }
    Iterator& operator++()
    {
      ++at_;
      return *this;
    }
    bool operator==(const Iterator& other) const { return at_ == other.at_; }
    bool operator!=(const Iterator& other) const { return at_ != other.at_; }

  private:
    const Eigen::Vector2d* at_;
    const Eigen::Vector2d* first_;
    const Eigen::Vector2d* end_;
  };

  RingEdges(const Eigen::Vector2d* first, const Eigen::Vector2d* end) : first_(first), end_(end) {}

  Iterator begin() const { return {first_, first_, end_}; }
  Iterator end() const { return {end_, first_, end_}; }

private:
  const Eigen::Vector2d* first_;
  const Eigen::Vector2d* end_;
};

/// The vertices of a ring, which somebody else owns, and its edges: edge k begins in vertex k, and the last
/// one leads back to vertex 0. A ring of one vertex has one edge, from that vertex to itself.
///
///     for (const auto [from, to] : ring.edges()) length += (to - from).norm();
class RingView
{
public:
  RingView(const Eigen::Vector2d* first, std::size_t size) : first_(first), size_(size) {}
  /// Implicit, so that what takes a ring takes a vector, too.
  RingView(const std::vector<Eigen::Vector2d>& vertices)  // NOLINT(google-explicit-constructor)
      : RingView(vertices.data(), vertices.size())
  {
  }

  const Eigen::Vector2d* begin() const { return first_; }
  const Eigen::Vector2d* end() const { return first_ + size_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const Eigen::Vector2d& operator[](std::size_t k) const { return first_[k]; }

  /// The vertex after vertex k, and the one before it.
  std::size_t next(std::size_t k) const { return k + 1 == size_ ? 0 : k + 1; }
  std::size_t previous(std::size_t k) const { return (k == 0 ? size_ : k) - 1; }

  RingEdges edges() const { return {begin(), end()}; }
  Edge edge(std::size_t k) const { return {first_[k], first_[next(k)]}; }

private:
  const Eigen::Vector2d* first_;
  std::size_t size_;
};

}  // namespace polygonal_perception::geometry
