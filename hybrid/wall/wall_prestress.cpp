// The prestress of a wall: the first step of the modified updated Lagrangian formulation (Gee,
// Foerster and Wall, Int. J. Numer. Meth. Biomed. Engng. 26, 2010) in the additive form of Hsu and
// Bazilevs (Finite Elem. Anal. Des. 47, 2011). The stress s = K B u of a linear displacement u
// balances the load that causes u, and the wall at rest is in equilibrium under that load. On
// another mesh of the same wall, u is interpolated and s made again.
//
// Beyond small strains u leads from the shape without stress instead (Bols, Degroote, Trachet,
// Verhegghe, Segers and Vierendeels, J. Comput. Appl. Math. 246, 2013): the wall at rest is that
// shape's, deformed to the given surface, with all of its law.
#include <algorithm>
#include <cmath>
#include <limits>

#include <vasorod/error.h>

#include "wall/axial_stretch.h"
#include "wall/wall_energy.h"

namespace vasorod {

void WallEnergy::set_prestress(const WallInput& input) {
  const Points& displacement = input.prestress_displacement;
  if (displacement.rows() == 0 && input.axial_prestretch == 1) return;
  Eigen::VectorXd change = Eigen::VectorXd::Zero(rest_.size());
  for (Eigen::Index i = 0; i < displacement.rows(); ++i)
    change.segment<3>(3 * i) = displacement.row(i).transpose();
  Eigen::SparseMatrix<double> stiffness = hessian(rest_).selfadjointView<Eigen::Lower>();

  Vec6 stretch = Vec6::Zero();
  stretch.head<3>() = strain_of_stretch(input.material, input.axial_prestretch);
  for (TriangleRest& rest : triangle_rest_) rest.prestress = rest.stiffness * stretch;

  // The normals of free edges and the leans follow in equilibrium.
  Eigen::VectorXd force;
  gradient(rest_, force);
  force += stiffness * change;
  const Eigen::Index first = 3 * Eigen::Index{vertices_};
  const Eigen::Index following = free_edges_ + std::ssize(leans_);
  const Eigen::SparseMatrix<double> of_directors =
      stiffness.block(first, first, following, following);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(of_directors);
  change.segment(first, following) = -factor.solve(force.segment(first, following));

  const std::vector<Vec6> strain = strain_change(rest_, change);
  for (size_t t = 0; t < triangle_rest_.size(); ++t) {
    TriangleRest& rest = triangle_rest_[t];
    rest.prestress += rest.stiffness * strain[t];
    if (rest.relief > 0)
      rest.prestress[2] -=
          rest.relief * (strain[t][2] - strain[static_cast<size_t>(partner_[t])][2]);
  }
  set_stored();
}

void WallEnergy::set_stress_free_shape(const WallInput& input) {
  std::fill(lean_rest_.begin(), lean_rest_.end(), 0);
  for (TriangleRest& rest : triangle_rest_) rest.relief = 0;
  set_rest(input);
  relax_at_rest();
}

// The normals of free edges and the leans follow from the shape without stress in equilibrium;
// there their unknowns are zero. One stiffness serves where the law is quadratic; elsewhere it is
// made again where it must.
void WallEnergy::relax_at_rest() {
  constexpr int most_steps = 40;
  // Of the last change: none is smaller for rounding; enough where they do not become smaller.
  constexpr double tolerance = 1e-14, enough = 1e-10, slow = 0.1;
  const Eigen::Index first = 3 * Eigen::Index{vertices_};
  const Eigen::Index following = free_edges_ + std::ssize(leans_);
  bool is_kept = following_ != nullptr;
  if (!is_kept) following_ = std::make_shared<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>();
  Eigen::VectorXd force;
  constexpr double none = std::numeric_limits<double>::infinity();
  double before = none;
  for (int step = 0; step < most_steps && before > tolerance; ++step) {
    gradient(rest_, force);
    double now = none;
    for (const bool anew : {false, true}) {
      if (anew || !is_kept) {
        const Eigen::SparseMatrix<double> stiffness =
            hessian(rest_).block(first, first, following, following);
        following_->compute(stiffness);
        is_kept = following_->info() == Eigen::Success;
        if (!is_kept) continue;
      }
      const Eigen::VectorXd change = following_->solve(force.segment(first, following));
      now = change.allFinite() ? change.lpNorm<Eigen::Infinity>() : none;
      if (now == none || (!anew && now > slow * before)) continue;
      rest_.segment(first, following) -= change;
      break;
    }
    const bool is_rounding = before <= enough && now > slow * before;
    if (is_rounding) break;
    before = now;
    if (now == none) break;
  }
  if (!(before <= enough))
    throw InputError(name_ + ": found a shape without stress from which its edges cannot be " +
                     "brought to the shape as seen, expected less pressure and axial_prestretch " +
                     "when it was seen");
  for (size_t e = 0; e < edges_.size(); ++e)
    if (!edges_[e].glued) xi_rest_[e] += rest_[edges_[e].unknown];
  for (const WallLean& lean : leans_)
    lean_rest_[static_cast<size_t>(lean.vertex)] = rest_[lean.unknown];
  rest_.segment(first, following).setZero();
}

double WallEnergy::rms_prestrain() const {
  double sum = 0, area = 0;
  for (const TriangleRest& rest : triangle_rest_) {
    const Vec3 e = prestrain(rest).head<3>();  // 11, 22, 2*12
    sum += rest.area * (e.squaredNorm() - e[2] * e[2] / 2);
    area += rest.area;
  }
  return std::sqrt(sum / area);
}

void WallEnergy::set_stored() {
  for (TriangleRest& rest : triangle_rest_) rest.stored = rest.prestress.dot(prestrain(rest)) / 2;
}

}  // namespace vasorod
