#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::evaluation {

/// A start and a goal, neither inside an obstacle.
struct PathQuery
{
  Eigen::Vector2d start;
  Eigen::Vector2d goal;
  std::optional<double> optimum;  ///< [m] where the source of the scene knows it
};

/// Obstacles to plan among.
struct PathScene
{
  std::string family;  ///< scenes of a family are alike but for their size
  geometry::PolygonSet obstacles;
  std::vector<PathQuery> queries;

  std::size_t edges() const { return obstacles.vertices.size(); }
  /// [m] Of obstacles, starts and goals, and some room around them for methods that need an end of the world.
  Eigen::AlignedBox2d box() const
  {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : obstacles.vertices) box.extend(p);
    for (const PathQuery& query : queries) box.extend(query.start).extend(query.goal);
    return {box.min().array() - 1.0, box.max().array() + 1.0};
  }
};

/// Hexagons of all sizes, each in a cell of its own, with about that many edges in all.
PathScene clutterScene(std::size_t edges);
/// A maze of square rooms whose walls are one polygon: rooms hang together like a tree.
PathScene officeScene(std::size_t edges);
/// The polygons of single frames of a simulated drive through an office, one scene a frame, and last the map after it.
std::vector<PathScene> drivenScenes();
/// The polygons after each frame of that drive, three a second, with somebody walking about: the map's, or only what that
/// frame shows.
std::vector<geometry::PolygonSet> drivenPolygons(bool remembers);
/// The map of arena.json with its queries, and the worlds of barn.json, a query each.
/// @param folder  that has these files
/// @throws std::runtime_error that says what cannot be read
std::vector<PathScene> publicScenes(const std::string& folder);

/// Fills up a scene's queries with random ones, all over its box.
void addRandomQueries(PathScene& scene, std::size_t count);

}  // namespace polygonal_perception::evaluation
