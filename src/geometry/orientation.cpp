#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "polygonal_perception/geometry/predicates.hpp"

// Every rounding counts here: CMakeLists.txt keeps the compiler from fusing products and sums. std::fma is
// called where a product's rounding error is wanted.
namespace polygonal_perception::geometry {

namespace {

Orientation signOf(double value)
{
  if (value > 0.0) return Orientation::kCounterClockwise;
  return value < 0.0 ? Orientation::kClockwise : Orientation::kCollinear;
}

/// An unevaluated sum, exactly what was computed: its value rounded, and the rounding error.
struct Exact
{
  double value;
  double error;
};

Exact sum(double a, double b)
{
  const double value = a + b;
  const double from_b = value - a;
  const double from_a = value - from_b;
  return {value, (a - from_a) + (b - from_b)};
}

Exact product(double a, double b)
{
  const double value = a * b;
  return {value, std::fma(a, b, -value)};
}

/// A sum of doubles that is never rounded: its terms do not overlap and grow in magnitude, so that the last
/// has the sign of all.
class Expansion
{
public:
  void add(const Exact& term)
  {
    add(term.error);
    add(term.value);
  }

  Orientation sign() const { return size_ == 0 ? Orientation::kCollinear : signOf(terms_[size_ - 1]); }

private:
  /// Shewchuk's GROW-EXPANSION, leaving out terms that are 0.
  void add(double term)
  {
    std::size_t size = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const Exact grown = sum(term, terms_[i]);
      if (grown.error != 0.0) terms_[size++] = grown.error;
      term = grown.value;
    }
    if (term != 0.0) terms_[size++] = term;
    size_ = size;
  }

  std::array<double, 12> terms_{};  // six products of two terms each
  std::size_t size_ = 0;
};

/// (a - c) x (b - c), multiplied out: the square of c cancels.
Orientation expandedOrientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  Expansion determinant;
  determinant.add(product(a.x(), b.y()));
  determinant.add(product(-a.x(), c.y()));
  determinant.add(product(-c.x(), b.y()));
  determinant.add(product(-a.y(), b.x()));
  determinant.add(product(a.y(), c.x()));
  determinant.add(product(c.y(), b.x()));
  return determinant.sign();
}

}  // namespace

Orientation exactOrientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  const Exact ax = sum(a.x(), -c.x());
  const Exact ay = sum(a.y(), -c.y());
  const Exact bx = sum(b.x(), -c.x());
  const Exact by = sum(b.y(), -c.y());
  // Points of a grid mostly have exact differences, and many of them lie on a line. Rounding keeps the order
  // of two products; where it makes them equal their errors decide.
  if (ax.error == 0.0 && ay.error == 0.0 && bx.error == 0.0 && by.error == 0.0) {
    const double left = ax.value * by.value;
    const double right = ay.value * bx.value;
    if (left != right) return signOf(left - right);
    return signOf(product(ax.value, by.value).error - product(ay.value, bx.value).error);
  }
  return expandedOrientation(a, b, c);
}

Orientation orientation(const RingView& ring)
{
  // A simple ring turns at its lowest leftmost vertex as it runs as a whole.
  const auto* lowest =
      std::min_element(ring.begin(), ring.end(), [](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
        return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
      });
  const auto k = static_cast<std::size_t>(lowest - ring.begin());
  return orientation(ring[ring.previous(k)], *lowest, ring[ring.next(k)]);
}

}  // namespace polygonal_perception::geometry
