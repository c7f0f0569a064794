#include "perception/planes/segment_joining.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::perception {

namespace {

/// Whether the middle of one piece lies on the other's plane, as far as that is known there.
bool isOn(const PlaneFit::Result& plane, const PlaneFit::Result& piece,
          const PlaneExtractionParameters& parameters)
{
  const double apart = (plane.centre - piece.centre).norm();
  return std::abs(plane.plane.height(piece.centre)) < parameters.joining_sigmas * plane.normal_sigma * apart +
                                                          parameters.joining_offset +
                                                          parameters.joining_offset_slope * apart;
}

/// @param contact  where they touch, if they do
bool areCoplanar(const PlaneFit::Result& a, const PlaneFit::Result& b,
                 const std::optional<Eigen::Vector3d>& contact, const PlaneExtractionParameters& parameters)
{
  const double angle = geometry::angleBetween(a.plane.normal, b.plane.normal);
  if (angle >=
      parameters.joining_sigmas * std::hypot(a.normal_sigma, b.normal_sigma) + parameters.joining_angle)
    return false;
  // What a lens bends goes on from one piece to the next, however far apart their middles are: where they touch, the two
  // planes are off by a model's error each. Over a step they are not.
  const bool goes_on =
      contact && std::abs(a.plane.height(*contact) - b.plane.height(*contact)) <
                     2.0 * (parameters.model_error + parameters.model_error_slope * contact->norm());
  return goes_on || (isOn(a, b, parameters) && isOn(b, a, parameters));
}

}  // namespace

void SegmentJoining::join(const PlaneExtractionParameters& parameters, SegmentContacts& contacts,
                          PlaneSegments& segments)
{
  by_size_.resize(segments.all.size());
  into_.resize(segments.all.size());
  std::iota(by_size_.begin(), by_size_.end(), std::size_t{0});
  std::sort(by_size_.begin(), by_size_.end(), [&](std::size_t a, std::size_t b) {
    return segments.all[a].points.count() > segments.all[b].points.count();
  });
  for (auto piece = by_size_.begin(); piece != by_size_.end(); ++piece) {
    const auto larger = std::find_if(by_size_.begin(), piece, [&](std::size_t other) {
      return into_[other] == static_cast<int>(other) &&
             areCoplanar(segments.all[other].fit, segments.all[*piece].fit, contacts.middle(other, *piece),
                         parameters);
    });
    into_[*piece] = static_cast<int>(*larger);  // itself, where it finds none before it
    if (larger == piece) continue;
    PlaneSegment& whole = segments.all[*larger];
    contacts.join(*piece, *larger);
    whole.points.add(segments.all[*piece].points);
    if (const auto fit = whole.points.solve(whole.fit.plane.normal)) whole.fit = *fit;
  }
  apply(segments);
}

bool SegmentJoining::has(const PlaneSegments& segments, const geometry::Plane& plane,
                         const PlaneExtractionParameters& parameters)
{
  return std::any_of(segments.all.begin(), segments.all.end(), [&](const PlaneSegment& segment) {
    const PlaneFit::Result known{plane, segment.fit.centre, 0.0, 0.0};
    return areCoplanar(segment.fit, known, std::nullopt, parameters);
  });
}

void SegmentJoining::apply(PlaneSegments& segments)
{
  number_.resize(into_.size());
  std::size_t kept = 0;
  for (std::size_t k = 0; k < into_.size(); ++k) {
    if (into_[k] != static_cast<int>(k)) continue;
    number_[k] = static_cast<int>(kept);
    segments.all[kept++] = segments.all[k];
  }
  for (std::size_t k = 0; k < into_.size(); ++k) into_[k] = number_[static_cast<std::size_t>(into_[k])];
  segments.all.resize(kept);
  segments.renumber(into_);
}

}  // namespace polygonal_perception::perception
