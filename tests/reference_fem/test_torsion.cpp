// Finite torsion and stretch of the tube ri = 9, ro = 11. Torque and axial force of the exact
// one-dimensional solutions were computed independently. The one-dimensional minimiser here and the
// solid must agree with them to every digit printed. The solid is a piece of the infinite tube
// whose end sections have the exact deformed shape.
#include <gtest/gtest.h>

#include "reference_fem/in_one_step.h"
#include "reference_fem/solid.h"
#include "reference_fem/tube.h"
#include "reference_fem/uniform_torsion.h"

namespace vasorod::fem {
namespace {

using reference::free_stretch;
using reference::UniformTorsion;

constexpr double inner = 9, outer = 11, J = 12692.0343205028;

struct Resultants {
  double torque = 0, force = 0;
};

/// One cell along the axis, 4 around, one through the wall.
Resultants solid_piece(const MaterialLaw& law, double twist, double stretch) {
  const double L = 4;
  const TubeShape tube{L, 10, 2, 10, 2, 0, {}};
  const UniformTorsion exact(law, inner, outer, twist, stretch);
  const Solid solid(make_solid({{6, 1, 1}, true, 4}, [&](const Vec3& p) { return tube.point(p); }),
                    law, [&](const Vec3& p) { return tube.axes(p); });
  const Mesh& mesh = solid.mesh();
  Supports supports;
  const auto end = [&](const Vec3& X) {
    const double R = X.head<2>().norm(), r = exact.radius(R),
                 angle = std::atan2(X[1], X[0]) + twist * X[2];
    return Vec3(r * std::cos(angle), r * std::sin(angle), stretch * X[2]);
  };
  const auto moved = [&](const Vec3& X) { return Vec3(end(X) - X); };
  const std::vector<int> top = mesh.nodes_on(1, 1);
  hold_at(supports, mesh.nodes, mesh.nodes_on(1, 0), moved);
  hold_at(supports, mesh.nodes, top, moved);
  const auto [state, assembly] = in_one_step(solid, supports, 1e-11);
  Resultants out;
  for (const int node : top) {
    const Vec3 x = mesh.nodes.row(node).transpose() + state.u.segment<3>(3 * node),
               f = assembly.nodal.segment<3>(3 * node);
    out.torque += x[0] * f[1] - x[1] * f[0];
    out.force += f[2];
  }
  return out;
}

TEST(Torsion, CompressibleLaws) {
  struct Row {
    LawKind law;
    double twist, torque, force, free_stretch, free_torque;
  };
  for (const Row& row :
       {Row{LawKind::svk, 0.005, 24.24830225, 0.08500331, 0.9993225462, 24.22537668},
        Row{LawKind::svk, 0.02, 88.08528159, 1.26397809, 0.9896965602, 86.87680741},
        Row{LawKind::svk, 0.05, 136.25577689, 5.45703027, 0.9496706212, 129.22347429},
        Row{LawKind::neo_hookean, 0.01, 48.48188468, -0.14585611, 1.0011598957, 48.44821181},
        Row{LawKind::neo_hookean, 0.05, 209.14817605, -3.33668427, 1.0261541601, 206.00993164}}) {
    const MaterialLaw law(row.law, Moduli::isotropic(1, 0.3));
    const UniformTorsion fixed(law, inner, outer, row.twist, 1);
    EXPECT_NEAR(fixed.torque() / row.torque, 1, 1e-8);
    EXPECT_NEAR(fixed.force() / row.force, 1, 1e-6);
    const double l = free_stretch(law, inner, outer, row.twist);
    EXPECT_NEAR(l, row.free_stretch, 1e-8);
    const Resultants held = solid_piece(law, row.twist, 1), free = solid_piece(law, row.twist, l);
    EXPECT_NEAR(held.torque / row.torque, 1, 1e-6) << to_string(row.law) << row.twist;
    EXPECT_NEAR(held.force / row.torque, row.force / row.torque, 1e-6)
        << to_string(row.law) << row.twist;
    EXPECT_NEAR(free.torque / row.free_torque, 1, 1e-6) << to_string(row.law) << row.twist;
    EXPECT_LT(std::abs(free.force), 1e-6 * row.torque);
  }
}

// Rivlin's torsion of an incompressible neo-Hookean tube, mu = 1, as the limit of the split law. A
// bulk modulus of 1e5 mu gives an error below 1e-6.
TEST(Torsion, RivlinsIncompressibleTube) {
  struct Row {
    double twist, torque, force, inner, outer;
  };
  for (const Row& row : {Row{0.001, 12.69141855, -0.00634586, 8.99972777, 10.99977726},
                         Row{0.01, 126.30915450, -0.63306990, 8.97293884, 10.97787008},
                         Row{0.05, 569.70850430, -15.00813472, 8.40665954, 10.52007246}}) {
    const MaterialLaw law = MaterialLaw::split(1, 1e5);
    const UniformTorsion exact(law, inner, outer, row.twist, 1);
    EXPECT_NEAR(exact.radius(inner), row.inner, 1e-5);
    EXPECT_NEAR(exact.radius(outer), row.outer, 1e-5);
    const Resultants solid = solid_piece(law, row.twist, 1);
    EXPECT_NEAR(solid.torque / row.torque, 1, 1e-6) << row.twist;
    EXPECT_NEAR(solid.force / row.torque, row.force / row.torque, 1e-6) << row.twist;
  }
}

// Torque over G J D of a transversely isotropic tube, E = 1, nu = 0.3, G = f / 2.6, S = C : E, at
// fixed length and with zero axial force: every factor and twist of the table.
TEST(Torsion, TransverselyIsotropicTable) {
  struct Row {
    double twist;
    std::array<std::array<double, 2>, 5> ratio;  // f = 0.01, 0.1, 1, 10, 100: fixed, free
  };
  const std::array<double, 5> factors{0.01, 0.1, 1, 10, 100};
  for (const Row& row : {Row{1e-4,
                             {{{1.000132, 1.000002},
                               {1.000012, 1},
                               {0.999997, 0.999997},
                               {0.999971, 0.999970},
                               {0.999723, 0.999696}}}},
                         Row{5e-4,
                             {{{1.003299, 1.000047},
                               {1.000296, 0.999997},
                               {0.999934, 0.999925},
                               {0.999285, 0.999242},
                               {0.993115, 0.992453}}}},
                         Row{1e-3,
                             {{{1.013195, 1.000187},
                               {1.001184, 0.999990},
                               {0.999738, 0.999699},
                               {0.997143, 0.996972},
                               {0.972880, 0.970316}}}},
                         Row{2e-3,
                             {{{1.052763, 1.000747},
                               {1.004734, 0.999959},
                               {0.998951, 0.998799},
                               {0.988645, 0.987970},
                               {0.897795, 0.888755}}}},
                         Row{5e-3,
                             {{{1.329113, 1.004667},
                               {1.029505, 0.999741},
                               {0.993467, 0.992528},
                               {0.932074, 0.928226},
                               {0.551364, 0.524947}}}}})
    for (std::size_t k = 0; k < factors.size(); ++k) {
      const double G = factors[k] / 2.6, scale = G * J * row.twist;
      const MaterialLaw law(LawKind::svk, {1, 1, 0.3, 0.3, G, false});
      const double l = free_stretch(law, inner, outer, row.twist);
      EXPECT_NEAR(solid_piece(law, row.twist, 1).torque / scale, row.ratio[k][0], 5e-6)
          << row.twist << " " << factors[k];
      EXPECT_NEAR(solid_piece(law, row.twist, l).torque / scale, row.ratio[k][1], 5e-6)
          << row.twist << " " << factors[k];
    }
}

}  // namespace
}  // namespace vasorod::fem
