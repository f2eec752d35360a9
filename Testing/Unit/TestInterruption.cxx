#include "Interruption.h"

#include "BlockRanges.h"
#include "Distortion.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

#ifdef _OPENMP
#include <omp.h>
#endif

using namespace flatblock;

namespace
{
constexpr std::chrono::milliseconds Interval(25); // between questions, and a little

// Turns of a millisecond each.
int CountTurns(int turns)
{
  std::atomic<int> done{ 0 };
  ParallelLoop loop;
#pragma omp parallel for schedule(dynamic)
  for (int i = 0; i < turns; ++i)
  {
    loop.Do(
      [&]
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ++done;
      });
  }
  loop.Finish();
  return done;
}
} // namespace

TEST(Interruption, LoopsDoAllTurnsWhereNobodyAsks)
{
  EXPECT_EQ(CountTurns(50), 50);
}

TEST(Interruption, TheFirstExceptionOfATurnComesOut)
{
  ParallelLoop loop;
  std::atomic<int> done{ 0 };
#pragma omp parallel for
  for (int i = 0; i < 1000; ++i)
  {
    loop.Do(
      [&]
      {
        ++done;
        if (i % 7 == 3)
        {
          throw std::bad_alloc();
        }
      });
  }
  EXPECT_THROW(loop.Finish(), std::bad_alloc);
  EXPECT_LT(done, 1000);
}

TEST(Interruption, AWishEndsALoop)
{
  const InterruptionScope scope([] { return true; });
  EXPECT_THROW(CountTurns(100000), Interrupted);
}

TEST(Interruption, IsAskedForOnlyNowAndThen)
{
  int questions = 0;
  const InterruptionScope scope(
    [&]
    {
      ++questions;
      return false;
    });
  for (int i = 0; i < 1000; ++i)
  {
    CheckInterruption();
  }
  EXPECT_LE(questions, 1);
  std::this_thread::sleep_for(Interval);
  CheckInterruption();
  EXPECT_GE(questions, 1);
}

TEST(Interruption, ConcernsTheInnermostScopeOfAThread)
{
  const InterruptionScope outer([] { return true; });
  {
    const InterruptionScope inner([] { return false; });
    std::this_thread::sleep_for(Interval);
    EXPECT_NO_THROW(CheckInterruption());
  }
  std::thread([] { EXPECT_EQ(InterruptionScope::Get(), nullptr); }).join();
  std::this_thread::sleep_for(Interval);
  EXPECT_THROW(CheckInterruption(), Interrupted);
  EXPECT_THROW(CheckInterruption(), Interrupted); // and stays so
}

TEST(Interruption, WhatAWishThrowsComesOut)
{
  const InterruptionScope scope([]() -> bool { throw std::logic_error("no"); });
  std::this_thread::sleep_for(Interval);
  EXPECT_THROW(CountTurns(10), std::logic_error);
}

TEST(Interruption, KernelsHeedIt)
{
#ifdef _OPENMP
  omp_set_num_threads(1); // another could do all before this one is asked
#endif
  const InterruptionScope scope([] { return true; });
  std::this_thread::sleep_for(Interval);
  const std::vector<unsigned char> samples(33 * 33 * 33, 1);
  const std::array<int, 3> size = { 33, 33, 33 };
  std::vector<ValueRange> ranges(8);
  EXPECT_THROW(
    ComputeBlockRanges(samples.data(), size, 16, { 2, 2, 2 }, ranges.data()), Interrupted);
  const BlockedVolume volume = { size, { 2, 2, 2 }, 16 };
  std::vector<float> distortion(8);
  ClassifiedTable table(0.0, 1.0, std::vector<ClassifiedColor>(2));
  EXPECT_THROW(
    ComputeDistortion(samples.data(), volume, { 0, 1 }, 1, table, 1, distortion.data(), nullptr),
    Interrupted);
#ifdef _OPENMP
  omp_set_num_threads(omp_get_num_procs());
#endif
}
