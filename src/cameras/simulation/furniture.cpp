#include "cameras/simulation/furniture.hpp"

#include <cmath>

#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::simulation {
namespace {

constexpr double kBoardSpacing = 0.34;  // [m] from board to board of a shelf
constexpr double kCablePiece = 0.12;    // [m] over which a cable is straight

/// Wood, cloth and plastic; one thing in eight is nearly black.
double anyReflectance(Random& random)
{
  return random.chance(0.125) ? random.uniform(0.02, 0.10) : random.uniform(0.25, 0.85);
}

void addScreen(const Assembly& at, Random& random)
{
  const double half = random.uniform(0.24, 0.34);
  const Assembly black = at.reflecting(random.uniform(0.05, 0.2));
  black.box({-0.10, -0.12, 0.0}, {0.10, 0.12, 0.015});
  black.box({-0.03, -0.03, 0.015}, {0.0, 0.03, 0.2});
  black.turned(random.uniform(-0.1, 0.1), Eigen::Vector3d::UnitY())
      .box({0.0, -half, 0.1}, {0.04, half, 0.12 + 1.2 * half});
}

void addClutterPiece(const Assembly& at, Random& random)
{
  const Assembly piece = at.reflecting(anyReflectance(random));
  switch (random.integer(0, 5)) {
    case 0:
      addScreen(at, random);
      break;
    case 1:
      piece.box({-0.07, -0.22, 0.0}, {0.07, 0.22, 0.025});
      break;  // keyboard
    case 2:
      piece.cylinder({0, 0, 0}, {0, 0, 0.09}, 0.04);
      break;  // cup
    case 3:
      piece.box({-0.15, -0.11, 0.0}, {0.15, 0.11, random.uniform(0.005, 0.12)});
      break;  // papers
    case 4:
      piece.box({-0.1, -0.14, 0.0}, {0.1, 0.14, random.uniform(0.1, 0.3)});
      break;  // box
    default:  // open laptop
      piece.box({-0.12, -0.17, 0.0}, {0.12, 0.17, 0.02});
      piece.at(-0.12, 0.0)
          .turned(-0.3, Eigen::Vector3d::UnitY())
          .box({-0.005, -0.17, 0.02}, {0.005, 0.17, 0.23});
  }
}

void addFourLegs(const Assembly& at, const HalfSize& half, double height, double radius, bool square)
{
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      const double x = sx * (half.x() - radius);
      const double y = sy * (half.y() - radius);
      if (square) {
        at.box({x - radius, y - radius, 0.0}, {x + radius, y + radius, height});
      } else {
        at.cylinder({x, y, 0.0}, {x, y, height}, radius);
      }
    }
  }
}

void addOfficeChair(const Assembly& at, Random& random)
{
  const double seat = random.uniform(0.43, 0.55);
  const Assembly metal = at.reflecting(random.uniform(0.1, 0.6));
  for (int arm = 0; arm < 5; ++arm) {
    const Assembly spoke = metal.at(0, 0, 2.0 * geometry::kPi * arm / 5.0);
    spoke.box({0.0, -0.02, 0.07}, {0.29, 0.02, 0.11});
    spoke.ellipsoid({0.28, 0.0, 0.03}, {0.03, 0.025, 0.03});
  }
  metal.cylinder({0, 0, 0.08}, {0, 0, seat - 0.06}, 0.03);
  const Assembly cloth = at.reflecting(anyReflectance(random));
  cloth.box({-0.23, -0.24, seat - 0.06}, {0.25, 0.24, seat});
  const double top = seat + random.uniform(0.4, 0.65);
  cloth.box({-0.27, -0.22, seat + 0.12}, {-0.21, 0.22, top});
  metal.box({-0.26, -0.03, seat - 0.04}, {-0.23, 0.03, seat + 0.15});
  if (random.chance(0.5)) {
    for (const double side : {-1.0, 1.0}) {
      cloth.box({-0.15, side * 0.27 - 0.03, seat + 0.18}, {0.12, side * 0.27 + 0.03, seat + 0.21});
      metal.box({-0.02, side * 0.27 - 0.015, seat - 0.05}, {0.02, side * 0.27 + 0.015, seat + 0.18});
    }
  }
}

void addPlainChair(const Assembly& at, Random& random)
{
  const double seat = random.uniform(0.42, 0.48);
  const HalfSize half(0.21, random.uniform(0.2, 0.23));
  const Assembly frame = at.reflecting(anyReflectance(random));
  const double radius = random.uniform(0.011, 0.02);
  addFourLegs(frame, half, seat, radius, random.chance(0.5));
  const Assembly wood = at.reflecting(anyReflectance(random));
  wood.box({-half.x(), -half.y(), seat - 0.03}, {half.x(), half.y(), seat});
  const double top = seat + random.uniform(0.35, 0.5);
  for (const double side : {-1.0, 1.0}) {
    frame.cylinder({-half.x() + radius, side * (half.y() - radius), seat},
                   {-half.x() - 0.05, side * (half.y() - radius), top}, radius);
  }
  wood.turned(-0.1, Eigen::Vector3d::UnitY())
      .box({-half.x() - 0.05, -half.y(), seat + random.uniform(0.1, 0.22)},
           {-half.x() - 0.03, half.y(), top - 0.02});
}

void addOpenShelf(const Assembly& at, Random& random, const HalfSize& half, double height)
{
  for (const double side : {-1.0, 1.0}) {
    at.box({-half.x(), side * (half.y() - 0.01) - 0.01, 0.0},
           {half.x(), side * (half.y() - 0.01) + 0.01, height});
  }
  at.box({-half.x(), -half.y() + 0.02, 0.0}, {-half.x() + 0.01, half.y() - 0.02, height});
  const int boards = static_cast<int>((height - 0.11) / kBoardSpacing) + 1;
  for (int board = 0; board < boards; ++board) {
    const double z = 0.06 + kBoardSpacing * board;
    at.box({-half.x() + 0.01, -half.y() + 0.02, z}, {half.x(), half.y() - 0.02, z + 0.02});
    for (double y = -half.y() + 0.03; y < half.y() - 0.1;) {
      const double width = random.uniform(0.03, 0.25);
      if (random.chance(0.7) && y + width < half.y() - 0.03) {
        at.reflecting(anyReflectance(random))
            .box({-half.x() + 0.01, y, z + 0.02},
                 {half.x() - random.uniform(0.02, 0.15), y + width, z + random.uniform(0.15, 0.31)});
      }
      y += width;
    }
  }
}

}  // namespace

void addTable(const Assembly& at, Random& random, const HalfSize& half, double height)
{
  const Assembly wood = at.reflecting(random.uniform(0.3, 0.85));
  const double thickness = random.uniform(0.018, 0.045);
  wood.box({-half.x(), -half.y(), height - thickness}, {half.x(), half.y(), height});
  const Assembly legs = at.reflecting(random.uniform(0.15, 0.85));
  switch (random.integer(0, 3)) {
    case 0:
      for (const double side : {-1.0, 1.0}) {
        legs.box({-half.x() + 0.05, side * (half.y() - 0.04) - 0.0125, 0.0},
                 {half.x() - 0.05, side * (half.y() - 0.04) + 0.0125, height - thickness});
      }
      break;
    case 1:
      for (const double y : {-0.6 * half.y(), 0.6 * half.y()}) {
        legs.cylinder({0, y, 0.0}, {0, y, height - thickness}, 0.035);
        legs.box({-0.7 * half.x(), y - 0.03, 0.0}, {0.7 * half.x(), y + 0.03, 0.04});
      }
      break;
    default:
      addFourLegs(legs, half * 0.95, height - thickness, random.uniform(0.018, 0.035), random.chance(0.5));
  }
}

void addTableClutter(const Assembly& at, Random& random, const HalfSize& half, double height, int pieces)
{
  for (int i = 0; i < pieces; ++i) {
    const double x = random.uniform(-1.0, 1.0) * std::max(0.0, half.x() - 0.16);
    const double y = random.uniform(-1.0, 1.0) * std::max(0.0, half.y() - 0.2);
    addClutterPiece(at.at(x, y, random.uniform(-0.5, 0.5), height), random);
  }
}

HalfSize addDesk(const Assembly& at, Random& random)
{
  HalfSize half(random.uniform(0.35, 0.42), random.uniform(0.6, 0.95));
  const double height = random.uniform(0.70, 0.78);
  addTable(at, random, half, height);
  addTableClutter(at, random, half, height, random.integer(1, 6));
  if (random.chance(0.5)) {
    const double y = random.sign() * (half.y() - 0.3);
    at.reflecting(anyReflectance(random))
        .box({-half.x() + 0.1, y - 0.2, 0.03}, {half.x() - 0.08, y + 0.2, height - 0.1});
  }
  if (random.chance(0.3))
    at.box({-half.x() + 0.05, -half.y() + 0.06, 0.3}, {-half.x() + 0.07, half.y() - 0.06, height - 0.05});
  return half;
}

HalfSize addChair(const Assembly& at, Random& random)
{
  if (random.chance(0.5)) {
    addOfficeChair(at, random);
    return {0.32, 0.32};
  }
  addPlainChair(at, random);
  return {0.28, 0.24};
}

HalfSize addCabinet(const Assembly& at, Random& random)
{
  HalfSize half(random.uniform(0.15, 0.3), random.uniform(0.3, 0.6));
  const double height = random.chance(0.5) ? random.uniform(0.7, 1.2) : random.uniform(1.6, 2.1);
  const Assembly wood = at.reflecting(random.uniform(0.3, 0.85));
  if (random.chance(0.4)) {
    addOpenShelf(wood, random, half, height);
    return half;
  }
  wood.box({-half.x(), -half.y(), 0.0}, {half.x() - 0.03, half.y(), 0.08});
  wood.box({-half.x(), -half.y(), 0.08}, {half.x(), half.y(), height});
  wood.box({half.x(), -0.03, 0.5 * height}, {half.x() + 0.025, -0.015, 0.5 * height + 0.15});
  return half;
}

HalfSize addSofa(const Assembly& at, Random& random)
{
  HalfSize half(random.uniform(0.4, 0.48), random.chance(0.4) ? 0.45 : random.uniform(0.75, 1.05));
  const Assembly cloth = at.reflecting(anyReflectance(random));
  const double seat = random.uniform(0.38, 0.46);
  cloth.box({-half.x(), -half.y(), 0.05}, {half.x(), half.y(), seat});
  cloth.box({-half.x(), -half.y(), seat}, {-half.x() + 0.2, half.y(), seat + random.uniform(0.3, 0.45)});
  for (const double side : {-1.0, 1.0}) {
    cloth.box({-half.x() + 0.2, side * (half.y() - 0.08) - 0.08, seat},
              {half.x(), side * (half.y() - 0.08) + 0.08, seat + 0.2});
  }
  return half;
}

HalfSize addBoxes(const Assembly& at, Random& random)
{
  HalfSize widest = HalfSize::Zero();
  double z = 0.0;
  const int count = random.integer(1, 3);
  for (int i = 0; i < count; ++i) {
    const HalfSize half(random.uniform(0.08, 0.25), random.uniform(0.08, 0.3));
    const double height = random.uniform(0.06, 0.4);
    at.at(0, 0, random.uniform(-0.3, 0.3), z)
        .reflecting(anyReflectance(random))
        .box({-half.x(), -half.y(), 0.0}, {half.x(), half.y(), height});
    widest = widest.cwiseMax(half);
    z += height;
  }
  return widest;
}

HalfSize addBag(const Assembly& at, Random& random)
{
  const Assembly cloth = at.reflecting(anyReflectance(random));
  HalfSize half(random.uniform(0.1, 0.17), random.uniform(0.15, 0.25));
  const double height = random.uniform(0.2, 0.5);
  cloth.box({-0.7 * half.x(), -0.8 * half.y(), 0.0}, {0.7 * half.x(), 0.8 * half.y(), 0.5 * height});
  cloth.ellipsoid({0, 0, 0.48 * height}, {half.x(), half.y(), 0.5 * height});
  return half;
}

HalfSize addSmallThing(const Assembly& at, Random& random)
{
  const Assembly thing = at.reflecting(anyReflectance(random));
  switch (random.integer(0, 4)) {
    case 0:
      thing.frustum({0, 0, 0}, {0, 0, 0.32}, 0.11, 0.15);
      return {0.15, 0.15};
    case 1:
      thing.frustum({0, 0, 0}, {0, 0, 0.3}, 0.12, 0.17);
      at.reflecting(0.7).cylinder({0, 0, 0.3}, {0, 0, 0.6}, 0.015);
      at.reflecting(0.7).ellipsoid({0, 0, random.uniform(0.75, 1.1)}, {0.3, 0.3, 0.35});
      return {0.3, 0.3};
    case 2:
      thing.cylinder({0, 0, 0.42}, {0, 0, 0.46}, 0.17);
      addFourLegs(thing, {0.15, 0.15}, 0.42, 0.014, false);
      return {0.17, 0.17};
    case 3:
      thing.cylinder({0, 0, 0}, {0, 0, 0.025}, 0.15);
      thing.cylinder({0, 0, 0.025}, {0, 0, 1.5}, 0.014);
      thing.frustum({0, 0, 1.45}, {0, 0, 1.7}, 0.2, 0.12);
      return {0.2, 0.2};
    default:
      thing.box({-0.2, -0.02, 0.0}, {0.2, 0.02, 0.03});
      thing.box({-0.02, -0.2, 0.0}, {0.02, 0.2, 0.03});
      thing.cylinder({0, 0, 0.03}, {0, 0, 0.95}, 0.017);
      thing.ellipsoid({0, 0, 1.15}, {0.09, 0.22, 0.22});
      return {0.22, 0.22};
  }
}

HalfSize addRadiator(const Assembly& at, Random& random)
{
  HalfSize half(0.06, random.uniform(0.4, 0.8));
  at.reflecting(0.8).box({-half.x() + 0.03, -half.y(), 0.12},
                         {half.x(), half.y(), random.uniform(0.55, 0.75)});
  at.cylinder({0.0, half.y() - 0.05, 0.0}, {0.0, half.y() - 0.05, 0.12}, 0.012);
  return half;
}

void addCable(const Assembly& at, Random& random, double length)
{
  const double radius = random.uniform(0.003, 0.008);
  const Assembly rubber = at.reflecting(random.uniform(0.05, 0.5));
  Eigen::Vector3d from(0, 0, radius);
  double heading = 0.0;
  const int pieces = static_cast<int>(length / kCablePiece) + 1;
  for (int piece = 0; piece < pieces; ++piece) {
    heading += random.uniform(-0.6, 0.6);
    const Eigen::Vector3d to =
        from + kCablePiece * Eigen::Vector3d(std::cos(heading), std::sin(heading), 0.0);
    rubber.cylinder(from, to, radius);
    from = to;
  }
}

void addMat(const Assembly& at, Random& random)
{
  const HalfSize half(random.uniform(0.3, 0.7), random.uniform(0.4, 1.2));
  at.of(Surface::kFloor)
      .reflecting(random.uniform(0.1, 0.6))
      .box({-half.x(), -half.y(), -0.001}, {half.x(), half.y(), random.uniform(0.002, 0.005)});
}

}  // namespace polygonal_perception::simulation
