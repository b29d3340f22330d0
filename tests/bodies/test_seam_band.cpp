#include <gtest/gtest.h>

#include "bodies/seam_band.h"
#include "geometry/triangle_surface.h"
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

// Nothing at the seam and one edge from it, then the path over the band's width, 1 beyond.
TEST(SeamBand, TheShareGrowsFromTheSeamToOne) {
  const int around = 11;
  const TriangleSurface t = tube(1, 10, around, 20);
  std::vector<int> seam;
  for (int k = 0; k < around; ++k) seam.push_back(k);
  const std::vector<double> share = seam_share(t, seam, 1.3);
  const double width = 1.3 + 2 * mean_edge_length(t);
  for (int v = 0; v < around; ++v) {
    EXPECT_EQ(share[static_cast<size_t>(v)], 0);
    EXPECT_EQ(share[static_cast<size_t>(around + v)], 0);
    // Rows are 0.5 apart; a path along edges is at most 2 / sqrt(3) times as long.
    const double second = share[static_cast<size_t>(2 * around + v)];
    EXPECT_GE(second, (1 - 1e-12) / width);
    EXPECT_LE(second, 1.16 / width);
    EXPECT_EQ(share[static_cast<size_t>(6 * around + v)], 1);
  }
}

TEST(SeamBand, NoSeamNoBand) {
  const std::vector<char> band = seam_band(tube(1, 10, 11, 20), {}, 100);
  EXPECT_EQ(std::count(band.begin(), band.end(), 1), 0);
  for (const double share : seam_share(tube(1, 10, 11, 20), {}, 100)) EXPECT_EQ(share, 1);
}

}  // namespace
}  // namespace vasorod
