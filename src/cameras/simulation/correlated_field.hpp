#pragma once

#include <cstdint>
#include <vector>

namespace polygonal_perception::simulation {

/// An image of nearly normal numbers with mean 0 and variance 1 in which neighbours are alike.
/// @param sigma    [px] standard deviation of the kernel that white noise is smoothed with; 0 = white
/// @param seed     decides every value, whatever was drawn before
/// @param scratch  memory to use again
void drawCorrelatedField(std::uint32_t width, std::uint32_t height, double sigma, std::uint64_t seed,
                         std::vector<float>& field, std::vector<float>& scratch);

}  // namespace polygonal_perception::simulation
