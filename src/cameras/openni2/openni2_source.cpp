#include "polygonal_perception/cameras/openni2/openni2_source.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "cameras/openni2/depth_stream.hpp"

namespace polygonal_perception::openni2 {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kRetry{500};      // between two looks for the device
constexpr milliseconds kFrameWait{100};  // after which it looks whether frames are still wanted
constexpr milliseconds kSilence{3000};   // of a stream that runs: the device has gone without a word

}  // namespace

/// The source's thread. OpenNI's own threads only tell it that a device has gone.
class OpenNI2Source::Worker : private openni::OpenNI::DeviceDisconnectedListener
{
public:
  Worker(SourceOptions options, FrameCallback on_frame, ReportCallback on_report)
      : options_(std::move(options)), on_frame_(std::move(on_frame)), on_report_(std::move(on_report))
  {
    thread_ = std::thread([this] { run(); });
  }
  ~Worker() override
  {
    change([this] { stopping_ = true; });
    thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void setStreaming(bool wanted)
  {
    change([this, wanted] { wanted_ = wanted; });
  }

private:
  template <class Change>
  void change(Change&& apply)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    apply();
    changed_.notify_all();
  }

  void onDeviceDisconnected(const openni::DeviceInfo* info) override
  {
    change([this, info] {
      if (uri_ == info->getUri()) lost_ = true;
    });
  }

  void run()
  {
    while (!stopping() && openni::OpenNI::initialize() != openni::STATUS_OK) {
      report(Severity::kWarning,
             std::string("OpenNI2 does not start: ") + openni::OpenNI::getExtendedError());
      openni::OpenNI::shutdown();
      pause(kRetry);
    }
    if (stopping()) return;
    openni::OpenNI::addDeviceDisconnectedListener(this);
    while (!stopping()) {
      if (connect()) follow();
    }
    openni::OpenNI::removeDeviceDisconnectedListener(this);
    openni::OpenNI::shutdown();
  }

  bool connect()
  {
    const std::string error = stream_.open(options_);
    if (!error.empty()) {
      report(Severity::kWarning, error);
      pause(kRetry);
      return false;
    }
    change([this] {
      uri_ = stream_.uri();
      lost_ = false;
      ended_ = false;
    });
    report(Severity::kInfo, "opened " + stream_.description());
    return true;
  }

  /// Streams while frames are wanted, until the device has gone or the source is to end.
  void follow()
  {
    bool works = true;
    while (works && !over()) {
      if (wanted()) {
        works = stream();
      } else {
        std::unique_lock<std::mutex> lock(mutex_);
        changed_.wait(lock, [this] { return (wanted_ && !ended_) || stopping_ || lost_; });
      }
    }
    if (lost()) report(Severity::kWarning, stream_.uri() + " has gone");
    change([this] { uri_.clear(); });
    stream_.close();
    if (!works) pause(kRetry);
  }

  /// @return whether the device still works
  bool stream()
  {
    const std::string error = stream_.start();
    if (!error.empty()) {
      report(Severity::kWarning, error);
      return false;
    }
    auto last = steady_clock::now();
    while (wanted() && !over()) {
      const DepthStream::Read read = stream_.read(kFrameWait, on_frame_);
      if (read == DepthStream::Read::kFrame) {
        last = steady_clock::now();
      } else if (read == DepthStream::Read::kEnd) {
        report(Severity::kInfo, stream_.uri() + " has been played to its end");
        change([this] { ended_ = true; });
      } else if (read == DepthStream::Read::kFailed) {
        report(Severity::kWarning, stream_.uri() + " gives frames that cannot be read as millimetres");
        return false;
      } else if (steady_clock::now() - last > kSilence) {
        report(Severity::kWarning, stream_.uri() + " has stopped sending frames");
        return false;
      }
    }
    if (!lost()) stream_.stop();
    return true;
  }

  /// Tells what has changed, and no text twice in a row.
  void report(Severity severity, const std::string& text)
  {
    if (text == reported_) return;
    reported_ = text;
    on_report_(severity, text);
  }

  bool stopping() { return locked(stopping_); }
  bool wanted()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return wanted_ && !ended_;
  }
  bool lost() { return locked(lost_); }
  bool over() { return stopping() || lost(); }
  bool locked(const bool& flag)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return flag;
  }
  void pause(milliseconds timeout)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, timeout, [this] { return stopping_; });
  }

  const SourceOptions options_;
  const FrameCallback on_frame_;
  const ReportCallback on_report_;

  std::mutex mutex_;  // for what follows up to uri_
  std::condition_variable changed_;
  bool stopping_ = false;
  bool wanted_ = false;
  bool lost_ = false;
  bool ended_ = false;  // the recording
  std::string uri_;     // of the device that is open

  DepthStream stream_;
  std::string reported_;
  std::thread thread_;
};

OpenNI2Source::OpenNI2Source(const SourceOptions& options, FrameCallback on_frame, ReportCallback on_report)
    : worker_(std::make_unique<Worker>(options, std::move(on_frame), std::move(on_report)))
{
}

OpenNI2Source::~OpenNI2Source() = default;

void OpenNI2Source::setStreaming(bool wanted)
{
  worker_->setStreaming(wanted);
}

}  // namespace polygonal_perception::openni2
