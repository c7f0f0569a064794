#include "reference/plane_checker.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "reference/error_statistics.hpp"

namespace polygonal_perception::reference {

namespace {

using simulation::ScenePlanes;
using simulation::SimulatedFrame;

constexpr double kLargeEnough = 0.03;  // of the image, for a true plane to count
constexpr double kInvented = 0.01;     // of the image, for a found one
constexpr double kOverlap = 0.8;
constexpr double kDegrees = 1.0;
constexpr double kMillimetres = 10.0;
constexpr double kNearer = 0.05;      // [m] before the plane: it covers it
constexpr double kPartOfPiece = 0.1;  // of a connected piece, for a plane to be one of those on it

template <class... Values>
std::string print(const char* format, Values... values)
{
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// [deg] One standard deviation of a plane's normal.
double degreesKnown(const perception::SegmentedPlane& plane)
{
  constexpr double kDegreesPerRadian = 57.29577951308232;
  return kDegreesPerRadian * std::sqrt(plane.covariance.topLeftCorner<3, 3>().trace());
}

}  // namespace

/// A true plane, in the image.
struct PlaneChecker::True
{
  std::uint16_t number;
  int pixels;
  cv::Mat1b mask;
};

/// A plane that was found, in the image.
struct PlaneChecker::Found
{
  const perception::SegmentedPlane* plane = nullptr;
  cv::Mat1b mask;
  int pixels = 0;
  std::uint16_t number = ScenePlanes::kNone;   // of the true plane that it is of
  std::uint16_t nearest = ScenePlanes::kNone;  // of that which fills most of it
  double share = 0.0;                          // how much
  std::uint16_t second = ScenePlanes::kNone;   // of that which fills most of the rest
};

void PlaneCounts::add(const PlaneCounts& other)
{
  for (auto count : {&PlaneCounts::frames, &PlaneCounts::listed, &PlaneCounts::true_ones, &PlaneCounts::found,
                     &PlaneCounts::uncovered, &PlaneCounts::off, &PlaneCounts::split, &PlaneCounts::invented,
                     &PlaneCounts::pairs, &PlaneCounts::kept}) {
    this->*count += other.*count;
  }
  degrees.insert(degrees.end(), other.degrees.begin(), other.degrees.end());
  millimetres.insert(millimetres.end(), other.millimetres.begin(), other.millimetres.end());
  faults.insert(faults.end(), other.faults.begin(), other.faults.end());
}

PlaneChecker::PlaneChecker(const simulation::SimulatedCamera& camera, int samples_x, int samples_y)
    : camera_(camera),
      stride_x_(static_cast<int>(camera.options().camera.width) / samples_x),
      stride_y_(static_cast<int>(camera.options().camera.height) / samples_y)
{
}

geometry::Plane PlaneChecker::truePlane(const SimulatedFrame& frame, std::uint16_t number) const
{
  const geometry::Plane& world = camera_.planes().plane(number);
  geometry::Plane plane;
  plane.normal = frame.camera_to_world.linear().transpose() * world.normal;
  plane.distance = world.height(frame.camera_to_world.translation());
  if (plane.distance < 0.0) {
    plane.normal = -plane.normal;
    plane.distance = -plane.distance;
  }
  return plane;
}

PlaneChecker::Found PlaneChecker::look(const SimulatedFrame& frame, const perception::SegmentedPlanes& planes,
                                       const perception::SegmentedPlane& plane) const
{
  const simulation::PinholeCamera& camera = camera_.options().camera;
  const auto columns = static_cast<int>(camera.width);
  const auto rows = static_cast<int>(camera.height);
  Found found;
  found.plane = &plane;
  found.mask = cv::Mat1b::zeros(rows, columns);
  std::vector<std::vector<cv::Point>> ring(1);
  for (std::uint32_t k = 0; k < plane.vertex_count; ++k) {
    const Eigen::Vector3f& p = planes.vertices[plane.first_vertex + k];
    ring[0].emplace_back(static_cast<int>(std::lround(camera.cx + camera.fx * p.x() / p.z())),
                         static_cast<int>(std::lround(camera.cy + camera.fy * p.y() / p.z())));
  }
  if (ring[0].size() < 3) return found;
  cv::fillPoly(found.mask, ring, 1);

  std::map<std::uint16_t, int> pixels;
  int uncovered = 0;
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < columns; ++u) {
      if (found.mask(v, u) == 0) continue;
      ++found.pixels;
      const std::size_t k = static_cast<std::size_t>(v) * camera.width + static_cast<std::size_t>(u);
      if (!(frame.truth.depth[k] > 0.0F)) continue;
      const Eigen::Vector3d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
      if (frame.truth.depth[k] < -plane.plane.distance / plane.plane.normal.dot(ray) - kNearer) continue;
      ++uncovered;
      ++pixels[frame.truth.plane[k]];
    }
  }
  pixels.erase(ScenePlanes::kNone);
  std::vector<std::pair<int, std::uint16_t>> by_count;
  by_count.reserve(pixels.size());
  for (const auto& [number, count] : pixels) by_count.emplace_back(count, number);
  std::sort(by_count.rbegin(), by_count.rend());
  if (!by_count.empty()) {
    found.nearest = by_count[0].second;
    found.share = static_cast<double>(by_count[0].first) / uncovered;
  }
  if (by_count.size() > 1) found.second = by_count[1].second;
  if (found.share >= kOverlap) found.number = found.nearest;
  return found;
}

void PlaneChecker::add(const SimulatedFrame& frame, const perception::SegmentedPlanes& planes)
{
  const simulation::PinholeCamera& camera = camera_.options().camera;
  ++counts_.frames;
  counts_.listed += static_cast<int>(planes.planes.size());
  const std::map<std::uint16_t, std::vector<Found>> found_on = findOwners(frame, planes);

  cv::Mat1w numbers(static_cast<int>(camera.height), static_cast<int>(camera.width));
  for (std::size_t k = 0; k < camera.size(); ++k)
    numbers(static_cast<int>(k)) = frame.depth[k] > 0.0F ? frame.truth.plane[k] : ScenePlanes::kNone;
  std::vector<int> pixels(camera_.planes().count() + 1, 0);
  for (const std::uint16_t number : numbers) ++pixels[number];
  std::map<std::uint16_t, std::uint32_t> ids;
  for (std::size_t k = 1; k < pixels.size(); ++k) {
    const auto number = static_cast<std::uint16_t>(k);
    if (pixels[number] < kLargeEnough * static_cast<double>(camera.size())) continue;
    ++counts_.true_ones;
    const True truth{number, pixels[number], numbers == number};
    const auto found = found_on.find(number);
    if (!isCovered(frame, truth, found == found_on.end() ? std::vector<Found>{} : found->second)) continue;
    const Found& largest =
        *std::max_element(found->second.begin(), found->second.end(),
                          [](const Found& a, const Found& b) { return a.pixels < b.pixels; });
    judgeFit(frame, truth, *largest.plane);
    countSplits(frame, truth, found->second);
    ids[number] = largest.plane->id;
    if (const auto last = last_ids_.find(number); last != last_ids_.end()) {
      ++counts_.pairs;
      counts_.kept += last->second == largest.plane->id ? 1 : 0;
    }
  }
  last_ids_ = ids;
}

/// The planes that were found, by the true plane that they are of; the others are invented.
std::map<std::uint16_t, std::vector<PlaneChecker::Found>> PlaneChecker::findOwners(
    const SimulatedFrame& frame, const perception::SegmentedPlanes& planes)
{
  std::map<std::uint16_t, std::vector<Found>> found_on;
  for (const perception::SegmentedPlane& plane : planes.planes) {
    Found found = look(frame, planes, plane);
    if (found.number != ScenePlanes::kNone) {
      found_on[found.number].push_back(found);
    } else if (found.pixels >= kInvented * static_cast<double>(camera_.options().camera.size())) {
      ++counts_.invented;
      fault(frame,
            print("invented: %d pixels, %.0f %% of them on plane %d, which is %.1f deg from it; %u samples "
                  "%.1f m away, its normal known to %.1f deg",
                  found.pixels, 100.0 * found.share, int{found.nearest},
                  found.nearest == ScenePlanes::kNone
                      ? 180.0
                      : normalError(plane.plane, truePlane(frame, found.nearest)),
                  plane.sample_count, double{planes.vertices[plane.first_vertex].z()}, degreesKnown(plane)) +
                besides(frame, planes, found));
    }
  }
  return found_on;
}

/// What an invented plane lies on besides, if that is parallel: the step, in standard deviations of the depth there.
std::string PlaneChecker::besides(const SimulatedFrame& frame, const perception::SegmentedPlanes& planes,
                                  const Found& found) const
{
  if (found.second == ScenePlanes::kNone) return "";
  const geometry::Plane nearest = truePlane(frame, found.nearest);
  const geometry::Plane second = truePlane(frame, found.second);
  if (normalError(nearest, second) > kDegrees) return "";
  const Eigen::Vector3d point = planes.vertices[found.plane->first_vertex].cast<double>();
  const double step = std::abs(nearest.height(point) - second.height(point));
  return print(", the rest on plane %d, %.0f mm or %.1f sigma beside it", int{found.second}, 1000.0 * step,
               step / sigmaAt(point.z()));
}

/// [m] Standard deviation of the depth.
double PlaneChecker::sigmaAt(double depth) const
{
  const simulation::DepthNoise::Parameters& noise = camera_.options().noise;
  return noise.sigma_base + noise.sigma_quadratic * std::pow(depth - noise.sigma_onset, 2);
}

bool PlaneChecker::isCovered(const SimulatedFrame& frame, const True& truth, const std::vector<Found>& found)
{
  cv::Mat1b covered = cv::Mat1b::zeros(truth.mask.size());
  for (const Found& one : found) covered |= one.mask;
  cv::dilate(covered, covered, cv::Mat1b::ones(2 * stride_y_ + 1, 2 * stride_x_ + 1));
  const int pixels = cv::countNonZero(covered & truth.mask);
  if (!found.empty() && pixels >= kOverlap * truth.pixels) return true;
  ++counts_.uncovered;
  fault(frame, print("uncovered: plane %d, %d pixels, %d of them under %zu planes", int{truth.number},
                     truth.pixels, pixels, found.size()));
  return false;
}

void PlaneChecker::judgeFit(const SimulatedFrame& frame, const True& truth,
                            const perception::SegmentedPlane& plane)
{
  const simulation::PinholeCamera& camera = camera_.options().camera;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < camera.size(); ++k) {
    if (truth.mask(static_cast<int>(k)) == 0) continue;
    const std::size_t row = k / camera.width;
    const auto u = static_cast<double>(k - row * camera.width);
    const auto v = static_cast<double>(row);
    middle +=
        frame.truth.depth[k] * Eigen::Vector3d((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
  }
  middle /= truth.pixels;
  const double degrees = normalError(plane.plane, truePlane(frame, truth.number));
  const double millimetres = 1000.0 * std::abs(plane.plane.height(middle));
  counts_.degrees.push_back(degrees);
  counts_.millimetres.push_back(millimetres);
  // Of 3 % of the image there are thirty samples.
  if (degrees <= kDegrees &&
      millimetres <= kMillimetres + 1000.0 * 3.0 * sigmaAt(middle.z()) / std::sqrt(30.0)) {
    ++counts_.found;
    return;
  }
  ++counts_.off;
  fault(frame,
        print("off: plane %d, %d pixels, %.1f m away, by %.2f deg and %.1f mm; its normal known to %.1f deg",
              int{truth.number}, truth.pixels, middle.z(), degrees, millimetres, degreesKnown(plane)));
}

void PlaneChecker::countSplits(const SimulatedFrame& frame, const True& truth,
                               const std::vector<Found>& found)
{
  // What hangs together by less than a neck of one and a half samples is two pieces.
  cv::Mat1b pieces;
  cv::morphologyEx(truth.mask, pieces, cv::MORPH_CLOSE, cv::Mat1b::ones(9, 9));
  cv::erode(pieces, pieces, cv::Mat1b::ones(3 * stride_y_ / 2, 3 * stride_x_ / 2));
  cv::Mat1i piece_of;
  const int count = cv::connectedComponents(pieces, piece_of);
  for (int piece = 1; piece < count; ++piece) {
    const cv::Mat1b here = piece_of == piece;
    const int pixels = cv::countNonZero(here);
    if (pixels < kInvented * static_cast<double>(camera_.options().camera.size())) continue;
    const auto planes_here = std::count_if(found.begin(), found.end(), [&](const Found& one) {
      return cv::countNonZero(one.mask & here) > kPartOfPiece * pixels;
    });
    if (planes_here <= 1) continue;
    counts_.split += static_cast<int>(planes_here) - 1;
    fault(frame, print("split: plane %d, a piece of %d pixels, into %d", int{truth.number}, pixels,
                       static_cast<int>(planes_here)));
  }
}

void PlaneChecker::fault(const SimulatedFrame& frame, const std::string& text)
{
  counts_.faults.push_back(camera_.options().scene + ", " + camera_.options().trajectory + ", frame " +
                           std::to_string(frame.index) + ": " + text);
}

}  // namespace polygonal_perception::reference
