#include "reference/douglas_peucker.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace polygonal_perception::reference {

std::size_t verticesOfDouglasPeucker(const occupancy::BinaryGrid& cells, double tolerance, std::size_t least)
{
  // Older releases of OpenCV take the image's outermost pixels for free.
  cv::Mat1b image(cells.cellsY() + 2, cells.cellsX() + 2, std::uint8_t{0});
  for (int j = 0; j < cells.cellsY(); ++j)
    std::copy_n(cells.row(j), cells.cellsX(), image.ptr<std::uint8_t>(j + 1) + 1);
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(image, contours, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  std::size_t count = 0;
  for (auto& contour : contours) {
    cv::approxPolyDP(contour, contour, tolerance, true);
    count += std::max(least, contour.size());
  }
  return count;
}

}  // namespace polygonal_perception::reference
