#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "perception/grid/projection_kernel.hpp"

namespace polygonal_perception::test {

/// The kernels that there are, from the narrowest to the widest.
inline const std::string kKernelNames[] = {"baseline", "AVX2", "AVX-512"};

/// Tests for each kernel. Where it cannot run they are skipped, so that it is seen which were not tested.
class EveryKernel : public testing::TestWithParam<std::string>
{
protected:
  void SetUp() override
  {
    for (const auto& kernel : perception::projectionKernels()) {
      if (kernel.name == GetParam()) kernel_ = &kernel;
    }
    if (kernel_ == nullptr)
      GTEST_SKIP() << "this processor has no " << GetParam() << ", or the build leaves that kernel out";
  }

  const perception::ProjectionKernel& kernel() const { return *kernel_; }

private:
  const perception::ProjectionKernel* kernel_ = nullptr;
};

inline std::string nameOfKernel(const testing::TestParamInfo<std::string>& kernel)
{
  std::string name = kernel.param;
  name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
  return name;
}

}  // namespace polygonal_perception::test
