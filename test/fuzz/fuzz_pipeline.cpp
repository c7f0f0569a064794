// The core on frames of arbitrary numbers: infinities, denormals, huge ones, the same point everywhere.
#include "byte_reader.hpp"
#include "result_check.hpp"

namespace polygonal_perception::test {
namespace {

/// A frame in memory of its own; its numbers repeat when the bytes are used up.
struct AnyFrame
{
  perception::PinholeRays rays;
  std::vector<float> metres;
  std::vector<std::uint16_t> millimetres;
  perception::PointView view;

  explicit AnyFrame(ByteReader& bytes)
  {
    constexpr std::uint32_t kLargest = 40;
    const std::uint32_t width = 2 + bytes.byte() % (kLargest - 1);
    const std::uint32_t height = 2 + bytes.byte() % (kLargest - 1);
    const std::uint8_t layout = bytes.byte() % 3;
    const std::size_t period = 1 + bytes.raw<std::uint16_t>() % (3 * kLargest * kLargest);
    rays = perception::PinholeRays::make(width, height, 35.0, 35.0, 0.5 * width, 0.5 * height);
    const std::size_t size = std::size_t{width} * height;
    if (layout == 0) {
      millimetres.resize(size);
      for (std::size_t k = 0; k < size; ++k)
        millimetres[k] = k < period ? bytes.raw<std::uint16_t>() : millimetres[k - period];
      view = perception::PointView::depth(millimetres.data(), width * sizeof(std::uint16_t), rays);
      return;
    }
    const bool is_cloud = layout == 1;
    metres.resize(is_cloud ? 3 * size : size);
    for (std::size_t k = 0; k < metres.size(); ++k)
      metres[k] = k < period ? bytes.number<float>() : metres[k - period];
    perception::PointView::CloudStrides strides;
    strides.point_step = 3 * sizeof(float);
    strides.row_step = width * strides.point_step;
    view = is_cloud ? perception::PointView::cloud(metres.data(), width, height, strides)
                    : perception::PointView::depth(metres.data(), width * sizeof(float), rays);
  }
};

}  // namespace
}  // namespace polygonal_perception::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace polygonal_perception;
  using namespace polygonal_perception::test;
  ByteReader bytes(data, size);
  perception::Pipeline::Parameters parameters;
  parameters.tracker.up_feedback = bytes.byte() % 2 == 0;
  parameters.drop_offs.drop_height = bytes.byte() % 2 == 0 ? 0.0 : 0.1;
  parameters.detector.selection.max_camera_height = 20.0;
  parameters.detector.selection.min_camera_height = 0.0;
  perception::Pipeline pipeline{parameters};
  for (int k = 0; k < 3 && !bytes.empty(); ++k) {
    const double stamp = bytes.number<double>();
    const AnyFrame frame(bytes);
    requireSound(pipeline.process({frame.view, stamp, {}}, kAllProducts), parameters.detector);
  }
  return 0;
}
