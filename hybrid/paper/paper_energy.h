// The paper's surface energy of several bodies at once [6-9]: binding, bending and stretching of
// each, with the joining springs and the contacts between them. Vertices are stacked body by body;
// `fixed` ones stay where they are.
#pragma once

#include <vector>

#include "bodies/contact_energy.h"
#include "bodies/joining_energy.h"
#include "bodies/spring_coefficients.h"
#include "paper/bending_energy.h"
#include "paper/stretching_energy.h"

namespace vasorod {

/// One body's share of the stack: vertices first to first + count - 1.
struct PaperBlock {
  int first = 0, count = 0;
  Coefficients k;
  Umbrella umbrella;
  std::vector<Spring> springs;  ///< vertex numbers within the body
};

/// Everything the energy depends on besides the positions.
struct PaperSystem {
  std::vector<PaperBlock> blocks;
  Points carried;            ///< p' [6]
  Points carried_laplacian;  ///< R l(p0) of [8]
  std::vector<char> fixed;   ///< per vertex
  double k_j = 0;            ///< joining springs
  std::vector<Join> joins;
  std::vector<ContactPoint> contacts;
  int vertex_count() const { return static_cast<int>(carried.rows()); }
};

/// Appends a body to the stack; returns its block's index.
int append_body(PaperSystem& system, const TriangleSurface& rest, const Points& carried,
                const std::vector<Mat3>& rotations, const Coefficients& k,
                const std::vector<char>& fixed);

struct PaperTerms {
  double binding = 0, bending = 0, stretching = 0, joining = 0, contact = 0;
  double total() const { return binding + bending + stretching + joining + contact; }
};

/// The energy's gradient term by term; kept between evaluations to save the allocations.
struct PaperGradient {
  Points binding, bending, stretching, joining, contact;
  Points sum() const { return binding + bending + stretching + joining + contact; }
};

double paper_energy(const PaperSystem& system, const Eigen::Ref<const Points>& p);

/// The energies and their gradients; those at fixed vertices are the forces their supports must
/// give.
PaperTerms paper_energy_gradient(const PaperSystem& system, const Eigen::Ref<const Points>& p,
                                 PaperGradient& gradient);

/// A V x V matrix, the same for x, y and z, that bounds the Hessian from above, with the contacts
/// that press at p. Both triangles. Fixed vertices keep their diagonal only. Its pattern changes
/// with the contacts alone. With `spring_share` below 1 only that share of the springs' bound
/// enters, and it bounds no longer.
Eigen::SparseMatrix<double> paper_energy_bound(const PaperSystem& system,
                                               const Eigen::Ref<const Points>& p,
                                               double spring_share = 1);

/// The Hessian at p, 3V x 3V, lower triangle; fixed unknowns keep a positive diagonal only. blend =
/// 1 replaces the springs' Hessian by its positive bound, blend between 0 and 1 mixes both.
Eigen::SparseMatrix<double> paper_energy_hessian(const PaperSystem& system,
                                                 const Eigen::Ref<const Points>& p,
                                                 double blend = 0);

}  // namespace vasorod
