#pragma once

#include <Eigen/Core>
#include <vector>

#include "cameras/simulation/assembly.hpp"
#include "cameras/simulation/furniture.hpp"
#include "polygonal_perception/cameras/simulation/scene.hpp"

namespace polygonal_perception::simulation {

/// A hole in a wall, measured along it from its start and up from the floor [m].
struct Opening
{
  double start = 0.0;
  double end = 0.0;
  double bottom = 0.0;
  double top = 2.0;
};

/// A rectangle along the world's axes [m].
struct Rectangle
{
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d::Zero();

  Eigen::Vector2d size() const { return high - low; }
  Eigen::Vector2d centre() const { return 0.5 * (low + high); }
  Outline outline() const { return {low, {high.x(), low.y()}, high, {low.x(), high.y()}}; }
};

/// A wall with its face on the line between two points, the room to its left; openings in order of their
/// starts.
void addWall(const Assembly& at, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double height,
             const std::vector<Opening>& openings = {});

/// The floor of the robot, of tiles of changing brightness, and its outline for the truth.
void addFloor(Scene& scene, Random& random, const Rectangle& area);
/// A level floor at another height.
void addLowerFloor(Scene& scene, const Rectangle& area, double z);
void addCeiling(Scene& scene, const Rectangle& area, double height);

/// Which walls of a room stand, and what is open in each, counter-clockwise from the one along the low y.
struct RoomWalls
{
  std::vector<Opening> openings[4];
  bool missing[4] = {false, false, false, false};
};
void addWalls(Scene& scene, const Rectangle& area, double height, const RoomWalls& walls = {});

/// A window somewhere in a wall of a given length, or none: rays leave through it.
std::vector<Opening> maybeWindow(Random& random, double wall_length);

/// Keeps things that stand about from standing in each other.
class Clearances
{
public:
  /// Takes a disc when it is free.
  bool take(const Eigen::Vector2d& centre, double radius);
  void reserve(const Eigen::Vector2d& centre, double radius) { discs_.push_back({centre, radius}); }

private:
  struct Disc
  {
    Eigen::Vector2d centre;
    double radius;
  };
  std::vector<Disc> discs_;
};

/// Sets cabinets, radiators, shelves and boxes along the inside of a wall, with gaps between them.
/// @param density  0 = bare, 1 = hardly a gap
void furnishWall(Scene& scene, Random& random, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                 double density);
/// Scatters `count` loose things (boxes, bags, chairs, bins, plants) over an area.
void scatter(Scene& scene, Random& random, const Rectangle& area, int count, Clearances& clearances);

}  // namespace polygonal_perception::simulation
