#include <gtest/gtest.h>

#include "bodies/spring_coefficients.h"
#include "paper/bending_energy.h"
#include "paper/paper_tubes.h"
#include "paper/stretching_energy.h"

namespace vasorod {
namespace {

using namespace testing;

// An equilateral patch. Its interior vertices are at least two edges from the rim.
struct Patch {
  TriangleSurface surface;
  std::vector<char> inside;
  double h = 0.4;
  Patch() {
    const int n = 16;
    surface.points.resize(n * n, 3);
    inside.assign(static_cast<size_t>(n * n), 0);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        surface.points.row(j * n + i) << h * (i + 0.5 * j), h * std::sqrt(0.75) * j, 0;
        inside[static_cast<size_t>(j * n + i)] = i > 1 && j > 1 && i < n - 2 && j < n - 2;
      }
    std::vector<Eigen::Vector3i> t;
    for (int j = 0; j + 1 < n; ++j)
      for (int i = 0; i + 1 < n; ++i) {
        const int a = j * n + i;
        t.emplace_back(a, a + 1, a + n);
        t.emplace_back(a + 1, a + n + 1, a + n);
      }
    surface.triangles.resize(static_cast<int>(t.size()), 3);
    for (size_t k = 0; k < t.size(); ++k)
      surface.triangles.row(static_cast<int>(k)) = t[k].transpose();
  }
  double vertex_area() const { return std::sqrt(0.75) * h * h; }
};

constexpr double young = 3, poisson = 1.0 / 3, thickness = 0.05;

Coefficients of(const Patch& patch) {
  return coefficients_from_wall(Material::isotropic(young, poisson),
                                {thickness, 5, patch.h, patch.vertex_area()});
}

// Spring energy per area of an inner triangle's share (half of each edge), to compare with the
// plane stress energy of a sheet with E t and nu = 1/3.
double spring_density(const Patch& patch, const Eigen::Matrix2d& strain) {
  const double k = of(patch).stretching;
  double sum = 0;
  for (const double angle : {0.0, std::numbers::pi / 3, 2 * std::numbers::pi / 3}) {
    const Vec2 e = patch.h * Vec2(std::cos(angle), std::sin(angle));
    Points p(2, 3);
    p << 0, 0, 0, (e + strain * e).x(), (e + strain * e).y(), 0;
    sum += stretching_energy(k, {{0, 1, patch.h}}, p);
  }
  return sum / patch.vertex_area();  // three edges per vertex
}

double sheet_density(const Eigen::Matrix2d& strain) {
  const double trace = strain.trace();
  return young * thickness / (2 * (1 - poisson * poisson)) *
         ((1 - poisson) * strain.squaredNorm() + poisson * trace * trace);
}

TEST(Coefficients, SpringsCarryThePlaneModulusOfTheWall) {
  const Patch patch;
  const double e = 1e-5;
  for (const Eigen::Matrix2d& strain :
       {Eigen::Matrix2d{{e, 0}, {0, e}}, Eigen::Matrix2d{{e, 0}, {0, 0}},
        Eigen::Matrix2d{{0, e}, {e, 0}}, Eigen::Matrix2d{{0, 0}, {0, e}}})
    EXPECT_NEAR(spring_density(patch, strain) / sheet_density(strain), 1, 2e-5);
}

TEST(Coefficients, TheUmbrellaCarriesThePlateModulusOfTheWall) {
  const Patch patch;
  const int n = static_cast<int>(patch.surface.points.rows());
  const Umbrella umbrella(edges_of(patch.surface.triangles), n);
  const double plate = young * std::pow(thickness, 3) / (12 * (1 - poisson * poisson));
  // w = (c1 x^2 + c2 y^2) / 2: the plate energy per area is D/2 (c1 + c2)^2 without the Gaussian
  // part
  for (const auto& [c1, c2] : {std::pair{1e-3, 0.0}, std::pair{0.0, 1e-3}, std::pair{1e-3, 2e-3}}) {
    Points p = patch.surface.points;
    for (int i = 0; i < n; ++i) p(i, 2) = 0.5 * (c1 * p(i, 0) * p(i, 0) + c2 * p(i, 1) * p(i, 1));
    const Points l = umbrella.apply(p);
    double sum = 0;
    int count = 0;
    for (int i = 0; i < n; ++i)
      if (patch.inside[static_cast<size_t>(i)]) {
        sum += of(patch).bending * l(i, 2) * l(i, 2);
        ++count;
      }
    EXPECT_NEAR(sum / (count * patch.vertex_area()) / (0.5 * plate * (c1 + c2) * (c1 + c2)), 1,
                1e-9);
  }
}

TEST(Coefficients, RatioOfStretchingToBendingIsThatOfTheMeshAndTheWall) {
  const Patch patch;
  const Coefficients k = of(patch);
  EXPECT_NEAR(k.stretching / k.bending,
              0.75 * (1 - poisson * poisson) * std::pow(patch.h / thickness, 2), 1e-9);
  EXPECT_NEAR(k.binding, 0.01 * young * thickness / 25 * patch.vertex_area(), 1e-15);
}

}  // namespace
}  // namespace vasorod
