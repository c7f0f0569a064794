#include "floor_picture.hpp"

#include <opencv2/imgproc.hpp>

namespace polygonal_perception::evaluation {

cv::Mat3b drawFloor(const cv::Mat1f& depth, const perception::SampleGrid& grid,
                    const std::vector<perception::SampleLabel>& labels)
{
  constexpr double kFarthest = 6.0;  // [m] shown white
  cv::Mat1f shown = depth.clone();
  cv::patchNaNs(shown, 0.0);
  cv::Mat grey;
  shown.convertTo(grey, CV_8U, 255.0 / kFarthest);
  cv::Mat3b picture;
  cv::cvtColor(grey, picture, cv::COLOR_GRAY2BGR);
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const perception::Sample& sample = grid.samples()[k];
    cv::Scalar colour;
    switch (labels[k]) {
      case perception::SampleLabel::kNoPoint:
        continue;
      case perception::SampleLabel::kPruned:
        colour = cv::Scalar(60, 60, 220);
        break;
      case perception::SampleLabel::kSegment:
        colour = cv::Scalar(230, 140, 30);
        break;
      case perception::SampleLabel::kFloor:
        colour = cv::Scalar(60, 220, 60);
        break;
    }
    cv::circle(picture, cv::Point(sample.u, sample.v), 4, colour, cv::FILLED, cv::LINE_AA);
  }
  return picture;
}

}  // namespace polygonal_perception::evaluation
