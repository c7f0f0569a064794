#include "polygonal_perception/planning/arc_contact.hpp"

#include <algorithm>

#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::planning {

namespace {

/// The depth of a point on an arc behind a line that moves, from a time on at which it is known.
class Depth
{
public:
  Depth(const Arc& arc, const MovingEdge& edge, double level)
      : normal_(edge.normal()),
        speed_(arc.speed()),
        turn_rate_(arc.turnRate()),
        begin_(arc.begin()),
        recession_(normal_.dot(edge.velocity) - edge.growth),
        at_start_(normal_.dot(arc.start().position - edge.from) - level - kTouch),
        ahead_(normal_.dot(arc.direction())),
        aside_(normal_.x() * arc.direction().y() - normal_.y() * arc.direction().x())
  {
  }

  double speed() const { return speed_; }
  double turnRate() const { return turn_rate_; }
  /// [m/s] at which the line moves away.
  double recession() const { return recession_; }
  /// [rad] from the normal to the motion at time 0, if it had turned until then, too.
  double angle() const { return std::atan2(aside_, ahead_) - turn_rate_ * begin_; }

  struct Value
  {
    double depth;  // [m]
    double rate;   // [m/s]
  };
  Value at(double time) const
  {
    const double passed = time - begin_;
    const double half = 0.5 * turn_rate_ * passed;
    const double c = std::cos(half);
    const double s = std::sin(half);
    const double chord = speed_ * passed * sinc(half, s);
    return {at_start_ + chord * (ahead_ * c - aside_ * s) - recession_ * time,
            speed_ * (ahead_ * (1.0 - 2.0 * s * s) - aside_ * 2.0 * s * c) - recession_};
  }

private:
  Eigen::Vector2d normal_;
  double speed_;
  double turn_rate_;
  double begin_;
  double recession_;
  double at_start_;
  double ahead_;
  double aside_;
};

/// Where a depth that grows from low to high becomes positive.
std::optional<double> crossing(const Depth& depth, double low, double high)
{
  constexpr double kExact = 1e-12;  // [s]
  const double at_low = depth.at(low).depth;
  const double at_high = depth.at(high).depth;
  if (!(at_low <= 0.0) || !(at_high > 0.0)) return std::nullopt;
  double time = low + (high - low) * at_low / (at_low - at_high);
  // Bisection alone would need 40 steps for a bracket of a second.
  for (int i = 0; i < 100; ++i) {
    const Depth::Value at = depth.at(time);
    (at.depth > 0.0 ? high : low) = time;
    double next = time - at.depth / at.rate;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double step = std::abs(next - time);
    time = next;
    if (step < kExact) break;
  }
  return time;
}

bool isOnEdge(const Arc& arc, const MovingEdge& edge, double time)
{
  const double place = edge.along.dot(arc.position(time) - edge.from - time * edge.velocity);
  const double overlap = kEdgeOverlap + edge.growth * time;
  return place >= -overlap && place <= edge.length + overlap;
}

}  // namespace

double depthBehind(const MovingEdge& edge, const Eigen::Vector2d& point, double time)
{
  const Eigen::Vector2d normal = edge.normal();
  return normal.dot(point - edge.from) - (normal.dot(edge.velocity) - edge.growth) * time;
}

std::optional<double> firstContact(const Arc& arc, const MovingEdge& edge, double from, double to,
                                   double level)
{
  const Depth depth(arc, edge, level);
  // Too far away for the time that there is: most edges.
  if (depth.at(from).depth + (depth.speed() - depth.recession()) * (to - from) <= 0.0) return std::nullopt;
  const auto within = [&](double low, double high) -> std::optional<double> {
    const auto time = crossing(depth, std::max(low, from), std::min(high, to));
    return time && isOnEdge(arc, edge, *time) ? time : std::nullopt;
  };
  const double w = depth.turnRate();
  if (w == 0.0 || std::abs(depth.recession()) >= depth.speed()) return within(from, to);

  // The depth grows while the angle to the normal is within +-half of a whole number of turns.
  const double half = std::acos(depth.recession() / depth.speed());
  const double angle = depth.angle();
  const double first = std::floor((std::min(angle + w * from, angle + w * to) + half) / geometry::kTwoPi);
  const double last = std::ceil((std::max(angle + w * from, angle + w * to) - half) / geometry::kTwoPi);
  for (double k = w > 0.0 ? first : last; k >= first && k <= last; k += w > 0.0 ? 1.0 : -1.0) {
    const double centre = geometry::kTwoPi * k - angle;
    const double low = (centre + (w > 0.0 ? -half : half)) / w;
    const double high = (centre + (w > 0.0 ? half : -half)) / w;
    if (low >= to || high <= from) continue;
    if (const auto time = within(low, high)) return time;
  }
  return std::nullopt;
}

}  // namespace polygonal_perception::planning
