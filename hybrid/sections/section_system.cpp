#include "sections/section_system.h"

#include <algorithm>
#include <cmath>

#include "data/index.h"

namespace vasorod {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

}  // namespace

SectionSystem::SectionSystem(const SectionWall& wall, const HeldEnds& ends)
    : energy_(wall), band_(energy_.empty_hessian()) {
  for (int e = 0; e < 2; ++e)
    if (ends[index(e)]) ends_[index(e)].emplace(*ends[index(e)], wall.rest, e == 1);
}

int SectionSystem::end_unknowns(int end) const {
  return ends_[index(end)] ? ends_[index(end)]->unknowns() : 0;
}

int SectionSystem::end_of_free() const {
  return space().along.count() - (ends_[1] ? static_cast<int>(ends_[1]->rows().size()) : 0);
}

int SectionSystem::place_of_row(int row) const {
  return end_unknowns(0) + (row - first_free()) * space().row_size();
}

int SectionSystem::unknowns() const {
  return place_of_row(end_of_free()) + end_unknowns(1);
}

VectorXd SectionSystem::part(int end, const VectorXd& z) const {
  return end == 0 ? z.head(end_unknowns(0)) : z.tail(end_unknowns(1));
}

void SectionSystem::set_time(double t) {
  for (auto& end : ends_)
    if (end) end->pose.set_time(t);
  energy_.set_pressure(lumen_.scan + t * (lumen_.after - lumen_.scan));
}

void SectionSystem::set_prestress(const MatrixXd& displacement, double axial_prestretch) {
  energy_.set_prestress(displacement, axial_prestretch);
}

void SectionSystem::set_stress_free_shape(const MatrixXd& displacement, double axial_prestretch) {
  energy_.set_stress_free_shape(displacement, axial_prestretch);
}

VectorXd SectionSystem::unknowns_of(const MatrixXd& coefficients,
                                    const std::array<Pose, 2>& poses) {
  VectorXd z(unknowns());
  const int free = end_of_free() - first_free();
  z.segment(end_unknowns(0), free * space().row_size()) =
      coefficients.middleCols(first_free(), free).reshaped();
  for (int e = 0; e < 2; ++e) {
    if (!ends_[index(e)]) continue;
    const Pose& pose = poses[index(e)];
    const VectorXd mine = ends_[index(e)]->unknowns_of(pose.rotation, pose.position, coefficients);
    (e == 0 ? z.head(mine.size()) : z.tail(mine.size())) = mine;
  }
  return z;
}

MatrixXd SectionSystem::coefficients(const VectorXd& z) const {
  MatrixXd all(space().row_size(), space().along.count());
  const int free = end_of_free() - first_free();
  all.middleCols(first_free(), free) =
      z.segment(end_unknowns(0), free * space().row_size()).reshaped(space().row_size(), free);
  for (int e = 0; e < 2; ++e)
    if (ends_[index(e)]) ends_[index(e)]->place(part(e, z), all);
  return all;
}

double SectionSystem::recentre(VectorXd& z) {
  double change = 0;
  for (int e = 0; e < 2; ++e) {
    if (!ends_[index(e)]) continue;
    VectorXd mine = part(e, z);
    change = std::max(change, ends_[index(e)]->pose.recentre(mine.data()));
    (e == 0 ? z.head(mine.size()) : z.tail(mine.size())) = mine;
  }
  return change;
}

bool SectionSystem::has_potential() const {
  return std::all_of(ends_.begin(), ends_.end(),
                     [](const auto& end) { return !end || end->pose.has_potential(); });
}

double SectionSystem::value(const VectorXd& z) const {
  return gradient(z).value;
}

SectionSystem::Gradient SectionSystem::gradient(const VectorXd& z) const {
  Gradient result;
  result.value = energy_.gradient(coefficients(z), result.rows, result.size);
  result.gradient.resize(unknowns());
  const int free = end_of_free() - first_free(), size = space().row_size();
  result.gradient.segment(end_unknowns(0), free * size) =
      result.rows.middleCols(first_free(), free).reshaped();
  for (int e = 0; e < 2; ++e) {
    if (!ends_[index(e)]) continue;
    const HeldRows& end = *ends_[index(e)];
    const VectorXd mine = part(e, z);
    VectorXd of_rows(std::ssize(end.rows()) * size);
    for (size_t a = 0; a < end.rows().size(); ++a)
      of_rows.segment(static_cast<int>(a) * size, size) = result.rows.col(end.rows()[a]);
    VectorXd g = end.derivative(mine).transpose() * of_rows;
    if (end.pose.unknowns() > 0) {
      Vec6 load = Vec6::Zero();
      result.value += end.pose.load(end.pose.place(mine.data()), mine.data(), load);
      g.head(end.pose.unknowns()) += load.head(end.pose.unknowns());
      result.size = std::hypot(result.size, load.norm());
    }
    (e == 0 ? result.gradient.head(g.size()) : result.gradient.tail(g.size())) = g;
  }
  return result;
}

BandMatrix SectionSystem::hessian(const VectorXd& z, const Gradient& at, double stress_share) {
  energy_.hessian(coefficients(z), band_, stress_share);
  const int size = space().row_size(), reach = band_.width(), begin = first_free(),
            end = end_of_free();
  const int at_end = end_unknowns(1), n = unknowns();
  // The farthest free row that the end's rows meet.
  const int beside_start = std::min(end, begin + reach), beside_end = std::max(begin, end - reach);
  const bool ends_meet = ends_[0] && ends_[1] && end - 1 - (begin - 1) <= reach;
  int width = std::min(size * (reach + 1), n) - 1;
  if (ends_[0]) width = std::max(width, place_of_row(beside_start) - 1);
  if (ends_[1]) width = std::max(width, n - 1 - place_of_row(beside_end));
  if (ends_meet) width = n - 1;
  BandMatrix matrix(n, std::max(width, 0));
  for (int i = begin; i < end; ++i)
    for (int j = i; j < std::min(end, i + reach + 1); ++j)
      matrix.add(place_of_row(j), place_of_row(i), band_.upper(i, j).transpose());
  std::array<MatrixXd, 2> derivative;
  for (int e = 0; e < 2; ++e)
    if (ends_[index(e)]) derivative[index(e)] = ends_[index(e)]->derivative(part(e, z));
  const auto rows_of = [&](int e) { return ends_[index(e)]->rows(); };
  // The Hessian's rows of an end's rows against other rows.
  const auto between = [&](int e, const std::vector<int>& others) {
    MatrixXd block(std::ssize(rows_of(e)) * size, std::ssize(others) * size);
    for (size_t a = 0; a < rows_of(e).size(); ++a)
      for (size_t b = 0; b < others.size(); ++b)
        block.block(static_cast<int>(a) * size, static_cast<int>(b) * size, size, size) =
            band_.block(rows_of(e)[a], others[b]);
    return block;
  };
  for (int e = 0; e < 2; ++e) {
    if (!ends_[index(e)]) continue;
    const MatrixXd& mine = derivative[index(e)];
    const MatrixXd own = mine.transpose() * between(e, rows_of(e)) * mine +
                         stress_share * ends_[index(e)]->curvature(part(e, z), at.rows);
    const int place = e == 0 ? 0 : n - at_end;
    matrix.add(place, place, own);
    const int from = e == 0 ? begin : beside_end, to = e == 0 ? beside_start : end;
    for (int row = from; row < to; ++row) {
      const MatrixXd block = mine.transpose() * between(e, {row});
      if (e == 0)
        matrix.add(place_of_row(row), 0, block.transpose());
      else
        matrix.add(place, place_of_row(row), block);
    }
  }
  if (ends_meet)
    matrix.add(n - at_end, 0, derivative[1].transpose() * between(1, rows_of(0)) * derivative[0]);
  return matrix;
}

std::optional<SectionSolution> SectionSystem::wrench(int end, const VectorXd& z,
                                                     const Gradient& at) const {
  if (!ends_[index(end)]) return std::nullopt;
  const HeldRows& held = *ends_[index(end)];
  const VectorXd mine = part(end, z);
  const SectionPlacement placed = held.pose.place(mine.data());
  SectionSolution wrench;
  wrench.label = held.pose.section().label;
  held.wrench(mine, at.rows, wrench.force, wrench.moment);
  wrench.center = placed.position;
  wrench.rotation = placed.rotation;
  wrench.load = held.pose.time() * held.pose.section().force;
  Vec3 force, moment;
  carried_lid(end, z, wrench.center, force, moment);
  wrench.force += force;
  wrench.moment += moment;
  return wrench;
}

void SectionSystem::carried_lid(int end, const VectorXd& z, const Vec3& center, Vec3& force,
                                Vec3& moment) const {
  force = moment = Vec3::Zero();
  if (!ends_[index(end)] || energy_.pressure() == 0) return;
  const auto& fixed = ends_[index(end)]->pose.section().fixed;
  if (!fixed[0] && !fixed[1] && !fixed[2]) return;
  const int row = end == 0 ? 0 : space().along.count() - 1;
  SectionLid(space().harmonics, end == 1)
      .wrench(coefficients(z).col(row), energy_.depth(end), center, force, moment);
  force *= energy_.pressure();
  moment *= energy_.pressure();
}

Vec3 SectionSystem::carried_lid(int end, const VectorXd& z) const {
  Vec3 force, moment;
  carried_lid(end, z, Vec3::Zero(), force, moment);
  return force;
}

}  // namespace vasorod
