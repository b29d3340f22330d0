#include "paper/paper_energy.h"

#include <algorithm>

#include "data/index.h"
#include "paper/binding_energy.h"

namespace vasorod {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

Matrix lower(const Matrix& both_triangles) {
  return both_triangles.triangularView<Eigen::Lower>();
}

}  // namespace

int append_body(PaperSystem& system, const TriangleSurface& rest, const Points& carried,
                const std::vector<Mat3>& rotations, const Coefficients& k,
                const std::vector<char>& fixed) {
  const int first = system.vertex_count(), count = static_cast<int>(rest.points.rows());
  const std::vector<Edge> edges = edges_of(rest.triangles);
  PaperBlock block{first, count, k, Umbrella(edges, count), {}, nullptr};
  block.springs.reserve(edges.size());
  for (const Edge& e : edges)
    block.springs.push_back({e.a, e.b, (rest.points.row(e.b) - rest.points.row(e.a)).norm()});
  system.carried.conservativeResize(first + count, 3);
  system.carried_laplacian.conservativeResize(first + count, 3);
  system.carried_misfit.conservativeResize(first + count, 3);
  system.fixed.insert(system.fixed.end(), fixed.begin(), fixed.end());
  system.fixed.resize(static_cast<size_t>(first + count), 0);
  system.blocks.push_back(std::move(block));
  const int added = static_cast<int>(system.blocks.size()) - 1;
  carry_block(system, added, rest.points, carried, rotations);
  return added;
}

void carry_block(PaperSystem& system, int block, const Points& rest, const Points& carried,
                 const std::vector<Mat3>& rotations) {
  const PaperBlock& mine = system.blocks[index(block)];
  system.carried.middleRows(mine.first, mine.count) = carried;
  auto laplacian = system.carried_laplacian.middleRows(mine.first, mine.count);
  laplacian = carried_laplacian(mine.umbrella, rest, rotations);
  system.carried_misfit.middleRows(mine.first, mine.count) =
      laplacian - mine.umbrella.apply(carried);
}

bool PaperSystem::guarded() const {
  return std::any_of(blocks.begin(), blocks.end(),
                     [](const PaperBlock& block) { return block.guard != nullptr; });
}

double paper_energy(const PaperSystem& system, const Eigen::Ref<const Points>& p) {
  double sum = joining_energy(system.k_j, system.joins, p) + contact_energy(system.contacts, p);
  for (const PaperBlock& block : system.blocks) {
    const auto mine = p.middleRows(block.first, block.count);
    sum +=
        binding_energy(block.k.binding, mine, system.carried.middleRows(block.first, block.count)) +
        bending_energy(block.k.bending, block.umbrella, mine,
                       system.carried_laplacian.middleRows(block.first, block.count)) +
        stretching_energy(block.k.stretching, block.springs, mine);
    if (block.guard) sum += block.guard->energy(mine);
  }
  return sum;
}

PaperTerms paper_energy_gradient(const PaperSystem& system, const Eigen::Ref<const Points>& p,
                                 PaperGradient& gradient) {
  return paper_energy_gradient_at(system, p - system.carried, gradient);
}

PaperTerms paper_energy_gradient_at(const PaperSystem& system, const Eigen::Ref<const Points>& u,
                                    PaperGradient& gradient) {
  for (Points* term : {&gradient.binding, &gradient.bending, &gradient.stretching,
                       &gradient.joining, &gradient.contact})
    term->setZero(u.rows(), 3);
  PaperTerms terms;
  for (const PaperBlock& block : system.blocks) {
    const auto mine = u.middleRows(block.first, block.count);
    terms.binding += binding_energy_gradient(block.k.binding, mine, Points::Zero(block.count, 3),
                                             gradient.binding.middleRows(block.first, block.count));
    terms.bending +=
        bending_energy_gradient(block.k.bending, block.umbrella, mine,
                                system.carried_misfit.middleRows(block.first, block.count),
                                gradient.bending.middleRows(block.first, block.count));
    terms.stretching += stretching_energy_gradient(
        block.k.stretching, block.springs, system.carried.middleRows(block.first, block.count),
        mine, gradient.stretching.middleRows(block.first, block.count));
  }
  if (system.joins.empty() && system.contacts.empty() && !system.guarded()) return terms;
  const Points p = system.carried + u;
  terms.joining = joining_energy_gradient(system.k_j, system.joins, p, gradient.joining);
  terms.contact = contact_energy_gradient(system.contacts, p, gradient.contact);
  for (const PaperBlock& block : system.blocks)
    if (block.guard)
      terms.contact += block.guard->gradient(p.middleRows(block.first, block.count),
                                             gradient.contact.middleRows(block.first, block.count));
  return terms;
}

Matrix paper_energy_constant(const PaperSystem& system, double spring_share) {
  std::vector<Matrix> blocks;
  Eigen::Index entries = 0;
  for (const PaperBlock& block : system.blocks) {
    const Matrix bending = bending_energy_hessian(block.k.bending, block.umbrella);
    const Matrix binding = binding_energy_hessian(block.k.binding, block.count);
    const Matrix springs =
        stretching_energy_bound(spring_share * block.k.stretching, block.springs, block.count);
    blocks.emplace_back(bending + springs + binding);
    entries += (blocks.back().nonZeros() + block.count) / 2;
  }
  Matrix stacked(system.vertex_count(), system.vertex_count());
  stacked.reserve(entries);
  for (size_t b = 0; b < blocks.size(); ++b) {
    const int first = system.blocks[b].first;
    for (int column = 0; column < blocks[b].outerSize(); ++column) {
      stacked.startVec(first + column);
      for (Matrix::InnerIterator it(blocks[b], column); it; ++it)
        if (it.row() >= column) stacked.insertBack(first + it.row(), first + column) = it.value();
    }
  }
  stacked.finalize();
  if (!system.joins.empty())
    stacked += lower(joining_energy_hessian(system.k_j, system.joins, system.vertex_count()));
  return stacked;
}

Matrix paper_energy_bound(const PaperSystem& system, const Eigen::Ref<const Points>& p) {
  return paper_energy_bound(system, paper_energy_constant(system), p);
}

Matrix paper_energy_bound(const PaperSystem& system, const Matrix& constant,
                          const Eigen::Ref<const Points>& p) {
  Matrix bound = constant;
  if (!system.contacts.empty()) bound += lower(contact_energy_bound(system.contacts, p));
  std::vector<Eigen::Triplet<double>> guarded;
  for (const PaperBlock& block : system.blocks)
    if (block.guard)
      block.guard->bound(p.middleRows(block.first, block.count), block.first, guarded);
  std::erase_if(guarded, [](const auto& entry) { return entry.row() < entry.col(); });
  if (!guarded.empty()) {
    Matrix barriers(bound.rows(), bound.cols());
    barriers.setFromTriplets(guarded.begin(), guarded.end());
    bound += barriers;
  }
  const auto is_fixed = [&](Eigen::Index i) { return system.fixed[static_cast<size_t>(i)] != 0; };
  bound.prune([&](Eigen::Index row, Eigen::Index column, double) {
    return row == column || !(is_fixed(row) || is_fixed(column));
  });
  return bound;
}

Matrix paper_energy_hessian(const PaperSystem& system, const Eigen::Ref<const Points>& p,
                            double blend) {
  const Matrix constant = paper_energy_constant(system, 0);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<size_t>(3 * constant.nonZeros() + 60 * system.vertex_count()));
  const auto is_fixed = [&](int i) { return system.fixed[static_cast<size_t>(i)] != 0; };
  for (int column = 0; column < constant.outerSize(); ++column)
    for (Matrix::InnerIterator it(constant, column); it; ++it) {
      const int row = static_cast<int>(it.row());
      if (row != column && (is_fixed(row) || is_fixed(column))) continue;
      for (int c = 0; c < 3; ++c) entries.emplace_back(3 * row + c, 3 * column + c, it.value());
    }
  // Adds the 3 x 3 block of two vertices, or its lower triangle if they are the same vertex.
  const auto add = [&](int row, int column, const Mat3& block) {
    if (row < column || is_fixed(row) || is_fixed(column)) return;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c)
        if (row != column || r >= c) entries.emplace_back(3 * row + r, 3 * column + c, block(r, c));
  };
  for (const PaperBlock& block : system.blocks)
    for (const Spring& s : block.springs) {
      const int a = block.first + s.a, b = block.first + s.b;
      const Mat3 h = spring_hessian(block.k.stretching, (p.row(b) - p.row(a)).transpose(),
                                    s.rest_length, blend);
      add(a, a, h);
      add(b, b, h);
      add(a, b, -h);
      add(b, a, -h);
    }
  std::vector<Eigen::Triplet<double>> pressed;
  contact_energy_hessian(system.contacts, p, pressed);
  for (const PaperBlock& block : system.blocks)
    if (block.guard)
      block.guard->hessian(p.middleRows(block.first, block.count), blend, block.first, pressed);
  for (const auto& t : pressed) {
    if (t.row() >= t.col() && !is_fixed(t.row() / 3) && !is_fixed(t.col() / 3))
      entries.push_back(t);
  }
  Matrix hessian(3 * system.vertex_count(), 3 * system.vertex_count());
  hessian.setFromTriplets(entries.begin(), entries.end());
  return hessian;
}

}  // namespace vasorod
