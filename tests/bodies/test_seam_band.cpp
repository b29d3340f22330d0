#include <gtest/gtest.h>

#include "bodies/seam_band.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

std::vector<int> rows_in_band(const std::vector<char>& band, int around) {
  std::vector<int> rows;
  for (int j = 0; j * around < static_cast<int>(band.size()); ++j)
    if (band[static_cast<size_t>(j * around)]) rows.push_back(j);
  return rows;
}

// Rows of a tube at distance 0.5 with edges of about 0.58: the first ring is the seam.
TEST(SeamBand, ReachesTwoEdgesWithoutAWidth) {
  const int around = 11;
  const TriangleSurface t = tube(1, 10, around, 20);
  std::vector<int> seam;
  for (int k = 0; k < around; ++k) seam.push_back(k);
  EXPECT_EQ(rows_in_band(seam_band(t, seam, 0), around), (std::vector<int>{0, 1, 2}));
}

TEST(SeamBand, GrowsByTheWallsThickness) {
  const int around = 11;
  const TriangleSurface t = tube(1, 10, around, 20);
  std::vector<int> seam;
  for (int k = 0; k < around; ++k) seam.push_back(k);
  EXPECT_EQ(rows_in_band(seam_band(t, seam, 1.3), around), (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(SeamBand, NoSeamNoBand) {
  const std::vector<char> band = seam_band(tube(1, 10, 11, 20), {}, 100);
  EXPECT_EQ(std::count(band.begin(), band.end(), 1), 0);
}

}  // namespace
}  // namespace vasorod
