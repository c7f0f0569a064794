// What others take for the same frame, or for a part of the work.

#include <benchmark/benchmark.h>
#include <pcl/features/integral_image_normal.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>
#include <pcl/segmentation/sac_segmentation.h>
#include <pcl_conversions/pcl_conversions.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <cstring>

#include "camera_frames.hpp"
#include "reference/paper_floor_detector.hpp"
#include "reference/paper_obstacle_detector.hpp"

namespace polygonal_perception::benchmarks {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

const CameraFrame& office()
{
  static const auto kFrames = drive(Surroundings::kOffice, 640, 480, 1);
  return *kFrames.front();
}

sensor_msgs::PointCloud2 officeMessage()
{
  sensor_msgs::PointCloud2 message;
  message.width = office().width();
  message.height = office().height();
  sensor_msgs::PointCloud2Modifier(message).setPointCloud2FieldsByString(1, "xyz");
  message.is_dense = 0U;
  std::memcpy(message.data.data(), office().cloud16().data(), message.data.size());
  return message;
}

Cloud::Ptr officeCloud()
{
  Cloud::Ptr cloud(new Cloud);
  pcl::fromROSMsg(officeMessage(), *cloud);
  return cloud;
}

void fromRosMessage(benchmark::State& state)
{
  const sensor_msgs::PointCloud2 message = officeMessage();
  Cloud cloud;
  for (auto _ : state) pcl::fromROSMsg(message, cloud);
}

void ransacPlane(benchmark::State& state)
{
  const Cloud::Ptr cloud = officeCloud();
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setModelType(pcl::SACMODEL_PLANE);
  segmentation.setMethodType(pcl::SAC_RANSAC);
  segmentation.setDistanceThreshold(0.02);
  segmentation.setInputCloud(cloud);
  pcl::PointIndices inliers;
  pcl::ModelCoefficients plane;
  for (auto _ : state) segmentation.segment(inliers, plane);
}

void organisedNormals(benchmark::State& state)
{
  const Cloud::Ptr cloud = officeCloud();
  pcl::PointCloud<pcl::Normal> normals;
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod(estimation.COVARIANCE_MATRIX);
  estimation.setMaxDepthChangeFactor(0.02F);
  estimation.setNormalSmoothingSize(20.0F);
  for (auto _ : state) {
    estimation.setInputCloud(cloud);
    estimation.compute(normals);
  }
}

void organisedMultiPlane(benchmark::State& state)
{
  const Cloud::Ptr cloud = officeCloud();
  const pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod(estimation.COVARIANCE_MATRIX);
  estimation.setMaxDepthChangeFactor(0.02F);
  estimation.setNormalSmoothingSize(20.0F);
  pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label> segmentation;
  segmentation.setMinInliers(1000);
  for (auto _ : state) {
    estimation.setInputCloud(cloud);
    estimation.compute(*normals);
    segmentation.setInputCloud(cloud);
    segmentation.setInputNormals(normals);
    std::vector<pcl::PlanarRegion<pcl::PointXYZ>, Eigen::aligned_allocator<pcl::PlanarRegion<pcl::PointXYZ>>>
        regions;
    segmentation.segmentAndRefine(regions);
  }
}

void paperPolygonisation(benchmark::State& state)
{
  reference::PaperObstacleDetector paper;
  const perception::PointView points = office().view(Input::kCloud16);
  for (auto _ : state) benchmark::DoNotOptimize(paper.process(points, office().floor()).data());
}

void wholePaper(benchmark::State& state)
{
  reference::PaperObstacleDetector polygonisation;
  reference::PaperFloorDetector detector;
  perception::SampleGrid samples{perception::SampleGrid::Parameters{}};
  Eigen::Vector3d up = office().floor().normal;
  const perception::PointView points = office().view(Input::kCloud16);
  for (auto _ : state) {
    samples.update(points);
    const auto floor = detector.detect(samples, up);
    if (!floor) {
      state.SkipWithError("no floor found");
      break;
    }
    up = floor->normal;
    benchmark::DoNotOptimize(polygonisation.process(points, *floor).data());
  }
}

BENCHMARK(fromRosMessage)->Name("pcl::fromROSMsg")->Unit(benchmark::kMicrosecond);
BENCHMARK(ransacPlane)->Name("pcl::SACSegmentation")->Unit(benchmark::kMicrosecond);
BENCHMARK(organisedNormals)->Name("pcl::IntegralImageNormalEstimation")->Unit(benchmark::kMicrosecond);
BENCHMARK(organisedMultiPlane)
    ->Name("pcl::OrganizedMultiPlaneSegmentation, normals included")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(paperPolygonisation)->Name("section IV of the paper")->Unit(benchmark::kMicrosecond);
BENCHMARK(wholePaper)->Name("sections III and IV of the paper")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace polygonal_perception::benchmarks

BENCHMARK_MAIN();
