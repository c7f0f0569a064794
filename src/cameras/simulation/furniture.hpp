#pragma once

#include "cameras/simulation/assembly.hpp"

namespace polygonal_perception::simulation {

// Each thing stands at the origin of its assembly, its front towards x, and draws its size and kind.

/// How far a thing reaches from its origin along x and y [m], half its size.
using HalfSize = Eigen::Vector2d;

/// Only the table: legs at the corners, panels at the sides, or a column with a cross foot.
void addTable(const Assembly& at, Random& random, const HalfSize& half, double height);
/// What lies about on a table: screens, keyboards, cups, papers, boxes.
void addTableClutter(const Assembly& at, Random& random, const HalfSize& half, double height, int pieces);
/// A desk to be sat at from +x, with things on it and perhaps drawers under it.
HalfSize addDesk(const Assembly& at, Random& random);
/// A chair with four legs, or an office chair on a five-armed foot.
HalfSize addChair(const Assembly& at, Random& random);
/// A cupboard, a chest or an open shelf with books, its back at -x.
HalfSize addCabinet(const Assembly& at, Random& random);
/// A sofa or an armchair.
HalfSize addSofa(const Assembly& at, Random& random);
/// A cardboard box or a stack of them.
HalfSize addBoxes(const Assembly& at, Random& random);
/// A bag or a rucksack.
HalfSize addBag(const Assembly& at, Random& random);
/// A waste paper basket, a potted plant, a stool, a floor lamp or a standing fan.
HalfSize addSmallThing(const Assembly& at, Random& random);
/// A radiator, 1 m or so of it, its back at -x.
HalfSize addRadiator(const Assembly& at, Random& random);
/// A cable that wanders over the floor.
void addCable(const Assembly& at, Random& random, double length);
/// A thin mat; it is floor.
void addMat(const Assembly& at, Random& random);

}  // namespace polygonal_perception::simulation
