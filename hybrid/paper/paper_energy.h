// The paper's surface energy [6-9] of several bodies: binding, bending and stretching of each body,
// and the joining springs and contacts between bodies. Vertices are stacked body by body; vertices
// marked `fixed` do not move.
#pragma once

#include <memory>
#include <vector>

#include "bodies/contact_energy.h"
#include "bodies/crossing_guard.h"
#include "bodies/joining_energy.h"
#include "bodies/spring_coefficients.h"
#include "paper/bending_energy.h"
#include "paper/stretching_energy.h"

namespace vasorod {

/// One body in the stack: vertices first to first + count - 1.
struct PaperBlock {
  int first = 0, count = 0;
  Coefficients k;
  Umbrella umbrella;
  std::vector<Spring> springs;  ///< vertex numbers within the body
  /// Null: it may pass through itself.
  std::shared_ptr<CrossingGuard> guard;
};

/// All data of the energy except the positions.
struct PaperSystem {
  std::vector<PaperBlock> blocks;
  Points carried;            ///< p' [6]
  Points carried_laplacian;  ///< R l(p0) of [8]
  Points carried_misfit;     ///< R l(p0) - l(p'), with which [8] is |l(u) - carried_misfit|^2
  std::vector<char> fixed;   ///< per vertex
  double k_j = 0;            ///< joining springs
  std::vector<Join> joins;
  std::vector<ContactPoint> contacts;
  int vertex_count() const { return static_cast<int>(carried.rows()); }
  bool guarded() const;  ///< whether a body must not pass through itself
};

/// Appends a body to the stack and returns the index of its block.
int append_body(PaperSystem& system, const TriangleSurface& rest, const Points& carried,
                const std::vector<Mat3>& rotations, const Coefficients& k,
                const std::vector<char>& fixed);
/// Moves p' and the rotations R of a block's body.
void carry_block(PaperSystem& system, int block, const Points& rest, const Points& carried,
                 const std::vector<Mat3>& rotations);

/// Energy term by term, force * length.
struct PaperTerms {
  /// `contact` has the guards' barriers too.
  double binding = 0, bending = 0, stretching = 0, joining = 0, contact = 0;
  double total() const { return binding + bending + stretching + joining + contact; }
};

/// Gradient of the energy, term by term, each n x 3. Kept between evaluations to avoid allocations.
struct PaperGradient {
  Points binding, bending, stretching, joining, contact;
  Points sum() const { return binding + bending + stretching + joining + contact; }
};

/// Total energy at p (V x 3), force * length.
double paper_energy(const PaperSystem& system, const Eigen::Ref<const Points>& p);

/// Energies and their gradients. The gradient at a fixed vertex is the force required from its
/// support.
PaperTerms paper_energy_gradient(const PaperSystem& system, const Eigen::Ref<const Points>& p,
                                 PaperGradient& gradient);

/// The same at the displacements u = p - p'. On a fine mesh forces are differences of coordinates
/// that agree in most of their digits: at p the gradient keeps an error of the last digit of p
/// times the stiffness, which grows as the number of vertices over the forces; at u it is that of
/// u.
PaperTerms paper_energy_gradient_at(const PaperSystem& system, const Eigen::Ref<const Points>& u,
                                    PaperGradient& gradient);

/// The part of paper_energy_bound() that does not depend on p and the contacts: the terms whose
/// Hessian is constant, and the springs' bound; lower triangle. With `spring_share` below 1 only
/// this fraction of the latter is added, and the matrix is no longer a bound.
Eigen::SparseMatrix<double> paper_energy_constant(const PaperSystem& system,
                                                  double spring_share = 1);

/// An upper bound of the Hessian as a V x V matrix, the same for x, y and z, including the contacts
/// that carry pressure at p; lower triangle. Fixed vertices keep only their diagonal. The pattern
/// changes only with the contacts.
Eigen::SparseMatrix<double> paper_energy_bound(const PaperSystem& system,
                                               const Eigen::Ref<const Points>& p);
/// The same with its part paper_energy_constant() given.
Eigen::SparseMatrix<double> paper_energy_bound(const PaperSystem& system,
                                               const Eigen::SparseMatrix<double>& constant,
                                               const Eigen::Ref<const Points>& p);

/// The Hessian at p, 3V x 3V, lower triangle; fixed unknowns keep only a positive diagonal.
/// blend = 1 replaces the Hessian of the springs by its positive bound, that of the guards by its
/// convex part; values between 0 and 1 interpolate.
Eigen::SparseMatrix<double> paper_energy_hessian(const PaperSystem& system,
                                                 const Eigen::Ref<const Points>& p,
                                                 double blend = 0);

}  // namespace vasorod
