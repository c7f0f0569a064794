#include "paths/path_methods.hpp"

#include <stdexcept>

#include "paths/navfn_method.hpp"
#include "paths/ompl_method.hpp"
#include "polygonal_perception/planning/path_planner.hpp"
#include "reference/minimal_construct.hpp"

namespace polygonal_perception::evaluation {

namespace {

class Triangulated : public PathMethod
{
public:
  std::string name() const override { return "this package"; }
  void prepare(const PathScene& scene) override
  {
    if (const auto refused = planner_.setObstacles(scene.obstacles, {}, true))
      throw std::runtime_error(refused->text);
  }
  std::optional<double> plan(const Eigen::Vector2d& start, const Eigen::Vector2d& goal) override
  {
    planner_.makePlan(start, goal, 0.0, plan_);
    if (plan_.outcome != planning::PlanOutcome::kOk) return std::nullopt;
    return plan_.length;
  }
  std::size_t graphEdges() const override
  {
    std::vector<planning::PathSearch::SeenEdge> edges;
    planner_.search().seenEdges(edges);
    return edges.size();
  }

private:
  planning::PathPlanner planner_;
  planning::Plan plan_;
};

class Plain : public PathMethod
{
public:
  std::string name() const override { return "Minimal Construct, plain"; }
  void prepare(const PathScene& scene) override { planner_.emplace(scene.obstacles); }
  std::optional<double> plan(const Eigen::Vector2d& start, const Eigen::Vector2d& goal) override
  {
    return planner_->plan(start, goal);
  }
  std::size_t graphEdges() const override { return planner_->testedLines(); }

private:
  std::optional<reference::MinimalConstruct> planner_;
};

}  // namespace

std::unique_ptr<PathMethod> triangulatedMethod()
{
  return std::make_unique<Triangulated>();
}

std::unique_ptr<PathMethod> plainMethod()
{
  return std::make_unique<Plain>();
}

std::vector<std::unique_ptr<PathMethod>> otherMethods()
{
  std::vector<std::unique_ptr<PathMethod>> methods;
#ifdef POLYGONAL_PERCEPTION_HAS_NAVFN
  methods.push_back(navfnMethod(0.05));
  methods.push_back(navfnMethod(0.1));
#endif
#ifdef POLYGONAL_PERCEPTION_HAS_OMPL
  methods.push_back(omplMethod(OmplPlanner::kBitStar, 0.1));
  methods.push_back(omplMethod(OmplPlanner::kRrtConnect, 1.0));
#endif
  return methods;
}

}  // namespace polygonal_perception::evaluation
