#include "paths/navfn_method.hpp"

#include <navfn/navfn.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "polygonal_perception/planning/free_space.hpp"

namespace polygonal_perception::evaluation {

namespace {

constexpr unsigned char kLethal = 254;  // costmap_2d's

class Navfn : public PathMethod
{
public:
  explicit Navfn(double resolution) : resolution_(resolution) {}

  std::string name() const override
  {
    char text[32];
    std::snprintf(text, sizeof text, "navfn, %.0f cm", 100.0 * resolution_);
    return text;
  }

  void prepare(const PathScene& scene) override
  {
    planning::FreeSpace space;
    space.build(scene.obstacles);
    const Eigen::AlignedBox2d box = scene.box();
    origin_ = box.min();
    const Eigen::Vector2d cells = box.sizes() / resolution_;
    columns_ = static_cast<int>(std::ceil(cells.x()));
    rows_ = static_cast<int>(std::ceil(cells.y()));
    costs_.assign(static_cast<std::size_t>(columns_) * rows_, 0);
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column)
        if (!space.locate(origin_ + resolution_ * Eigen::Vector2d(column + 0.5, row + 0.5)))
          costs_[static_cast<std::size_t>(row) * columns_ + column] = kLethal;
    navfn_ = std::make_unique<navfn::NavFn>(columns_, rows_);
  }

  std::optional<double> plan(const Eigen::Vector2d& start, const Eigen::Vector2d& goal) override
  {
    int from[2];
    int to[2];
    toCell(start, from);
    toCell(goal, to);
    // The robot's own cell is free, as NavfnROS has it; and that of a goal within its tolerance.
    clear(from);
    clear(to);
    navfn_->setCostmap(costs_.data(), true, true);
    navfn_->setStart(to);
    navfn_->setGoal(from);
    if (!navfn_->calcNavFnDijkstra(true)) return std::nullopt;
    const int points = navfn_->calcPath(4 * columns_);
    if (points == 0) return std::nullopt;
    double length = 0.0;
    Eigen::Vector2d at = goal;
    for (int i = 0; i < points; ++i) {
      const Eigen::Vector2d next =
          origin_ +
          resolution_ *
              (Eigen::Vector2d(navfn_->getPathX()[i], navfn_->getPathY()[i]).array() + 0.5).matrix();
      length += (next - at).norm();
      at = next;
    }
    return length + (start - at).norm();
  }

private:
  void toCell(const Eigen::Vector2d& place, int* cell) const
  {
    const Eigen::Vector2d index = (place - origin_) / resolution_;
    cell[0] = std::clamp(static_cast<int>(index.x()), 1, columns_ - 2);
    cell[1] = std::clamp(static_cast<int>(index.y()), 1, rows_ - 2);
  }
  void clear(const int* cell) { costs_[static_cast<std::size_t>(cell[1]) * columns_ + cell[0]] = 0; }

  double resolution_;  // [m]
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  int columns_ = 0;
  int rows_ = 0;
  std::vector<unsigned char> costs_;
  std::unique_ptr<navfn::NavFn> navfn_;
};

}  // namespace

std::unique_ptr<PathMethod> navfnMethod(double resolution)
{
  return std::make_unique<Navfn>(resolution);
}

}  // namespace polygonal_perception::evaluation
