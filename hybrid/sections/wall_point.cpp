#include "sections/wall_point.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "wall/membrane_strain.h"
#include "wall/plane_stress.h"

namespace vasorod {
namespace {

using Mat2 = Eigen::Matrix2d;

// Columns of a jet.
enum { U, T, UU, UT, TT };
// Those of the second form (uu, tt, ut).
constexpr std::array<int, 3> second{UU, TT, UT};

// The surface at a point: normal, dual base vectors, forms. Forms are ordered (uu, tt, ut).
struct Surface {
  Vec3 normal;
  std::array<Vec3, 2> dual;  // x^u, x^t
  Vec3 metric, bend;
  std::array<Vec3, 2> christoffel;  // of x^u and x^t, each (uu, tt, ut)
  Mat2 inverse;                     // a^AB

  explicit Surface(const SurfaceJet& x) {
    metric = {x.col(U).squaredNorm(), x.col(T).squaredNorm(), x.col(U).dot(x.col(T))};
    // theta runs counter-clockwise about the direction of u.
    const Vec3 area = x.col(T).cross(x.col(U));
    const double size = std::max(area.norm(), 1e-300);
    normal = area / size;
    // A surface collapsed to a line keeps finite forces.
    const double det = std::max(size * size, 1e-24);
    inverse << metric[1] / det, -metric[2] / det, -metric[2] / det, metric[0] / det;
    dual[0] = inverse(0, 0) * x.col(U) + inverse(0, 1) * x.col(T);
    dual[1] = inverse(1, 0) * x.col(U) + inverse(1, 1) * x.col(T);
    for (int k = 0; k < 3; ++k) {
      const Vec3 d = x.col(second[static_cast<size_t>(k)]);
      bend[k] = -normal.dot(d);
      for (size_t g = 0; g < 2; ++g) christoffel[g][k] = dual[g].dot(d);
    }
  }
};

// Derivatives of (a, b) with respect to the jet.
Eigen::Matrix<double, 6, 15> slopes_of_forms(const SurfaceJet& jet, const Surface& s) {
  Eigen::Matrix<double, 6, 15> change = Eigen::Matrix<double, 6, 15>::Zero();
  const auto put = [&](int row, int vector, const Vec3& value) {
    change.block<1, 3>(row, 3 * vector) = value.transpose();
  };
  put(0, U, 2 * jet.col(U));
  put(1, T, 2 * jet.col(T));
  put(2, U, jet.col(T));
  put(2, T, jet.col(U));
  for (int k = 0; k < 3; ++k) {
    put(3 + k, U, s.christoffel[0][k] * s.normal);
    put(3 + k, T, s.christoffel[1][k] * s.normal);
    put(3 + k, second[static_cast<size_t>(k)], -s.normal);
  }
  return change;
}

// (11, 22, 12) of J^-T a J^-1 from (uu, tt, ut) of a.
Mat3 pull_back(const Mat2& jacobian) {
  const Mat2 v = jacobian.inverse();  // columns: directions 1 and 2 in the parameters
  Mat3 pull;
  const auto row = [&](int i, int j) {
    return Eigen::RowVector3d(v(0, i) * v(0, j), v(1, i) * v(1, j),
                              v(0, i) * v(1, j) + v(1, i) * v(0, j));
  };
  pull << row(0, 0), row(1, 1), row(0, 1);
  return pull;
}

// The bending compliance of the wall's shear across its thickness, about both principal curvatures.
template <class Work>
void for_each_curvature(const Vec3& bend, Work&& work) {
  Mat2 b;
  b << bend[0], bend[2], bend[2], bend[1];
  const Eigen::SelfAdjointEigenSolver<Mat2> principal(b);
  for (int i = 0; i < 2; ++i)
    work(Vec2(principal.eigenvectors().col(i)), principal.eigenvalues()[i]);
}

}  // namespace

WallPoint::WallPoint(const SurfaceJet& jet, const Vec3& fibre, double inner, double outer,
                     double measure, const Material& material, const Vec2& stretch)
    : law_(material.law), inner_(inner), outer_(outer) {
  const Surface s(jet);
  const Vec3 first = (fibre - fibre.dot(s.normal) * s.normal).normalized(),
             across = s.normal.cross(first);
  Mat2 jacobian;
  jacobian << first.dot(jet.col(U)), first.dot(jet.col(T)), across.dot(jet.col(U)),
      across.dot(jet.col(T));
  // Stretched without bending: the curvature keeps its components in the frame.
  bend_ = pull_back(jacobian) * s.bend;
  jacobian = stretch.cwiseInverse().asDiagonal() * jacobian;
  pull_ = pull_back(jacobian);
  area_ = std::abs(jacobian.determinant()) * measure;
  WallSection section;
  section.inner = inner;
  section.outer = outer;
  section.curvature = bend_;
  section.stiffness = plane_stress(material);
  section.shear_modulus = {material.shear_axial,
                           material.young_transverse / (2 * (1 + material.poisson_tt))};
  stiffness_ = wall_section_stiffness(section);
  Mat6 map = Mat6::Identity();
  for_each_curvature(bend_, [&](const Vec2& d, double curvature) {
    const double compliance = shear_compliance(section, d, curvature);
    if (law_ == Law::neo_hookean) map = map * less_bending(stiffness_, d, compliance);
    add_bending_compliance(stiffness_, d, compliance);
  });
  if (law_ == Law::neo_hookean)
    large_ = std::make_shared<LargeStrainWall>(
        LargeStrainWall{inner, outer, bend_, material.shear_axial, material.poisson_tt, map, 1});
}

// The derivative of y by the forms (a, b); `membrane`: of e by the metric in the frame.
Mat6 WallPoint::strain_slopes(const Mat3& membrane) const {
  Mat6 map = Mat6::Zero();
  map.topLeftCorner<3, 3>() = membrane * pull_;
  map.bottomRightCorner<3, 3>() = Vec3(1, 1, 2).asDiagonal() * pull_;
  return map;
}

void WallPoint::set_prestress(const SurfaceJet& rest, const SurfaceJet& displacement,
                              const Vec3& strain) {
  const Surface s(rest);
  const MembraneStrain e = membrane_strain(law_, pull_ * s.metric);
  prestrain_ = strain_slopes(e.derivative) * slopes_of_forms(rest, s) * displacement.reshaped();
  prestrain_.head<3>() += strain;
  // Of the Hessian at rest, with which the displacement was found.
  const Mat6 stiffness =
      large_ ? large_strain_energy(*large_, Vec6::Zero(), true).tangent : stiffness_;
  prestress_ = stiffness * prestrain_;
}

Vec6 WallPoint::strains(const SurfaceJet& jet) const {
  const Surface s(jet);
  Vec6 y;
  y.head<3>() = membrane_strain(law_, pull_ * s.metric).strain;
  y.tail<3>() = Vec3(1, 1, 2).cwiseProduct(pull_ * s.bend - bend_);
  return y;
}

PointEnergy WallPoint::energy(const SurfaceJet& jet, bool with_hessian, double stress_share) const {
  const Surface s(jet);
  const Vec3 metric = pull_ * s.metric;
  const MembraneStrain e = membrane_strain(law_, metric);
  Vec6 y;
  y << e.strain, Vec3(1, 1, 2).cwiseProduct(pull_ * s.bend - bend_);
  PointEnergy result;
  Vec6 stress;
  Mat6 tangent;
  if (large_) {
    const LargeStrainEnergy all = large_strain_energy(*large_, y, with_hessian);
    Vec6 flat = y;
    flat.tail<3>().setZero();
    const double membrane = large_strain_energy(*large_, flat, false).value;
    result.membrane =
        membrane + prestress_.dot(prestrain_) / 2 + prestress_.head<3>().dot(y.head<3>());
    result.bending = all.value - membrane + prestress_.tail<3>().dot(y.tail<3>());
    stress = all.stress + prestress_;
    tangent = all.tangent;
  } else {
    // A prestress is that of strains in the state of no stress, of which these are the sum.
    const Vec6 whole = y + prestrain_;
    stress = stiffness_ * whole;
    tangent = stiffness_;
    result.membrane = whole.head<3>().dot(stiffness_.topLeftCorner<3, 3>() * whole.head<3>()) / 2;
    result.bending = whole.dot(stress) / 2 - result.membrane;
  }
  result.membrane *= area_;
  result.bending *= area_;
  // Conjugate to (a_uu, a_tt, a_ut) and to (b_uu, b_tt, b_ut).
  const Vec3 of_metric = area_ * pull_.transpose() * e.derivative.transpose() * stress.head<3>();
  const Vec3 of_bend = area_ * pull_.transpose() * Vec3(1, 1, 2).cwiseProduct(stress.tail<3>());
  const Vec3& n = s.normal;
  const double along_u = of_bend.dot(s.christoffel[0]), along_t = of_bend.dot(s.christoffel[1]);
  auto& g = result.gradient;
  g.col(U) = 2 * of_metric[0] * jet.col(U) + of_metric[2] * jet.col(T) + along_u * n;
  g.col(T) = 2 * of_metric[1] * jet.col(T) + of_metric[2] * jet.col(U) + along_t * n;
  g.col(UU) = -of_bend[0] * n;
  g.col(TT) = -of_bend[1] * n;
  g.col(UT) = -of_bend[2] * n;
  if (!with_hessian) return result;

  const Eigen::Matrix<double, 6, 15> change = slopes_of_forms(jet, s);
  const Mat6 map = strain_slopes(e.derivative);
  Mat6 by_forms = map.transpose() * tangent * map;
  if (stress_share != 0)
    by_forms.topLeftCorner<3, 3>() += stress_share * pull_.transpose() *
                                      membrane_strain_hessian(law_, metric, stress.head<3>()) *
                                      pull_;
  auto& h = result.hessian;
  h.noalias() = change.transpose() * (area_ * by_forms * change);
  if (stress_share == 0) return result;
  const auto add = [&](int row, int column, const Mat3& block) {
    h.block<3, 3>(3 * row, 3 * column) += stress_share * block;
  };
  // Second derivatives of the metric.
  add(U, U, 2 * of_metric[0] * Mat3::Identity());
  add(T, T, 2 * of_metric[1] * Mat3::Identity());
  add(U, T, of_metric[2] * Mat3::Identity());
  add(T, U, of_metric[2] * Mat3::Identity());
  // Second derivatives of the second form, with D_AB = dx_AB - Gamma^G_AB dx_G:
  //   d2 b_AB = 2 (n.dx_G) (x^G.D_AB) - b_AB a^GD (n.dx_G) (n.dx_D)
  const std::array<double, 2> along{along_u, along_t};
  const double all_bend = of_bend.dot(s.bend);
  for (int a = 0; a < 2; ++a) {
    const Mat3 out = n * s.dual[static_cast<size_t>(a)].transpose();
    for (int k = 0; k < 3; ++k) {
      const int d = second[static_cast<size_t>(k)];
      add(a, d, of_bend[k] * out);
      add(d, a, of_bend[k] * out.transpose());
    }
    for (int b = 0; b < 2; ++b)
      add(a, b,
          -along[static_cast<size_t>(b)] * out -
              along[static_cast<size_t>(a)] * s.dual[static_cast<size_t>(b)] * n.transpose() -
              all_bend * s.inverse(a, b) * n * n.transpose());
  }
  return result;
}

FaceStretches WallPoint::faces(const SurfaceJet& jet) const {
  const Vec6 y = strains(jet);
  return face_stretches(inner_, outer_, bend_, y.head<3>(), y.tail<3>());
}

}  // namespace vasorod
