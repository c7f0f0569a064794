#include "polygonal_perception/perception/segmentation/plane_segmentation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "perception/segmentation/piece_boundary.hpp"
#include "perception/segmentation/pixel_fit.hpp"
#include "perception/segmentation/plane_identities.hpp"
#include "perception/segmentation/plane_pieces.hpp"

namespace polygonal_perception::perception {

namespace {

/// Whether a boundary runs round something, counter-clockwise as the camera sees it: that of a few noisy samples in a line
/// may not.
bool hasArea(const SegmentedPlanes& planes, const SegmentedPlane& plane)
{
  Eigen::Vector3f area = Eigen::Vector3f::Zero();
  const Eigen::Vector3f* const ring = planes.vertices.data() + plane.first_vertex;
  for (std::uint32_t k = 2; k < plane.vertex_count; ++k)
    area += (ring[k - 1] - ring[0]).cross(ring[k] - ring[0]);
  return plane.plane.normal.cast<float>().dot(area) > 0.0F;
}

PlaneKind kindOf(const PlaneFit::Result& fit, const std::optional<Eigen::Vector3d>& up,
                 const PlaneSegmentation::Parameters& parameters)
{
  if (!up) return PlaneKind::kUnknown;
  const double angle = parameters.kind_angle + parameters.kind_sigmas * fit.normal_sigma;
  const double cosine = std::abs(fit.plane.normal.dot(*up));
  if (cosine > std::cos(angle)) return PlaneKind::kHorizontal;
  return cosine < std::sin(angle) ? PlaneKind::kVertical : PlaneKind::kSloped;
}

}  // namespace

struct PlaneSegmentation::Workspace
{
  PlanePieces pieces;
  PlaneLookup lookup;
  PixelFit fit;
  PieceBoundary boundary;
  PlaneIdentities identities;
  std::vector<std::uint32_t> floor_samples;  // of each extracted plane
  std::optional<std::size_t> floor_plane;    // the extracted plane that is the floor

  void findFloor(const FloorDetector& detector, const FloorState& floor);
  bool isBorneOut(std::size_t plane, const Parameters& parameters,
                  const PlaneExtractionParameters& extracted_by) const;
  SegmentedPlane describe(const PlanePieces::Piece& piece, const FloorState& floor,
                          const std::optional<Eigen::Vector3d>& up, const Parameters& parameters) const;
};

PlaneSegmentation::PlaneSegmentation(const Parameters& parameters)
    : parameters_(parameters), workspace_(std::make_unique<Workspace>())
{
}
PlaneSegmentation::PlaneSegmentation(PlaneSegmentation&& other) noexcept = default;
PlaneSegmentation& PlaneSegmentation::operator=(PlaneSegmentation&& other) noexcept = default;
PlaneSegmentation::~PlaneSegmentation() = default;

/// The floor is the extracted plane most of whose samples are the floor's.
void PlaneSegmentation::Workspace::findFloor(const FloorDetector& detector, const FloorState& floor)
{
  floor_plane.reset();
  if (floor.status != FloorStatus::kFound) return;
  const PlaneExtraction& extraction = detector.extraction();
  floor_samples.assign(extraction.planes().size(), 0);
  for (std::size_t k = 0; k < detector.labels().size(); ++k) {
    const int plane = extraction.planeOf()[k];
    if (plane != PlaneSegments::kNone && detector.labels()[k] == SampleLabel::kFloor)
      ++floor_samples[static_cast<std::size_t>(plane)];
  }
  const auto most = std::max_element(floor_samples.begin(), floor_samples.end());
  if (most == floor_samples.end()) return;
  const auto index = static_cast<std::size_t>(most - floor_samples.begin());
  if (2 * *most > extraction.planes()[index].size) floor_plane = index;
}

/// Whether the pixels say that there is a plane, too.
bool PlaneSegmentation::Workspace::isBorneOut(std::size_t plane, const Parameters& parameters,
                                              const PlaneExtractionParameters& extracted_by) const
{
  const PlaneFit::Result& result = fit[plane].plane;
  const CurvatureFit::Result& bend = fit[plane].bend;
  return plane == floor_plane ||
         (fit[plane].support >= parameters.least_support &&
          bend.curvature - parameters.curvature_sigmas * bend.sigma <= parameters.largest_curvature &&
          result.normal_sigma <= parameters.largest_normal_sigma &&
          result.plane.distance >= extracted_by.least_view_angle * result.centre.norm());
}

/// All but the boundary and the id.
SegmentedPlane PlaneSegmentation::Workspace::describe(const PlanePieces::Piece& piece,
                                                      const FloorState& floor,
                                                      const std::optional<Eigen::Vector3d>& up,
                                                      const Parameters& parameters) const
{
  SegmentedPlane plane;
  plane.sample_count = piece.sample_count;
  if (piece.plane == floor_plane) {
    plane.kind = PlaneKind::kFloor;
    plane.plane = floor.floor.plane;
    plane.rms_error = floor.floor.rms_error;
    plane.covariance = floor.floor.covariance;
  } else {
    const auto& [result, covariance, support, bend] = fit[piece.plane];
    plane.kind = kindOf(result, up, parameters);
    plane.plane = result.plane;
    plane.rms_error = result.rms_error;
    plane.covariance = covariance;
  }
  return plane;
}

void PlaneSegmentation::segment(const PointView& points, const SampleGrid& grid,
                                const FloorDetector& detector, const FloorState& floor,
                                const std::optional<Eigen::Vector3d>& up, SegmentedPlanes& planes)
{
  Workspace& w = *workspace_;
  const PlaneExtraction& extraction = detector.extraction();
  const PlaneExtractionParameters& extracted_by = detector.parameters().planes;
  const NoisySamples& samples = extraction.samples();
  planes.clear();

  const double least = std::max(extracted_by.least_samples, parameters_.least_share * samples.size());
  w.pieces.find(extraction, extracted_by, static_cast<std::uint32_t>(std::ceil(least)),
                parameters_.normal_margin);
  w.findFloor(detector, floor);
  w.lookup.take(extraction, w.pieces.planeOf(), extracted_by);
  if (w.floor_plane) w.lookup.set(*w.floor_plane, floor.floor.plane);
  w.fit.fit(points, extraction, w.pieces.planeOf(), w.floor_plane,
            static_cast<std::uint32_t>(parameters_.bending_share * samples.size()), w.lookup);
  w.pieces.removeIf(
      [&](const PlanePieces::Piece& piece) { return !w.isBorneOut(piece.plane, parameters_, extracted_by); });

  while (planes.planes.size() < w.pieces.pieces().size()) {
    const std::size_t index = planes.planes.size();
    const PlanePieces::Piece& piece = w.pieces.pieces()[index];
    SegmentedPlane plane = w.describe(piece, floor, up, parameters_);
    plane.first_vertex = static_cast<std::uint32_t>(planes.vertices.size());
    w.boundary.trace(points, grid, w.lookup, w.pieces.cells().data(), piece, plane.plane, planes.vertices);
    plane.vertex_count = static_cast<std::uint32_t>(planes.vertices.size()) - plane.first_vertex;
    if (hasArea(planes, plane)) {
      planes.planes.push_back(plane);
    } else {
      planes.vertices.resize(plane.first_vertex);
      w.pieces.remove(index);
    }
  }
  w.identities.assign(samples, w.pieces, parameters_.id_angle, planes.planes);
  std::sort(planes.planes.begin(), planes.planes.end(), [](const SegmentedPlane& a, const SegmentedPlane& b) {
    return a.sample_count != b.sample_count ? a.sample_count > b.sample_count : a.id < b.id;
  });
}

void PlaneSegmentation::reset()
{
  workspace_->identities.reset();
}

}  // namespace polygonal_perception::perception
