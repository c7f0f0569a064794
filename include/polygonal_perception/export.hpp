#pragma once

/// Marks what a library shows to the outside. All else in it is hidden, so that two libraries of one process
/// cannot take each other's classes for their own.
#define POLYGONAL_PERCEPTION_EXPORT __attribute__((visibility("default")))
