#include <image_transport/simple_subscriber_plugin.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/image_encodings.h>

#include <boost/make_shared.hpp>
#include <opencv2/imgcodecs.hpp>
#include <pluginlib/class_list_macros.hpp>

namespace polygonal_perception::test {

/// Reads what compressed_depth_image_transport writes of a 16UC1 image: twelve bytes of its own, then a PNG.
class CompressedDepthSubscriber : public image_transport::SimpleSubscriberPlugin<sensor_msgs::CompressedImage>
{
public:
  std::string getTransportName() const override { return "compressedDepth"; }

protected:
  void internalCallback(const sensor_msgs::CompressedImage::ConstPtr& message,
                        const Callback& user_cb) override
  {
    constexpr std::size_t kHeader = 12;
    if (message->data.size() <= kHeader) return;
    const cv::Mat depth = cv::imdecode(cv::Mat(1, static_cast<int>(message->data.size() - kHeader), CV_8UC1,
                                               const_cast<std::uint8_t*>(message->data.data()) + kHeader),
                                       cv::IMREAD_UNCHANGED);
    if (depth.type() != CV_16UC1 || !depth.isContinuous()) return;
    auto image = boost::make_shared<sensor_msgs::Image>();
    image->header = message->header;
    image->encoding = sensor_msgs::image_encodings::TYPE_16UC1;
    image->width = static_cast<std::uint32_t>(depth.cols);
    image->height = static_cast<std::uint32_t>(depth.rows);
    image->step = image->width * 2;
    image->data.assign(depth.data, depth.data + depth.total() * 2);
    user_cb(image);
  }
};

}  // namespace polygonal_perception::test

PLUGINLIB_EXPORT_CLASS(polygonal_perception::test::CompressedDepthSubscriber,
                       image_transport::SubscriberPlugin)
