#include <chrono>
#include <filesystem>
#include <gtest/gtest.h>
#include <iterator>
#include <omp.h>
#include <thread>

#include "numerics/analysed_grid.h"
#include "numerics/blas.h"
#include "numerics/cholesky.h"

extern "C" int openblas_get_num_threads(void);

namespace vasorod {
namespace {

TEST(Blas, IsNamedOnceAndWithItsVersion) {
  const std::string name = blas_name();
  EXPECT_EQ(name.rfind("OpenBLAS ", 0), 0u) << name;
  EXPECT_EQ(name.find("OpenBLAS", 1), std::string::npos) << name;
  EXPECT_NE(name.find_first_of("0123456789"), std::string::npos) << name;
}

TEST(Blas, TakesTheThreadsItIsGivenAndNeverNone) {
  set_blas_threads(2);
  EXPECT_EQ(openblas_get_num_threads(), 2);
  set_blas_threads(0);
  EXPECT_EQ(openblas_get_num_threads(), 1);
  set_blas_threads(-3);
  EXPECT_EQ(openblas_get_num_threads(), 1);
  // Chosen by the caller, it stays: a factorisation does not choose again.
  set_blas_threads(2);
  { const OneCholmodThread one; }
  EXPECT_EQ(openblas_get_num_threads(), 2);
  set_blas_threads(1);
}

// Its own ones, whatever other threads there are; and the system lists one for a moment longer.
TEST(Blas, ItsThreadsEndAndItGoesOnWithOne) {
  const auto threads = [] {
    const std::filesystem::directory_iterator begin("/proc/self/task");
    return std::distance(begin, std::filesystem::directory_iterator());
  };
  set_blas_threads(3);
  const auto with = threads();
  ASSERT_GE(with, 3);
  end_blas_threads();
  for (int k = 0; k < 5000 && threads() > with - 2; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_LE(threads(), with - 2);
  { const OneCholmodThread one; }
  const testing::AnalysedGrid a(9);
  Cholesky cholesky;
  cholesky.analyse(a.matrix);
  EXPECT_TRUE(cholesky.factorise(a.matrix));
  EXPECT_EQ(openblas_get_num_threads(), 1);
}

TEST(Blas, OneCholmodThreadKeepsParallelRegionsToOneThreadAndGivesThemBack) {
  const int before = omp_get_max_active_levels();
  const auto team = [] {
    int size = 0;
#pragma omp parallel num_threads(3)
    {
#pragma omp single
      size = omp_get_num_threads();
    }
    return size;
  };
  {
    const OneCholmodThread one;
    EXPECT_EQ(omp_get_max_active_levels(), 0);
    EXPECT_EQ(team(), 1);
    {
      const OneCholmodThread nested;
      EXPECT_EQ(omp_get_max_active_levels(), 0);
    }
    EXPECT_EQ(omp_get_max_active_levels(), 0);
  }
  EXPECT_EQ(omp_get_max_active_levels(), before);
}

}  // namespace
}  // namespace vasorod
