#include "paper/joined_skin.h"

#include <numeric>

#include <vasorod/error.h>

#include "geometry/triangle_surface.h"
#include "geometry/umbrella.h"
#include "numerics/cholesky.h"
#include "paper/bending_energy.h"

namespace vasorod {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

// Numbering of the vertices of all joined bodies; the two vertices of a seam pair share a
// representative.
struct Numbering {
  std::vector<int> offset;  // per body; -1: not joined
  std::vector<int> representative;

  explicit Numbering(const BodyProblem& problem) : offset(problem.bodies.size(), -1) {
    for (const SeamPair& pair : problem.seams)
      for (const int body : {pair.body_a, pair.body_b}) offset[static_cast<size_t>(body)] = 0;
    int count = 0;
    for (size_t b = 0; b < offset.size(); ++b)
      if (offset[b] == 0) {
        offset[b] = count;
        count += static_cast<int>(problem.bodies[b].rest.points.rows());
      }
    representative.resize(static_cast<size_t>(count));
    std::iota(representative.begin(), representative.end(), 0);
    for (const SeamPair& pair : problem.seams) {
      const int a = find(offset[static_cast<size_t>(pair.body_a)] + pair.vertex_a);
      const int b = find(offset[static_cast<size_t>(pair.body_b)] + pair.vertex_b);
      representative[static_cast<size_t>(std::max(a, b))] = std::min(a, b);
    }
  }
  int find(int i) const {
    while (representative[static_cast<size_t>(i)] != i) i = representative[static_cast<size_t>(i)];
    return i;
  }
};

}  // namespace

std::vector<Points> joined_skin(const BodyProblem& problem, Work* work) {
  std::vector<Points> positions;
  for (const SurfaceBody& body : problem.bodies)
    positions.push_back(body.carried.rows() > 0 ? body.carried : body.rest.points);
  if (problem.seams.empty()) return positions;

  const Numbering numbering(problem);
  const auto count = static_cast<Eigen::Index>(numbering.representative.size());
  std::vector<char> fixed(static_cast<size_t>(count), 0);
  Points known = Points::Zero(count, 3);
  for (size_t b = 0; b < problem.bodies.size(); ++b) {
    const std::vector<char>& held = problem.bodies[b].fixed;
    for (int i = 0; numbering.offset[b] >= 0 && i < static_cast<int>(held.size()); ++i)
      if (held[static_cast<size_t>(i)]) {
        const int r = numbering.find(numbering.offset[b] + i);
        fixed[static_cast<size_t>(r)] = 1;
        known.row(r) = positions[b].row(i);
      }
  }
  // Unknowns are the free representatives, numbered in order; -1: fixed.
  std::vector<int> unknown(static_cast<size_t>(count), -1);
  int free_count = 0;
  for (int i = 0; i < count; ++i)
    if (numbering.find(i) == i && !fixed[static_cast<size_t>(i)])
      unknown[static_cast<size_t>(i)] = free_count++;

  Triplets entries;                                              // lower triangle
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(free_count, 3);  // half the constant part
  for (size_t b = 0; b < problem.bodies.size(); ++b) {
    const int offset = numbering.offset[b];
    if (offset < 0) continue;
    const SurfaceBody& body = problem.bodies[b];
    const auto n = static_cast<int>(body.rest.points.rows());
    if (!(body.k.binding > 0 && body.k.bending > 0))
      throw InputError("vessel " + body.name +
                       ": coefficients: found a binding or bending that is not positive, expected "
                       "both positive to close a seam");
    std::vector<int> representative(static_cast<size_t>(n));
    for (int i = 0; i < n; ++i) representative[static_cast<size_t>(i)] = numbering.find(offset + i);
    const auto row_of = [&](Eigen::Index i) {
      return unknown[static_cast<size_t>(representative[static_cast<size_t>(i)])];
    };
    const Umbrella umbrella(edges_of(body.rest.triangles), n);
    const std::vector<Mat3> rotations =
        body.rotations.empty() ? std::vector<Mat3>(static_cast<size_t>(n), Mat3::Identity())
                               : body.rotations;
    const Points carried_l = carried_laplacian(umbrella, body.rest.points, rotations);
    Points force = body.k.binding * positions[b];
    umbrella.add_transpose(carried_l, body.k.bending, force);
    const Sparse hessian = 0.5 * bending_energy_hessian(body.k.bending, umbrella);
    entries.reserve(entries.size() + static_cast<size_t>(hessian.nonZeros()));
    for (int column = 0; column < n; ++column) {
      const int from = row_of(column);
      for (Sparse::InnerIterator it(hessian, column); it; ++it) {
        const int to = row_of(it.row());
        if (from >= 0 && to >= from)
          entries.emplace_back(to, from, it.value());
        else if (from < 0 && to >= 0)
          right.row(to) -= it.value() * known.row(representative[static_cast<size_t>(column)]);
      }
      if (from < 0) continue;
      entries.emplace_back(from, from, body.k.binding);
      right.row(from) += force.row(column);
    }
  }
  Sparse reduced(free_count, free_count);
  reduced.setFromTriplets(entries.begin(), entries.end());

  if (work) ++work->counts.hessians;
  Cholesky cholesky(work);
  cholesky.analyse(reduced);
  if (!cholesky.factorise(reduced))
    throw InputError("the seam cannot be closed: its energies are not positive definite");
  Eigen::MatrixXd y(free_count, 3);
  cholesky.solve(right.data(), y.data(), 3);
  for (size_t b = 0; b < problem.bodies.size(); ++b) {
    if (numbering.offset[b] < 0) continue;
    for (Eigen::Index i = 0; i < positions[b].rows(); ++i) {
      const int r = numbering.find(numbering.offset[b] + static_cast<int>(i));
      const int row = unknown[static_cast<size_t>(r)];
      if (row >= 0)
        positions[b].row(i) = y.row(row);
      else
        positions[b].row(i) = known.row(r);
    }
  }
  return positions;
}

}  // namespace vasorod
