#include "CudaDevice.h"

#include <gtest/gtest.h>

TEST(CudaDevice, SaysWhyNoneAnswers)
{
  const flatblock::CudaDevice device = flatblock::FindCudaDevice();
  EXPECT_FALSE(device.Name.empty());
  EXPECT_TRUE(device.Compiled || !device.Answers);
}

TEST(CudaDevice, RunsAKernel)
{
  const flatblock::CudaDevice device = flatblock::FindCudaDevice();
  if (!device.Answers)
  {
    GTEST_SKIP() << "No CUDA device answers: " << device.Name;
  }
  EXPECT_GT(device.MemoryBytes, 0U);
}
