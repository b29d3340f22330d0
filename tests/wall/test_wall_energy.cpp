#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "geometry/rigid_motion.h"
#include "wall/wall_energy.h"
#include "wall/walls.h"

namespace vasorod {
namespace {

const Material isotropic = Material::isotropic(1, 0.3);
const Material fibred{Law::biot, 2, 1, 0.1, 0.4, 0.2};

const Material stiff_in_shear{Law::biot, 2, 1, 30, 0.4, 0.2};
const Material neo_hookean = Material::isotropic(1, 0.45, Law::neo_hookean);

struct Case {
  const char* name;
  WallInput input;
};

// A tube without two of its triangles: the rims of a slit are free; the tube's ends are glued.
WallInput slit_wall(const Material& material) {
  WallInput in = tube_wall(tube(3, 1, 7, 4), 0.3, material, true);
  Triangles kept = in.rest.triangles;
  std::vector<Vec3> axis;
  int n = 0;
  for (int t = 0; t < in.rest.triangles.rows(); ++t) {
    if (t == 24 || t == 25) continue;
    kept.row(n++) = in.rest.triangles.row(t);
    axis.push_back(in.axis[static_cast<size_t>(t)]);
  }
  in.rest.triangles = kept.topRows(n);
  in.axis = axis;
  return in;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const bool glued : {false, true}) {
    Material svk = fibred;
    svk.law = Law::svk;
    all.push_back({glued ? "isotropic glued" : "isotropic",
                   tube_wall(tube(3, 1, 7, 4), 0.3, isotropic, glued)});
    all.push_back(
        {glued ? "fibred glued" : "fibred", tube_wall(tube(3, 1, 7, 4), 0.3, fibred, glued)});
    all.push_back({glued ? "svk glued" : "svk", tube_wall(tube(3, 1, 7, 4), 0.3, svk, glued)});
    all.push_back({glued ? "neo-hookean glued" : "neo-hookean",
                   tube_wall(tube(3, 1, 7, 4), 0.3, neo_hookean, glued)});
  }
  all.push_back({"slit", slit_wall(fibred)});
  all.push_back({"neo-hookean slit", slit_wall(neo_hookean)});
  all.push_back({"stiff in shear", slit_wall(stiff_in_shear)});
  all.push_back({"three around", tube_wall(tube(3, 1, 3, 2), 0.3, fibred, true)});
  for (const Material& material : {isotropic, stiff_in_shear, neo_hookean}) {
    Case leaning{"leaning", slit_wall(material)};
    leaning.input.lean = Points::Zero(leaning.input.rest.points.rows(), 3);
    for (int v = 0; v < leaning.input.lean.rows(); ++v)
      if (v % 5 != 2) leaning.input.lean.row(v) << 0.1 * v, 0.2, 1;
    all.push_back(leaning);
  }
  Case outer{"outer face", tube_wall(tube(3, 1, 7, 4), 0.3, isotropic, true)};
  outer.input.mid_offset = -0.15;
  all.push_back(outer);
  return all;
}

Eigen::MatrixXd full_hessian(WallEnergy& wall, const Eigen::VectorXd& q) {
  return Eigen::SparseMatrix<double>(wall.hessian(q).selfadjointView<Eigen::Lower>());
}

Eigen::VectorXd disturbed(const WallEnergy& wall, double size, unsigned seed) {
  return wall.rest() + size * noise(wall.unknowns(), seed);
}

TEST(WallEnergy, ZeroAtRest) {
  for (const Case& c : cases()) {
    const WallEnergy wall(c.input);
    Eigen::VectorXd g;
    EXPECT_NEAR(wall.gradient(wall.rest(), g), 0, 1e-24) << c.name;
    EXPECT_LT(g.norm(), 1e-12) << c.name;
  }
}

// Entries of q that a part around the marked vertices has complete: theirs, their leans' and those
// of their edges.
std::vector<int> entries_of(const WallEnergy& wall, const std::vector<char>& marked) {
  const auto is_marked = [&](int v) { return marked[static_cast<size_t>(v)] != 0; };
  std::vector<int> entries;
  for (int v = 0; v < wall.vertices(); ++v)
    for (int k = 0; k < 3 && is_marked(v); ++k) entries.push_back(3 * v + k);
  for (const WallEdge& edge : wall.edges())
    if (!edge.glued && (is_marked(edge.a) || is_marked(edge.b))) entries.push_back(edge.unknown);
  for (const WallLean& lean : wall.leans())
    if (is_marked(lean.vertex)) entries.push_back(lean.unknown);
  return entries;
}

TEST(WallEnergy, APartHasTheDerivativesOfTheWholeAtItsVertices) {
  for (const Case& c : cases()) {
    WallEnergy wall(c.input);
    const Eigen::VectorXd q = disturbed(wall, 0.08, 1);
    std::vector<char> marked(static_cast<size_t>(wall.vertices()), 0);
    marked[5] = marked[6] = 1;
    const WallPart part = wall.part(marked);
    const std::vector<int> at = entries_of(wall, marked);
    Eigen::VectorXd whole_gradient, gradient;
    wall.gradient(q, whole_gradient);
    const double energy = wall.gradient(q, gradient, part);
    EXPECT_LT((gradient - whole_gradient)(at).norm(), 1e-14 * whole_gradient.norm()) << c.name;
    const Eigen::MatrixXd whole = full_hessian(wall, q);
    const Eigen::MatrixXd hessian =
        Eigen::SparseMatrix<double>(wall.hessian(q, part).selfadjointView<Eigen::Lower>());
    EXPECT_LT((hessian - whole)(at, at).norm(), 1e-14 * whole.norm()) << c.name;
    // What the part leaves out does not depend on them.
    Eigen::VectorXd moved = q;
    for (const int entry : at) moved[entry] += 0.01;
    Eigen::VectorXd ignored;
    EXPECT_NEAR(wall.gradient(moved, ignored, part) - energy, wall.value(moved) - wall.value(q),
                1e-12 * wall.value(q))
        << c.name;
  }
}

Eigen::MatrixXd convex_part(WallEnergy& wall, const Eigen::VectorXd& q) {
  return Eigen::SparseMatrix<double>(
      wall.hessian(q, SecondDerivatives::convex).selfadjointView<Eigen::Lower>());
}

double least_eigenvalue(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
      .eigenvalues()[0];
}

TEST(WallEnergy, ConvexPartIsPositiveSemidefiniteWhereTheHessianIsNot) {
  for (const Case& c : cases()) {
    WallEnergy wall(c.input);
    for (const double size : {0.08, 0.3}) {
      const Eigen::VectorXd q = disturbed(wall, size, 1);
      const Eigen::MatrixXd convex = convex_part(wall, q), whole = full_hessian(wall, q);
      EXPECT_GT(least_eigenvalue(convex), -1e-12 * convex.norm()) << c.name << ", " << size;
      EXPECT_LT(least_eigenvalue(whole), -1e-4 * whole.norm()) << c.name << ", " << size;
    }
  }
}

TEST(WallEnergy, WithoutStressTheHessianIsItsConvexPart) {
  for (const Case& c : cases()) {
    WallEnergy wall(c.input);
    const Eigen::MatrixXd whole = full_hessian(wall, wall.rest());
    EXPECT_LT((convex_part(wall, wall.rest()) - whole).norm(), 1e-12 * whole.norm()) << c.name;
  }
}

// Green's strain is linear in C: nothing is left out but what compression adds.
TEST(WallEnergy, OfAFlatWallInTensionTheHessianIsItsConvexPart) {
  WallInput flat;
  flat.rest.points.resize(12, 3);
  for (int i = 0; i < 12; ++i) flat.rest.points.row(i) << i % 4, i / 4 + 0.2 * (i % 4), 0;
  flat.rest.triangles.resize(12, 3);
  for (int i = 0; i < 6; ++i) {
    const int a = i % 3 + 4 * (i / 3);
    flat.rest.triangles.row(2 * i) << a, a + 1, a + 5;
    flat.rest.triangles.row(2 * i + 1) << a, a + 5, a + 4;
  }
  flat.thickness.setConstant(12, 0.1);
  flat.axis.assign(12, Vec3::UnitX());
  flat.material = Material::isotropic(1, 0.3, Law::svk);
  WallEnergy wall(flat);
  const auto apart = [&](double along, double across) {
    Eigen::VectorXd q = wall.rest();
    for (int v = 0; v < 12; ++v) {
      q[3 * v] *= along;
      q[3 * v + 1] *= across;
    }
    const Eigen::MatrixXd whole = full_hessian(wall, q);
    return (convex_part(wall, q) - whole).norm() / whole.norm();
  };
  EXPECT_LT(apart(1.2, 1.1), 1e-12);
  EXPECT_GT(apart(1.2, 0.7), 1e-2);
}

TEST(WallEnergy, APartOfALongTubeIsSmall) {
  const WallEnergy wall(tube_wall(tube(12, 1, 12, 16), 0.3, isotropic, true));
  std::vector<char> marked(static_cast<size_t>(wall.vertices()), 0);
  marked[100] = 1;
  const WallPart part = wall.part(marked);
  EXPECT_EQ(part.triangles.size(), 12u);  // six around the vertex, six across their outer edges
  EXPECT_LT(part.seen.size(), 31u);
  EXPECT_LT(part.edges.size(), 31u);
}

TEST(WallEnergy, GradientAgainstDifferences) {
  for (const Case& c : cases()) {
    const WallEnergy wall(c.input);
    const Eigen::VectorXd q = disturbed(wall, 0.08, 1);
    Eigen::VectorXd g;
    const double value = wall.gradient(q, g);
    EXPECT_NEAR(value, wall.value(q), 1e-13 * value) << c.name;
    const double h = 1e-5;
    for (int i = 0; i < wall.unknowns(); ++i) {
      const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(wall.unknowns(), i);
      EXPECT_NEAR((wall.value(q + step) - wall.value(q - step)) / (2 * h), g[i], 1e-7)
          << c.name << " " << i;
    }
  }
}

TEST(WallEnergy, HessianAgainstDifferencesOfTheGradient) {
  for (const Case& c : cases()) {
    WallEnergy wall(c.input);
    const Eigen::VectorXd q = disturbed(wall, 0.08, 2);
    const Eigen::MatrixXd hessian = full_hessian(wall, q);
    const double h = 1e-5;
    for (int i = 0; i < wall.unknowns(); ++i) {
      const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(wall.unknowns(), i);
      Eigen::VectorXd up, down;
      wall.gradient(q + step, up);
      wall.gradient(q - step, down);
      const Eigen::VectorXd difference = (up - down) / (2 * h) - hessian.col(i);
      EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-6) << c.name << " " << i;
    }
  }
}

// Gradient and Hessian against central differences of value and gradient. The bounds are `slope`
// and `curvature` times the norm of what is compared, with `floor` added to the norm.
void expect_derivatives(WallEnergy& wall, const Eigen::VectorXd& q, double floor, double slope,
                        double curvature) {
  Eigen::VectorXd g, up, down;
  wall.gradient(q, g);
  const Eigen::MatrixXd hessian = full_hessian(wall, q);
  const double h = 1e-6;
  for (int i = 0; i < wall.unknowns(); ++i) {
    const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(wall.unknowns(), i);
    const double change = wall.gradient(q + step, up) - wall.gradient(q - step, down);
    EXPECT_NEAR(change / (2 * h), g[i], slope * (floor + g.norm())) << i;
    EXPECT_LT(((up - down) / (2 * h) - hessian.col(i)).norm(), curvature * (floor + hessian.norm()))
        << i;
  }
}

// A law for large strains where they are large: stretches from 0.5 to 1.6, a wall bent by half its
// thickness.
TEST(WallEnergy, LargeStrainsAgainstDifferences) {
  WallInput in = tube_wall(tube(3, 1, 7, 4), 0.3, neo_hookean, true);
  WallEnergy wall(in);
  for (const auto& [along, around] :
       {std::pair{0.5, 1.3}, std::pair{1.6, 0.7}, std::pair{0.6, 0.6}, std::pair{1.5, 1.5}}) {
    Eigen::VectorXd q = wall.rest();
    for (int i = 0; i < wall.vertices(); ++i) {
      q.segment<2>(3 * i) *= around;
      q[3 * i + 2] *= along;
    }
    q += 0.1 * noise(wall.unknowns(), 9);
    for (const WallEdge& e : wall.edges())
      if (!e.glued) q[e.unknown] += 0.3 * std::sin(3.0 * e.a + e.b);
    SCOPED_TRACE(along);
    Eigen::VectorXd g;
    EXPECT_NEAR(wall.gradient(q, g), wall.value(q), 1e-12 * wall.value(q));
    expect_derivatives(wall, q, 1, 1e-7, 1e-7);
  }
}

// All laws have one Hessian at rest: EA, EI and GJ are the same, and so is the preconditioner.
TEST(WallEnergy, LawsAgreeAtSmallStrains) {
  for (const double offset : {0.0, -0.15}) {
    WallInput in = tube_wall(tube(3, 1, 7, 4), 0.3, isotropic, true);
    in.mid_offset = offset;
    WallEnergy biot(in);
    for (const Law law : {Law::svk, Law::neo_hookean}) {
      in.material.law = law;
      WallEnergy other(in);
      const Eigen::SparseMatrix<double> k = biot.hessian(biot.rest());
      EXPECT_LT((other.hessian(other.rest()) - k).norm(), 1e-13 * k.norm()) << to_string(law);
    }
  }
}

TEST(WallEnergy, ReportNamesTheMostStrainedFaces) {
  WallInput in = tube_wall(tube(3, 1, 12, 6), 0.2, isotropic, false);
  const WallEnergy wall(in);
  EXPECT_NEAR(wall.report(wall.rest()).faces.least, 1, 1e-12);
  Eigen::VectorXd q = wall.rest();
  for (int i = 0; i < wall.vertices(); ++i) q[3 * i + 2] *= 1.3;
  const WallReport stretched = wall.report(q);
  // 12 facets around are a coarse circle
  EXPECT_NEAR(stretched.faces.largest, 1.3, 0.01);
  EXPECT_NEAR(stretched.faces.least, 1, 0.01);
  q = wall.rest();
  q.segment<2>(0) *= 0.5;  // a dent at vertex 0
  const WallReport dented = wall.report(q);
  EXPECT_LT(dented.faces.least, 0.9);
  EXPECT_LT((dented.faces.least_place - wall.rest().head<3>()).norm(), 0.8);
}

// Two triangles of a flat strip folded over their edge, beyond a right angle.
struct Folded {
  WallInput input;
  explicit Folded() {
    input.rest.points.resize(4, 3);
    input.rest.points << 0, 0, 0, 0, 1, 0, -1, 0.4, 0, 1, 0.6, 0;
    input.rest.triangles.resize(2, 3);
    input.rest.triangles << 0, 1, 2, 1, 0, 3;
    input.thickness.setConstant(4, 0.1);
    input.axis = {Vec3::UnitY(), Vec3::UnitY()};
    input.material = fibred;
  }
  Eigen::VectorXd at(const WallEnergy& wall, double angle) const {
    Eigen::VectorXd q = wall.rest();
    q.segment<3>(9) << std::cos(angle), 0.6, std::sin(angle);
    return q + 0.02 * noise(q.size(), 8);
  }
};

TEST(WallEnergy, SharpFoldsAgainstDifferences) {
  const Folded folded;
  WallEnergy wall(folded.input);
  for (const double angle : {-2.9, -2.0, -1.5, 1.5, 2.0, 2.9}) {
    const Eigen::VectorXd q = folded.at(wall, angle);
    SCOPED_TRACE(angle);
    expect_derivatives(wall, q, 0, 1e-7, 1e-6);
  }
}

// The energy is smooth through a right angle and grows without bound towards 180 degrees.
TEST(WallEnergy, AFoldNeverLiesFlat) {
  const Folded folded;
  const WallEnergy wall(folded.input);
  const auto energy = [&](double angle) {
    Eigen::VectorXd q = wall.rest();
    q.segment<3>(9) << std::cos(angle), 0.6, std::sin(angle);
    return wall.value(q);
  };
  EXPECT_GT(energy(3.1) / energy(2.9), 10);
  EXPECT_GT(energy(-3.14) / energy(-3.1), 100);
}

TEST(WallEnergy, RigidMotionCostsNothingAndTurnsTheForces) {
  for (const Case& c : cases()) {
    const WallEnergy wall(c.input);
    const Mat3 rotation = exp_rotation(Vec3(0.7, -1.9, 1.1));
    const Vec3 shift(3, -4, 5);
    const auto moved = [&](const Eigen::VectorXd& q, const Vec3& by) {
      Eigen::VectorXd m = q;
      for (int i = 0; i < wall.vertices(); ++i)
        m.segment<3>(3 * i) = rotation * q.segment<3>(3 * i) + by;
      for (const WallEdge& e : wall.edges())
        if (e.glued) m.segment<3>(e.unknown) = rotation * q.segment<3>(e.unknown);
      return m;
    };
    EXPECT_LT(wall.value(moved(wall.rest(), shift)), 1e-24) << c.name;
    const Eigen::VectorXd q = disturbed(wall, 0.08, 3);
    Eigen::VectorXd g, turned;
    const double value = wall.gradient(q, g);
    EXPECT_NEAR(wall.gradient(moved(q, shift), turned), value, 1e-12 * value) << c.name;
    EXPECT_LT((turned - moved(g, Vec3::Zero())).norm(), 1e-11 * g.norm()) << c.name;
  }
}

// Lengths and moduli in other units: the energy only changes its unit.
TEST(WallEnergy, UnitsDoNotMatter) {
  const double metre = 1e-3, pascal = 1e6;
  for (Case& c : cases()) {
    const WallEnergy wall(c.input);
    const Eigen::VectorXd q = disturbed(wall, 0.08, 4);
    WallInput in = c.input;
    in.rest.points *= metre;
    in.thickness *= metre;
    in.mid_offset *= metre;
    in.material.young_axial *= pascal;
    in.material.young_transverse *= pascal;
    in.material.shear_axial *= pascal;
    const WallEnergy scaled(in);
    Eigen::VectorXd p = q;
    p.head(3 * wall.vertices()) *= metre;
    const double value = wall.value(q);
    EXPECT_NEAR(scaled.value(p) / (pascal * metre * metre * metre), value, 1e-12 * value) << c.name;
  }
}

// Another numbering of vertices and triangles changes the directions of edges, not the wall.
TEST(WallEnergy, NumberingDoesNotMatter) {
  const WallInput in = tube_wall(tube(3, 1, 7, 4), 0.3, fibred, true);
  WallInput other = in;
  const auto n = static_cast<int>(in.rest.points.rows());
  const auto m = static_cast<int>(in.rest.triangles.rows());
  for (int i = 0; i < n; ++i) {
    other.rest.points.row(n - 1 - i) = in.rest.points.row(i);
    other.glued[static_cast<size_t>(n - 1 - i)] = in.glued[static_cast<size_t>(i)];
  }
  for (int t = 0; t < m; ++t) {
    for (int k = 0; k < 3; ++k)
      other.rest.triangles(m - 1 - t, k) = n - 1 - in.rest.triangles(t, (k + 1) % 3);
    other.axis[static_cast<size_t>(m - 1 - t)] = in.axis[static_cast<size_t>(t)];
  }
  const WallEnergy wall(in), renumbered(other);
  Eigen::VectorXd q = wall.rest(), p = renumbered.rest();
  const Eigen::VectorXd shift = 0.08 * noise(3 * n, 5);
  for (int i = 0; i < n; ++i) {
    q.segment<3>(3 * i) += shift.segment<3>(3 * i);
    p.segment<3>(3 * (n - 1 - i)) += shift.segment<3>(3 * i);
  }
  EXPECT_GT(wall.value(q), 1e-3);
  EXPECT_NEAR(wall.value(q), renumbered.value(p), 1e-13);
}

TEST(WallEnergy, ReportNamesTheSharpestFold) {
  const Folded folded;
  const WallEnergy wall(folded.input);
  for (const double angle : {0.7, 2.5}) {
    Eigen::VectorXd q = wall.rest();
    q.segment<3>(9) << std::cos(angle), 0.6, std::sin(angle);
    const WallReport r = wall.report(q);
    EXPECT_NEAR(r.sharpest_fold, angle, 1e-12);
    EXPECT_LT((r.fold_place - Vec3(0, 0.5, 0)).norm(), 1e-12);
  }
  EXPECT_NEAR(wall.report(wall.rest()).sharpest_fold, 0, 1e-7);
}

TEST(WallEnergy, ReportAddsUp) {
  for (const Material& material : {fibred, neo_hookean}) {
    const WallEnergy wall(slit_wall(material));
    const Eigen::VectorXd q = disturbed(wall, 0.05, 6);
    const WallReport r = wall.report(q);
    EXPECT_NEAR(r.membrane + r.bending + r.coupling, wall.value(q), 1e-13);
    EXPECT_GT(r.membrane, 0);
    EXPECT_GT(r.bending, 0);
    EXPECT_EQ(r.strain.size(), r.moment.size());
  }
}

TEST(WallEnergy, AnotherMaterialIsAnotherWall) {
  WallEnergy changed(tube_wall(tube(3, 1, 7, 4), 0.3, isotropic, true));
  for (const Material& material : {fibred, neo_hookean, fibred}) {
    changed.set_material(material);
    WallEnergy wall(tube_wall(tube(3, 1, 7, 4), 0.3, material, true));
    const Eigen::VectorXd q = disturbed(wall, 0.05, 7);
    EXPECT_DOUBLE_EQ(changed.value(q), wall.value(q));
    EXPECT_LT((changed.hessian(q) - wall.hessian(q)).norm(), 1e-14);
  }
}

TEST(WallEnergy, RefusesInOneSentence) {
  const WallInput good = tube_wall(tube(3, 1, 7, 4), 0.3, isotropic, true);
  const auto sentence = [](const WallInput& in) -> std::string {
    try {
      const WallEnergy wall(in);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  WallInput in = good;
  in.thickness[3] = 0;
  EXPECT_EQ(sentence(in), "wall: vertex 3: thickness = 0, expected a positive number");
  in = good;
  in.rest.triangles.row(5).reverseInPlace();
  EXPECT_NE(sentence(in).find("turned against each other"), std::string::npos);
  in = good;
  in.rest.points.row(in.rest.triangles(4, 0)) = in.rest.points.row(in.rest.triangles(4, 1));
  EXPECT_NE(sentence(in).find("expected a triangle with an area"), std::string::npos);
  in = good;
  in.material.shear_axial = -1;
  EXPECT_EQ(sentence(in), "wall: found G_axial = -1, expected a finite number above 0");
  in = good;
  in.material = fibred;
  in.material.law = Law::neo_hookean;
  EXPECT_EQ(sentence(in),
            "wall: found neo-hookean on a transversely isotropic wall, expected biot or svk, as "
            "the neo-Hookean law is isotropic");
}

}  // namespace
}  // namespace vasorod
