// The stress of a wall as it was seen: its forces at rest, no motion from the pressure and the
// stretch that it balances, what a released end does, small changes of the pressure.
#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>

#include "geometry/rigid_motion.h"
#include "numerics/stress_free_search.h"
#include "reference_fem/finite_differences.h"
#include "reference_fem/prestress.h"
#include "reference_fem/stepper.h"
#include "reference_fem/tube_ends.h"

namespace vasorod::fem {
namespace {

constexpr double thickness = 0.2;

TubeShape straight() {
  return {4, 1, thickness, 1, thickness, 0, {}};
}

TubeShape tapered() {
  return {4, 1, thickness, 0.7, 0.15, 0, {}};
}

TubeShape bent() {
  return {4, 1, thickness, 0.8, 0.15, 1.2, {}};
}

struct Tube {
  std::unique_ptr<VesselModel> model;
  Supports supports;  ///< both ends held
  Points rest;
};

Tube make(bool solid, const TubeShape& shape, const MaterialLaw& law, bool soft, int degree = 2,
          int around = 4, int along = 3) {
  Tube tube;
  const auto finish = [&](auto model) {
    for (const int side : {0, 1}) {
      tube.supports.sections.push_back(end_section(*model, shape, side, soft));
      tube.supports.sections.back().fixed.fill(true);
    }
    tube.rest = model->mesh().nodes;
    tube.model = std::move(model);
  };
  const Block block{{around, along, 1}, true, degree};
  if (solid) {
    auto model =
        std::make_unique<Solid>(make_solid(block, [&](const Vec3& p) { return shape.point(p); }),
                                law, [=](const Vec3& p) { return shape.axes(p); });
    model->add_pressure(2, 0, 1);
    finish(std::move(model));
  } else {
    finish(std::make_unique<Shell>(make_surface(block,
                                                [&](const Vec3& p) {
                                                  return shape.point({p[0], p[1], 0.5});
                                                }),
                                   law, tube_body(shape), 3));
  }
  return tube;
}

/// Its wall balances the pressure and the stretch of the scan.
SeenDisplacement see(Tube& tube, const SeenState& seen, double largest_linear = 1) {
  SeenDisplacement found = seen_displacement(*tube.model, seen, tube.supports, largest_linear, {});
  give_prestress(*tube.model, seen, found, {});
  tube.model->set_pressure(seen.pressure);
  return found;
}

struct Path {
  State state;
  System::Assembly assembly;
  StepperSummary summary;
};

Path follow(const Tube& tube, const Supports& supports) {
  System system(*tube.model, supports);
  system.start_from(system.rest());
  Path path;
  path.summary = follow_path(system, path.state, path.assembly);
  EXPECT_EQ(path.summary.status, PathStatus::complete);
  return path;
}

const Moduli elastic = Moduli::isotropic(1, 0.4);
const Moduli fibred{1.7, 0.9, 0.35, 0.2, 0.25, false};

std::vector<MaterialLaw> laws() {
  return {MaterialLaw(LawKind::biot, elastic), MaterialLaw(LawKind::biot, fibred),
          MaterialLaw(LawKind::svk, fibred), MaterialLaw(LawKind::neo_hookean, elastic)};
}

// s = C : e(u) at every Gauss point: its forces on the nodes are the stiffness at rest times u.
TEST(Prestress, ItsForcesAreTheStiffnessTimesTheDisplacement) {
  for (const bool solid : {true, false})
    for (MaterialLaw law : laws()) {
      if (solid && law.kind() == LawKind::neo_hookean) law = MaterialLaw::split(0.4, 20);
      Tube tube = make(solid, bent(), law, false);
      tube.model->set_pressure({});
      const Eigen::VectorXd u = uneven_state(*tube.model, 0.01),
                            rest = Eigen::VectorXd::Zero(u.size());
      CellTerms before, after;
      for (int c = 0; c < 3; ++c) {
        tube.model->set_prestress(1, rest);
        ASSERT_TRUE(tube.model->evaluate(c, rest, 0, true, before));
        tube.model->set_prestress(1, u);
        ASSERT_TRUE(tube.model->evaluate(c, rest, 0, false, after));
        const std::vector<int> dofs = tube.model->dofs(c);
        Eigen::VectorXd own(static_cast<Eigen::Index>(dofs.size()));
        for (std::size_t k = 0; k < dofs.size(); ++k)
          own[static_cast<Eigen::Index>(k)] = u[dofs[k]];
        const Eigen::VectorXd force = before.tangent * own;
        EXPECT_LT((after.residual - force).norm(), 1e-12 * force.norm()) << to_string(law.kind());
        EXPECT_NEAR(after.energy, 0.5 * own.dot(force), 1e-12 * after.energy);
      }
    }
}

// Its strain in the wall's surface, by which it is judged, is that of the displacement and the
// stretch.
TEST(Prestress, ItsStrainIsThatOfItsDisplacement) {
  Mat3 gradient;
  gradient << 0.02, 0, 0, 0, 0.02, 0, 0.03, 0, 0.01;
  const double around = 0.02 - 0.4 * 0.04, along = 0.01 + 0.04, shear = 0.015,
               expected = std::sqrt(around * around + along * along + shear * shear);
  for (const bool solid : {true, false}) {
    const Tube tube = make(solid, straight(), laws()[0], false, 3, 6, 3);
    const VesselModel& model = *tube.model;
    Eigen::VectorXd u = Eigen::VectorXd::Zero(model.dof_count());
    for (int node = 0; node < tube.rest.rows(); ++node) {
      const int first = model.components() * node;
      u.segment<3>(first) = gradient * tube.rest.row(node).transpose();
      if (!solid)
        u.segment<3>(first + 3) =
            gradient * static_cast<const Shell&>(model).directors().row(node).transpose();
    }
    EXPECT_NEAR(model.rms_prestrain(1.04, u, {}), expected, 1e-5) << solid;
  }
}

// A wall at the pressure and the stretch of the scan stays where it was seen.
TEST(Prestress, NothingMovesAtThePressureOfTheScan) {
  const SeenState seen{{0.02, 0.02}, 1.08};
  for (const bool solid : {true, false})
    for (const TubeShape& shape : {straight(), tapered(), bent()})
      for (const bool soft : {false, true})
        for (const MaterialLaw& law : laws()) {
          SCOPED_TRACE(::testing::Message() << solid << soft << to_string(law.kind()) << shape.bend
                                            << ' ' << shape.end_radius);
          Tube tube = make(solid, shape, law, soft);
          see(tube, seen);
          const System system(*tube.model, tube.supports);
          System::Assembly at_rest;
          system.assemble(system.rest(), 0, false, at_rest);
          if (!soft) {
            EXPECT_LT(at_rest.relative_residual(), 1e-12);
          }
          const Path path = follow(tube, tube.supports);
          EXPECT_LT(path.state.u.cwiseAbs().maxCoeff(), 1e-9);
        }
}

TEST(Prestress, NorByTheSplitLaw) {
  Tube tube = make(true, bent(), MaterialLaw::split(0.4, 200), false);
  see(tube, {{0.02, 0.02}, 1.05});
  EXPECT_LT(follow(tube, tube.supports).state.u.cwiseAbs().maxCoeff(), 1e-9);
}

// Under loads that widen or stretch it by a tenth to a third of its radius, from the shape that it
// has without stress.
TEST(Prestress, NothingMovesFromAFarShapeWithoutStress) {
  const SeenState seen{{0.06, 0.06}, 1.1};
  for (const bool solid : {true, false})
    for (const TubeShape& shape : {straight(), bent()})
      for (const bool soft : {false, true})
        for (MaterialLaw law : laws()) {
          if (solid && law.kind() == LawKind::neo_hookean) law = MaterialLaw::split(0.4, 200);
          SCOPED_TRACE(::testing::Message()
                       << solid << soft << to_string(law.kind()) << shape.bend);
          Tube tube = make(solid, shape, law, soft);
          const SeenDisplacement found = see(tube, seen, 0.1);
          EXPECT_GT(found.steps, 0);
          EXPECT_LT(found.steps, 200);
          EXPECT_GT(found.largest, 0.1);
          const Path path = follow(tube, tube.supports);
          EXPECT_LT(path.state.u.cwiseAbs().maxCoeff(), 1e-9);
          EXPECT_GT(path.assembly.energy, 1e-3);
        }
}

// A stretch alone displaces little, but by its strain: that is enough for a shape, and its length
// is the shape's when the ends are let go.
TEST(Prestress, OfALargeStretchItIsFromTheShapeWithoutStress) {
  for (const bool solid : {true, false})
    for (MaterialLaw law : laws()) {
      if (solid && law.kind() == LawKind::neo_hookean) law = MaterialLaw::split(0.4, 200);
      SCOPED_TRACE(::testing::Message() << solid << to_string(law.kind()));
      Tube tube = make(solid, straight(), law, true);
      const SeenDisplacement found = see(tube, {{}, 1.2}, largest_linear_prestrain);
      EXPECT_GT(found.steps, 0);
      EXPECT_LT(found.steps, 30);
      EXPECT_LT(follow(tube, tube.supports).state.u.cwiseAbs().maxCoeff(), 1e-9);
      Supports released = tube.supports;
      released.sections[1].fixed[2] = false;
      const Path path = follow(tube, released);
      EXPECT_NEAR(path.state.pose[1].position[2], 4 / 1.2, 1e-3);
      EXPECT_LT(path.assembly.energy, 1e-5);  // of 0.1; the shell: AReleasedEndSpringsBack
    }
}

// Where the shape without stress lies does not count: its fibres turn with it.
TEST(Prestress, ATurnedShapeWithoutStressIsTheSame) {
  const Mat3 turn = exp_rotation(Vec3(0.5, -0.3, 0.9));
  for (const bool solid : {true, false}) {
    const Tube tube = make(solid, bent(), MaterialLaw(LawKind::biot, fibred), false);
    VesselModel& model = *tube.model;
    model.set_pressure({});
    const int components = model.components();
    Eigen::VectorXd u = Eigen::VectorXd::Zero(model.dof_count());
    for (int node = 0; node < tube.rest.rows(); ++node) {
      const Vec3 x = tube.rest.row(node);
      u.segment<3>(components * node) = x - turn * x;
      if (solid) continue;
      const Vec3 director = static_cast<const Shell&>(model).directors().row(node);
      u.segment<3>(components * node + 3) = director - turn * director;
    }
    const Eigen::VectorXd now = uneven_state(model, 0.02);
    CellTerms one, other;
    for (int c = 0; c < 3; ++c) {
      ASSERT_TRUE(model.set_stress_free_shape(1.2, Eigen::VectorXd::Zero(u.size())));
      ASSERT_TRUE(model.evaluate(c, now, 0, false, one));
      ASSERT_TRUE(model.set_stress_free_shape(1.2, u));
      ASSERT_TRUE(model.evaluate(c, now, 0, false, other));
      EXPECT_NEAR(other.energy, one.energy, 1e-12 * one.energy) << solid;
      EXPECT_LT((other.residual - one.residual).norm(), 1e-11 * one.residual.norm()) << solid;
    }
  }
}

// Without its pressure the vessel has the shape that was found, and no stress.
TEST(Prestress, WithoutItsPressureItHasTheShapeWithoutStress) {
  for (const MaterialLaw& law : laws()) {
    Tube tube = make(true, bent(), law, false);
    const SeenDisplacement found = see(tube, {{0.06, 0}, 1}, 0.1);
    EXPECT_GT(found.largest, 0.1);
    const Path path = follow(tube, tube.supports);
    EXPECT_LT((path.state.u + found.u).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_LT(path.assembly.energy, 1e-15);
  }
}

// An incompressible neo-Hookean tube in plane strain: r^2 = R^2 + c from inner to outer face, and
//   p = int mu (k^2 - k^-2) dr / r,   k = r / R.
TEST(Prestress, TheShapeWithoutStressIsTheClosedForm) {
  const double mu = 0.4, inner = 1 - thickness / 2;
  const double unloaded = 0.75 * inner, c = inner * inner - unloaded * unloaded;
  double pressure = 0;
  const int steps = 2000;
  for (int i = 0; i < steps; ++i) {
    const double r = inner + (i + 0.5) / steps * thickness, square = r * r / (r * r - c);
    pressure += mu * (square - 1 / square) / r * thickness / steps;
  }
  Tube tube = make(true, straight(), MaterialLaw::split(mu, 400), true, 3, 6, 2);
  const SeenDisplacement found = see(tube, {{pressure, pressure}, 1}, 0.1);
  EXPECT_GT(found.steps, 0);
  for (int node = 0; node < tube.rest.rows(); ++node) {
    const Vec3 x = tube.rest.row(node), u = found.u.segment<3>(3 * node);
    if (std::abs(x.z() - 2) > 0.1) continue;  // soft ends warp
    const double r = x.head<2>().norm();
    EXPECT_NEAR((x - u).head<2>().norm(), std::sqrt(r * r - c), 5e-4) << x.transpose();
    EXPECT_NEAR(u.z(), 0, 1e-9);
  }
}

// The held ends of a straight tube carry E (stretch - 1) A, whatever its law.
TEST(Prestress, HeldEndsCarryThePrestretch) {
  for (const bool solid : {true, false})
    for (const MaterialLaw& law : laws()) {
      Tube tube = make(solid, straight(), law, false, 3, 6, 3);
      see(tube, {{}, 1.05});
      const Path path = follow(tube, tube.supports);
      EXPECT_EQ(path.summary.positive_definite, true);
      const double young = 1 / law.linear_stiffness().inverse()(2, 2),
                   force = young * 0.05 * 2 * M_PI * thickness;
      EXPECT_NEAR(path.assembly.section_force[1][2], force, 1e-4 * force);
      EXPECT_NEAR(path.assembly.section_force[0][2], -force, 1e-4 * force);
      EXPECT_LT(path.assembly.section_force[1].head<2>().norm(), 1e-10);
    }
}

/// Axial strain of a bar of unit modulus under an axial stress of -0.05, by its law.
double released_stretch(const MaterialLaw& law) {
  const auto stress = [&](double along) {  // with the sides free
    double across = 1;
    Response at;
    for (int i = 0; i < 60; ++i) {
      const Mat3 F = Vec3(across, across, along).asDiagonal();
      at = law.evaluate(F);
      at += law.of_prestress(F, law.linear_stiffness() * law.uniaxial_strain(1.05));
      const double slope = (at.tangent(0, 0) + at.tangent(0, 1)) * across;
      across -= at.stress[0] / slope;
    }
    return at.stress[2];
  };
  double low = 0.8, high = 1.1;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (stress(middle) < 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// A straight tube whose soft ends are let go springs back to the state without stress: by laws that
// are linear in their strain, 1 - 0.05 (U - I) and sqrt(1 - 2 0.05) (E); else the bar's.
TEST(Prestress, AReleasedEndSpringsBack) {
  for (const bool solid : {true, false})
    for (const MaterialLaw& law : laws()) {
      SCOPED_TRACE(to_string(law.kind()));
      Tube tube = make(solid, straight(), law, true, 3, 6, 2);
      see(tube, {{}, 1.05});
      Supports supports = tube.supports;
      supports.sections[1].fixed[2] = false;
      const Path path = follow(tube, supports);
      const double stretch = path.state.pose[1].position[2] / 4;
      // The shell's quadrature on a curved surface is not exact: without a load, its wall at rest
      // is not quite in balance with a constant stress.
      const double tolerance = solid ? 1e-8 : 2e-5;
      EXPECT_NEAR(stretch, released_stretch(law), tolerance);
      if (law.kind() == LawKind::biot) {
        EXPECT_NEAR(stretch, 0.95, tolerance);
        EXPECT_NEAR(path.assembly.energy, 0, 1e-8);
      }
      if (law.kind() == LawKind::svk) {
        EXPECT_NEAR(stretch, std::sqrt(0.9), tolerance);
      }
      EXPECT_LT(path.assembly.section_force[0].norm(), 1e-8);
    }
}

// From its scan's pressure, a small change moves a wall as it moves one without stress: what the
// stress adds is of second order.
TEST(Prestress, ASmallChangeOfPressureIsThatOfAWallWithoutStress) {
  const double small = 1e-6;
  for (const bool solid : {true, false}) {
    Tube plain = make(solid, bent(), laws()[0], false),
         seen = make(solid, bent(), laws()[0], false);
    plain.model->set_pressure({0, small});
    see(seen, {{1e-4, 1e-4 + small}, 1});
    const Eigen::VectorXd expected = follow(plain, plain.supports).state.u,
                          found = follow(seen, seen.supports).state.u;
    EXPECT_LT((found - expected).norm(), 5e-3 * expected.norm());
    EXPECT_GT((found - expected).norm(), 1e-6 * expected.norm());
  }
}

// The force and the moment that held the ends fade along the path, where an end is let go: the path
// begins in equilibrium.
TEST(Prestress, APathBeginsAsSeen) {
  Tube tube = make(false, bent(), laws()[0], false);
  see(tube, {{0.01, 0.01}, 1.04});
  Supports supports = tube.supports;
  supports.sections[1].fixed.fill(false);
  System system(*tube.model, supports);
  System::Assembly assembly;
  system.assemble(system.rest(), 0, false, assembly);
  EXPECT_GT(assembly.relative_residual(), 1e-3);
  system.start_from(system.rest());
  system.assemble(system.rest(), 0, false, assembly);
  EXPECT_EQ(assembly.residual.norm(), 0);
  const Path path = follow(tube, supports);
  EXPECT_LT(path.assembly.section_force[1].norm(), 1e-9);
}

}  // namespace
}  // namespace vasorod::fem
