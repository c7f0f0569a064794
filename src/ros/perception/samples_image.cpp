#include "ros/perception/samples_image.hpp"

#include <sensor_msgs/image_encodings.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace polygonal_perception::ros_perception {

namespace {

cv::Vec3b greyOf(float depth)
{
  constexpr float kNear = 0.5F;  // [m] and nearer is brightest
  if (!std::isfinite(depth)) return {0, 0, 0};
  const auto level = static_cast<std::uint8_t>(40.0F + 180.0F * kNear / std::max(depth, kNear));
  return {level, level, level};
}

cv::Scalar colourOf(perception::SampleLabel label)
{
  switch (label) {
    case perception::SampleLabel::kFloor:
      return {80, 200, 60};
    case perception::SampleLabel::kSegment:
      return {40, 200, 240};
    case perception::SampleLabel::kPruned:
      return {60, 60, 220};
    case perception::SampleLabel::kNoPoint:
      break;
  }
  return {110, 110, 110};
}

}  // namespace

sensor_msgs::ImagePtr toSamplesImage(const std_msgs::Header& header, const perception::PointView& points,
                                     const perception::SampleGrid& samples,
                                     const std::vector<perception::SampleLabel>& labels,
                                     const Eigen::Vector3d& forward)
{
  auto message = boost::make_shared<sensor_msgs::Image>();
  message->header = header;
  message->width = points.width();
  message->height = points.height();
  message->encoding = sensor_msgs::image_encodings::BGR8;
  message->step = 3 * points.width();
  message->data.resize(std::size_t{message->step} * message->height);

  cv::Mat image(static_cast<int>(points.height()), static_cast<int>(points.width()), CV_8UC3,
                message->data.data());
  const Eigen::Vector3f axis = forward.cast<float>();
  for (std::uint32_t v = 0; v < points.height(); ++v) {
    auto* const row = image.ptr<cv::Vec3b>(static_cast<int>(v));
    for (std::uint32_t u = 0; u < points.width(); ++u) row[u] = greyOf(axis.dot(points.point(u, v)));
  }
  const int spacing =
      std::min(image.cols / std::max(samples.samplesX(), 1), image.rows / std::max(samples.samplesY(), 1));
  const int radius = std::max(1, spacing / 4);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const perception::Sample& sample = samples.samples()[i];
    cv::circle(image, {sample.u, sample.v}, radius, colourOf(labels[i]), cv::FILLED);
  }
  return message;
}

}  // namespace polygonal_perception::ros_perception
