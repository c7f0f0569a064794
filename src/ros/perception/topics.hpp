#pragma once

#include <cstdint>

/// The names of everything that the node subscribes, publishes and offers, and the lengths of the queues.
namespace polygonal_perception::topics {

// Inputs, in the node's namespace.
inline constexpr char kPoints[] = "points";
inline constexpr char kDepthImage[] = "depth/image";
inline constexpr char kCameraInfo[] = "depth/camera_info";

// Outputs, in the node's private namespace.
inline constexpr char kFloor[] = "floor";
inline constexpr char kFloorCoefficients[] = "floor_coefficients";
inline constexpr char kOccupancyGrid[] = "occupancy_grid";
inline constexpr char kInflatedGrid[] = "inflated_grid";
inline constexpr char kPolygons[] = "polygons";
inline constexpr char kMarkers[] = "markers";
inline constexpr char kObstaclePoints[] = "obstacle_points";
inline constexpr char kSamples[] = "samples";

// Service, in the node's private namespace.
inline constexpr char kReset[] = "reset";

/// Only the newest frame counts: one that waited is dropped for it.
inline constexpr std::uint32_t kInputQueueSize = 1;
inline constexpr std::uint32_t kOutputQueueSize = 2;

}  // namespace polygonal_perception::topics
