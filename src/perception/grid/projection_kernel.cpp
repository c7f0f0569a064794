#include "perception/grid/projection_kernel.hpp"

#include <cstring>
#include <limits>
#include <utility>

// What the compilers spell differently. A function that is compiled for a TARGET may be called only where the
// processor has it; Clang and GCC know several ways to say so, and this one also holds for templates.
#define PRAGMA(text) _Pragma(#text)
#if defined(__clang__)
#define SHUFFLE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#define UNROLL PRAGMA(unroll)
#define PUSH_TARGET(isa) PRAGMA(clang attribute push(__attribute__((target(isa))), apply_to = function))
#define POP_TARGET PRAGMA(clang attribute pop)
#else
#define SHUFFLE(a, b, ...) __builtin_shuffle(a, b, Ints{__VA_ARGS__})
#define UNROLL PRAGMA(GCC unroll 8)
#define PUSH_TARGET(isa) PRAGMA(GCC push_options) PRAGMA(GCC target(isa))
#define POP_TARGET PRAGMA(GCC pop_options)
#endif

// The instructions that every processor of an architecture has: SSE2, NEON.
#define KERNEL baseline
#define LANES 4
#define BEGIN_TARGET
#define END_TARGET
#include "perception/grid/projection_kernel.inc"
#undef BEGIN_TARGET
#undef END_TARGET

#if defined(__x86_64__) && !defined(POLYGONAL_PERCEPTION_BASELINE_KERNEL)
#define WIDER_KERNELS

#define KERNEL avx2
#define LANES 8
#define BEGIN_TARGET PUSH_TARGET("avx2")
#define END_TARGET POP_TARGET
#include "perception/grid/projection_kernel.inc"
#undef BEGIN_TARGET

#define KERNEL avx512
#define LANES 16
#define BEGIN_TARGET PUSH_TARGET("avx512f,avx512bw,avx512dq,avx512vl")
#include "perception/grid/projection_kernel.inc"
#endif

namespace polygonal_perception::perception {

const std::vector<ProjectionKernel>& projectionKernels()
{
  static const std::vector<ProjectionKernel> kernels = [] {
    std::vector<ProjectionKernel> runnable = {baseline::kernel("baseline")};
#ifdef WIDER_KERNELS
    if (__builtin_cpu_supports("avx2")) runnable.push_back(avx2::kernel("AVX2"));
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
      runnable.push_back(avx512::kernel("AVX-512"));
    }
#endif
    return runnable;
  }();
  return kernels;
}

}  // namespace polygonal_perception::perception
