#include "floor_methods.hpp"

#include "reference/paper_floor_detector.hpp"

#ifdef POLYGONAL_PERCEPTION_HAS_PCL
#include <pcl/point_types.h>
#include <pcl/segmentation/sac_segmentation.h>
#endif

namespace polygonal_perception::evaluation {

namespace {

const Eigen::Vector3d kInitialUp = -Eigen::Vector3d::UnitY();

class ThisPackage : public FloorMethod
{
public:
  std::string name() const override { return "this package"; }
  void reset() override { tracker_.reset(); }
  void boundHeight(double highest) override
  {
    perception::FloorDetector::Parameters detector;
    detector.selection.max_camera_height = highest;
    tracker_.configure({}, detector);
  }
  Answer see(const perception::PointView& points, const perception::SampleGrid& grid, double stamp) override
  {
    const perception::FloorState& state = tracker_.update(points, grid, stamp, {});
    return {state.status, state.floor.plane, state.floor.covariance};
  }

private:
  perception::FloorTracker tracker_{perception::FloorTracker::Parameters{},
                                    perception::FloorDetector::Parameters{}};
};

/// A method without memory but for the up vector that it feeds back.
class Memoryless : public FloorMethod
{
public:
  void reset() override { up_ = kInitialUp; }
  void boundHeight(double /*highest*/) override {}
  Answer see(const perception::PointView& points, const perception::SampleGrid& grid,
             double /*stamp*/) override
  {
    const auto plane = detect(points, grid, up_);
    if (!plane) return {};
    up_ = plane->normal;
    return {perception::FloorStatus::kFound, *plane, std::nullopt};
  }

private:
  virtual std::optional<geometry::Plane> detect(const perception::PointView& points,
                                                const perception::SampleGrid& grid,
                                                const Eigen::Vector3d& up) = 0;

  Eigen::Vector3d up_ = kInitialUp;
};

class Paper : public Memoryless
{
public:
  std::string name() const override { return "paper"; }

private:
  std::optional<geometry::Plane> detect(const perception::PointView& /*points*/,
                                        const perception::SampleGrid& grid,
                                        const Eigen::Vector3d& up) override
  {
    return detector_.detect(grid, up);
  }

  reference::PaperFloorDetector detector_;
};

#ifdef POLYGONAL_PERCEPTION_HAS_PCL

class Ransac : public Memoryless
{
public:
  std::string name() const override { return "PCL RANSAC"; }

private:
  std::optional<geometry::Plane> detect(const perception::PointView& points,
                                        const perception::SampleGrid& /*grid*/,
                                        const Eigen::Vector3d& up) override
  {
    // A sixteenth of the points: as dense as such pipelines downsample to, and a second's work less for each
    // frame.
    constexpr std::uint32_t kStep = 4;
    pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
    for (std::uint32_t v = 0; v < points.height(); v += kStep) {
      for (std::uint32_t u = 0; u < points.width(); u += kStep) {
        const Eigen::Vector3f p = points.point(u, v);
        if (p.allFinite()) cloud->push_back({p.x(), p.y(), p.z()});
      }
    }
    pcl::SACSegmentation<pcl::PointXYZ> segmentation;
    segmentation.setModelType(pcl::SACMODEL_PERPENDICULAR_PLANE);
    segmentation.setMethodType(pcl::SAC_RANSAC);
    segmentation.setAxis(up.cast<float>());
    segmentation.setEpsAngle(kMaxTilt);
    segmentation.setDistanceThreshold(kThreshold);
    segmentation.setMaxIterations(kIterations);
    segmentation.setInputCloud(cloud);
    pcl::PointIndices inliers;
    pcl::ModelCoefficients model;
    segmentation.segment(inliers, model);
    if (model.values.size() != 4) return std::nullopt;
    geometry::Plane plane{{model.values[0], model.values[1], model.values[2]}, model.values[3]};
    if (plane.normal.dot(up) < 0.0) plane = {-plane.normal, -plane.distance};
    return plane;
  }

  static constexpr double kMaxTilt = 0.785;   // [rad] as ours
  static constexpr double kThreshold = 0.02;  // [m]
  static constexpr int kIterations = 500;
};

#endif

}  // namespace

std::vector<std::unique_ptr<FloorMethod>> makeFloorMethods()
{
  std::vector<std::unique_ptr<FloorMethod>> methods;
  methods.push_back(std::make_unique<ThisPackage>());
  methods.push_back(std::make_unique<Paper>());
#ifdef POLYGONAL_PERCEPTION_HAS_PCL
  methods.push_back(std::make_unique<Ransac>());
#endif
  return methods;
}

}  // namespace polygonal_perception::evaluation
