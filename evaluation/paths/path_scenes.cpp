#include "paths/path_scenes.hpp"

#include <cmath>
#include <random>

#include "polygonal_perception/geometry/location.hpp"

namespace polygonal_perception::evaluation {

namespace {

using Ring = std::vector<Eigen::Vector2d>;

constexpr unsigned kSeed = 7;

double between(std::mt19937& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Which rooms of a square of them have a door to which neighbour: a tree, grown from one corner at random.
class RoomTree
{
public:
  RoomTree(std::mt19937& random, int size) : size_(size), doors_(static_cast<std::size_t>(size) * size)
  {
    std::vector<bool> is_reached(doors_.size(), false);
    std::vector<int> front{0};
    is_reached[0] = true;
    while (!front.empty()) {
      const int room = front.back();
      std::vector<int> sides;
      for (int side = 0; side < 4; ++side)
        if (const int next = beyond(room, side); next >= 0 && !is_reached[next]) sides.push_back(side);
      if (sides.empty()) {
        front.pop_back();
        continue;
      }
      const int side = sides[random() % sides.size()];
      const int next = beyond(room, side);
      doors_[room][side] = doors_[next][(side + 2) % 4] = true;
      is_reached[next] = true;
      front.push_back(next);
      // Branches, lest it be one long way.
      if (random() % 3 == 0) std::swap(front[front.size() / 2], front.back());
    }
  }

  /// The room beyond a side, 0 right, 1 up, 2 left, 3 down; negative where there is none.
  int beyond(int room, int side) const
  {
    const int x = room % size_ + (side == 0) - (side == 2);
    const int y = room / size_ + (side == 1) - (side == 3);
    return x < 0 || y < 0 || x >= size_ || y >= size_ ? -1 : y * size_ + x;
  }
  bool hasDoor(int room, int side) const { return doors_[room][side]; }
  Eigen::Vector2d corner(int room) const { return Eigen::Vector2d(room % size_, room / size_); }

private:
  struct Doors
  {
    bool open[4] = {};
    bool& operator[](int side) { return open[side]; }
    bool operator[](int side) const { return open[side]; }
  };
  int size_;
  std::vector<Doors> doors_;
};

/// The border of the free space of a tree of rooms, counter-clockwise: along the walls, in and out of each room.
Ring bordersOf(const RoomTree& tree)
{
  constexpr double kRoom = 2.5;  // [m]
  constexpr double kWall = 0.15;
  constexpr double kDoor = 0.45;  // half of it
  // A place along a side, inwards of it, of who goes round the room counter-clockwise.
  const auto place = [&](int room, int side, double along, double inward) -> Eigen::Vector2d {
    const Eigen::Vector2d corner = kRoom * tree.corner(room);
    if (side == 3) return corner + Eigen::Vector2d(along, inward);
    if (side == 0) return corner + Eigen::Vector2d(kRoom - inward, along);
    if (side == 1) return corner + Eigen::Vector2d(kRoom - along, kRoom - inward);
    return corner + Eigen::Vector2d(inward, kRoom - along);
  };
  Ring ring;
  int room = 0;
  int side = 3;
  do {
    ring.push_back(place(room, side, kWall, kWall));
    if (tree.hasDoor(room, side)) {
      ring.push_back(place(room, side, kRoom / 2.0 - kDoor, kWall));
      room = tree.beyond(room, side);
      side = (side + 2) % 4;
      ring.push_back(place(room, side, kRoom / 2.0 + kDoor, kWall));
    }
    side = (side + 1) % 4;
  } while (room != 0 || side != 3);
  return ring;
}

}  // namespace

PathScene clutterScene(std::size_t edges)
{
  constexpr double kCell = 2.2;  // [m]
  std::mt19937 random(kSeed);
  PathScene scene{"clutter", {}, {}};
  const int size = static_cast<int>(std::lround(std::sqrt(static_cast<double>(edges) / 6.0)));
  for (int i = 0; i < size * size; ++i) {
    const Eigen::Vector2d middle = kCell * Eigen::Vector2d(i % size + 0.5, i / size + 0.5);
    const double radius = between(random, 0.2, 0.45) * kCell;
    const double turn = between(random, 0.0, 1.0);
    Ring ring;
    for (int k = 0; k < 6; ++k) {
      const double angle = turn + k * M_PI / 3.0;
      ring.push_back(middle +
                     radius * between(random, 0.6, 1.0) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    scene.obstacles.append(ring, false);
  }
  return scene;
}

PathScene officeScene(std::size_t edges)
{
  constexpr double kAround = 1.0;  // [m]
  std::mt19937 random(kSeed);
  PathScene scene{"office", {}, {}};
  const int size = static_cast<int>(std::lround(std::sqrt(static_cast<double>(edges) / 8.0)));
  const Ring free = bordersOf(RoomTree(random, size));
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : free) box.extend(p);
  const Eigen::Vector2d low = box.min().array() - kAround;
  const Eigen::Vector2d high = box.max().array() + kAround;
  scene.obstacles.append(Ring{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, false);
  scene.obstacles.append(Ring(free.rbegin(), free.rend()), true);
  return scene;
}

void addRandomQueries(PathScene& scene, std::size_t count)
{
  std::mt19937 random(kSeed);
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : scene.obstacles.vertices) box.extend(p);
  const auto freePlace = [&] {
    for (;;) {
      const Eigen::Vector2d place(between(random, box.min().x(), box.max().x()),
                                  between(random, box.min().y(), box.max().y()));
      if (geometry::locate(place, scene.obstacles) != geometry::Location::kInside) return place;
    }
  };
  while (scene.queries.size() < count) {
    const Eigen::Vector2d start = freePlace();
    scene.queries.push_back({start, freePlace(), std::nullopt});
  }
}

}  // namespace polygonal_perception::evaluation
