#pragma once

#include "polygonal_perception/cameras/simulation/random.hpp"
#include "polygonal_perception/cameras/simulation/scene.hpp"

namespace polygonal_perception::simulation {

// Each lays out one kind of scene; see sceneNames() and courseNames().
void layOutCorridor(Scene& scene, Random& random);
void layOutOffice(Scene& scene, Random& random);
void layOutBusyOffice(Scene& scene, Random& random);
void layOutPerson(Scene& scene, Random& random);
void layOutTableTop(Scene& scene, Random& random);
void layOutWall(Scene& scene, Random& random);
void layOutDoorway(Scene& scene, Random& random);
void layOutStairs(Scene& scene, Random& random);
void layOutLedge(Scene& scene, Random& random);
void layOutDais(Scene& scene, Random& random);
void layOutPallet(Scene& scene, Random& random);
void layOutKerb(Scene& scene, Random& random);
void layOutThreshold(Scene& scene, Random& random);
void layOutRamp(Scene& scene, Random& random);
void layOutCarpet(Scene& scene, Random& random);
void layOutRamps(Scene& scene, Random& random);

}  // namespace polygonal_perception::simulation
