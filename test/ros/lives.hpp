#pragma once

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <atomic>
#include <functional>
#include <string>
#include <thread>

namespace polygonal_perception::test {

/// What arrives at a node from all sides, in threads of its own: messages, readers of an output that come and go, calls.
template <class Answer>
class Traffic
{
public:
  /// @param output   a topic of the node
  /// @param publish  sends a message
  /// @param call     calls all of the node's services
  Traffic(const std::string& output, const std::function<void()>& publish, const std::function<void()>& call)
      : sender_([this, publish] {
          ros::WallRate rate(500.0);
          while (running_) {
            publish();
            rate.sleep();
          }
        }),
        reader_([this, output] { readAnswers(output); }),
        caller_([this, call] {
          while (running_) call();
        })
  {
  }
  ~Traffic()
  {
    running_ = false;
    sender_.join();
    reader_.join();
    caller_.join();
  }

  int answers() const { return answers_; }

private:
  void readAnswers(const std::string& topic)
  {
    ros::NodeHandle own;
    ros::CallbackQueue queue;
    own.setCallbackQueue(&queue);
    const boost::function<void(const boost::shared_ptr<const Answer>&)> count =
        [this](const boost::shared_ptr<const Answer>&) { ++answers_; };
    while (running_) {
      const ros::Subscriber answers = own.subscribe<Answer>(topic, 5, count);
      for (int i = 0; running_ && i < 20; ++i) queue.callAvailable(ros::WallDuration(0.002));
    }
  }

  std::atomic<bool> running_{true};
  std::atomic<int> answers_{0};
  std::thread sender_, reader_, caller_;
};

/// Makes a node and takes it down, many times, while a thread serves its queue, one callback at a time: as a nodelet manager
/// does.
/// @param name     of the node; its parameters are in its namespace
/// @param prepare  what to do before each life, by its number
template <class Node, class Answer>
void expectCleanLives(const std::string& name, int lives, const Traffic<Answer>& traffic,
                      const std::function<void(int)>& prepare)
{
  ros::CallbackQueue queue;
  ros::AsyncSpinner worker(1, &queue);
  worker.start();
  ros::NodeHandle handle;
  handle.setCallbackQueue(&queue);
  ros::NodeHandle private_handle(handle, name);
  private_handle.setCallbackQueue(&queue);
  for (int life = 0; life < lives; ++life) {
    prepare(life);
    const Node node(handle, private_handle);
    const int before = traffic.answers();
    if (life % 10 != 9) continue;
    // Every tenth life lasts until it has answered, the others end at once.
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(10.0);
    while (traffic.answers() == before && ros::WallTime::now() < deadline) std::this_thread::yield();
    EXPECT_GT(traffic.answers(), before) << "no answer in life " << life;
  }
  worker.stop();
}

}  // namespace polygonal_perception::test
