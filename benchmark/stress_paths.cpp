// Plans paths among broken obstacles until one is not what it promises: stress_paths [queries] [first seed].
#include <cstdio>
#include <cstdlib>

#include "reference/plan_stress.hpp"

int main(int argc, char** argv)
{
  const std::size_t queries = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10000000;
  const auto seed = static_cast<std::uint32_t>(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1);
  const auto result = polygonal_perception::reference::stressPlans(seed, queries);
  std::printf("%zu queries on %zu sets (%zu refused, %zu valid), %zu paths, the slowest after %.2f ms\n",
              result.queries, result.sets, result.refused, result.valid, result.found, 1e3 * result.slowest);
  if (result.fault.empty()) return 0;
  std::printf("%s\n", result.fault.c_str());
  return 1;
}
