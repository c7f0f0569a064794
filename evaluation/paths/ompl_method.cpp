#include "paths/ompl_method.hpp"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <Eigen/Geometry>
#include <cstdio>

#include "polygonal_perception/planning/free_space.hpp"

namespace polygonal_perception::evaluation {

namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kStep = 0.02;  // [m] between looks along a line

class Ompl : public PathMethod
{
public:
  Ompl(OmplPlanner planner, double seconds) : planner_(planner), seconds_(seconds)
  {
    static const bool kIsSeeded = [] {
      ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
      ompl::RNG::setSeed(1);
      return true;
    }();
    (void)kIsSeeded;
  }

  std::string name() const override
  {
    if (planner_ == OmplPlanner::kRrtConnect) return "OMPL, RRT-Connect";
    char text[48];
    std::snprintf(text, sizeof text, "OMPL, BIT* for %.1f s", seconds_);
    return text;
  }

  void prepare(const PathScene& scene) override
  {
    space_.build(scene.obstacles);
    const Eigen::AlignedBox2d box = scene.box();
    const auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
    ob::RealVectorBounds bounds(2);
    for (int axis = 0; axis < 2; ++axis) {
      bounds.setLow(axis, box.min()[axis]);
      bounds.setHigh(axis, box.max()[axis]);
    }
    plane->setBounds(bounds);
    plane->setLongestValidSegmentFraction(kStep / plane->getMaximumExtent());
    setup_ = std::make_unique<og::SimpleSetup>(plane);
    setup_->setStateValidityChecker([this](const ob::State* state) {
      const auto* point = state->as<ob::RealVectorStateSpace::StateType>();
      return space_.locate({(*point)[0], (*point)[1]}).has_value();
    });
    const auto& information = setup_->getSpaceInformation();
    if (planner_ == OmplPlanner::kBitStar)
      setup_->setPlanner(std::make_shared<og::BITstar>(information));
    else
      setup_->setPlanner(std::make_shared<og::RRTConnect>(information));
  }

  std::optional<double> plan(const Eigen::Vector2d& start, const Eigen::Vector2d& goal) override
  {
    setup_->clear();
    ob::ScopedState<ob::RealVectorStateSpace> from(setup_->getStateSpace());
    ob::ScopedState<ob::RealVectorStateSpace> to(setup_->getStateSpace());
    for (int axis = 0; axis < 2; ++axis) {
      from[axis] = start[axis];
      to[axis] = goal[axis];
    }
    setup_->setStartAndGoalStates(from, to);
    if (setup_->solve(seconds_) != ob::PlannerStatus::EXACT_SOLUTION) return std::nullopt;
    if (planner_ == OmplPlanner::kRrtConnect) setup_->simplifySolution();
    return setup_->getSolutionPath().length();
  }

private:
  OmplPlanner planner_;
  double seconds_;
  planning::FreeSpace space_;
  std::unique_ptr<og::SimpleSetup> setup_;
};

}  // namespace

std::unique_ptr<PathMethod> omplMethod(OmplPlanner planner, double seconds)
{
  return std::make_unique<Ompl>(planner, seconds);
}

}  // namespace polygonal_perception::evaluation
