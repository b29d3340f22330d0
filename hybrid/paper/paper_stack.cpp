#include "paper/paper_stack.h"

#include <algorithm>

#include "data/index.h"

namespace vasorod {
namespace {

// Width of the barrier between the faces of a wall that may touch itself, mean edges.
constexpr double guard_reach = 0.05;

}  // namespace

PaperStack::PaperStack(const BodyProblem& given, const PaperOptions& chosen, KeptFactor& bound,
                       Work& work)
    : problem(given), options(chosen), scaled(scale_bodies(given)), bound_(bound), work_(work) {
  check_seams(problem.seams, scaled);
  check_contacts(problem);
  seam_multipliers_.assign(problem.seams.size(), Vec3::Zero());
  seam_offsets_ = seam_multipliers_;
  for (ScaledBody& body : scaled.bodies) body.modelled = body.moved;
  for (const SeamPair& seam : problem.seams)
    for (const int b : {seam.body_a, seam.body_b})
      scaled.bodies[index(b)].modelled = !scaled.bodies[index(b)].obstacle;
  seam_radius = mouth_radius(problem.seams, scaled);
  guards_.resize(scaled.bodies.size());
  for (const auto& [a, b] : problem.contacts) {
    const ScaledBody& body = scaled.bodies[index(a)];
    if (a != b || body.obstacle) continue;
    guards_[index(a)] = std::make_shared<CrossingGuard>(
        body.rest, guard_reach * body.mean_edge,
        options.contact_stiffness * (body.k.bending + body.k.stretching), guarded_wall(body));
  }
  renew_contacts();
}

void PaperStack::renew_contacts() {
  contacts = std::make_unique<BodyContacts>(problem, scaled, options.contact_stiffness);
  contacts->leave_out_own();  // guarded
}

bool PaperStack::any_modelled() const {
  return std::any_of(scaled.bodies.begin(), scaled.bodies.end(),
                     [](const ScaledBody& body) { return body.modelled; });
}

void PaperStack::build() {
  system = {};
  first.assign(scaled.bodies.size(), -1);
  for (size_t b = 0; b < scaled.bodies.size(); ++b) {
    const ScaledBody& mine = scaled.bodies[b];
    if (!mine.modelled) continue;
    first[b] = system.vertex_count();
    const int block =
        append_body(system, mine.rest, mine.carried, mine.rotations, mine.k, mine.fixed);
    system.blocks[index(block)].guard = guards_[b];
  }
  system.k_j = joining_stiffness(problem.seams, scaled, options.seam_stiffness);
  system.joins = stacked_joins(problem.seams, first, seam_multipliers_);
  place_seams();
  stack_contacts();
  minimiser = std::make_unique<PaperMinimiser>(system, bound_, work_);
  positions.resize(system.vertex_count(), 3);
  for (size_t b = 0; b < scaled.bodies.size(); ++b)
    if (first[b] >= 0)
      positions.middleRows(first[b], scaled.bodies[b].now.rows()) = scaled.bodies[b].now;
}

void PaperStack::add(const std::vector<int>& touched) {
  for (const int b : touched) scaled.bodies[index(b)].modelled = true;
  build();
}

void PaperStack::stack_contacts() {
  stacked = contacts->stacked(scaled, first);
  system.contacts = stacked.points;
}

void PaperStack::unstack() {
  for (size_t b = 0; b < scaled.bodies.size(); ++b)
    if (first[b] >= 0)
      scaled.bodies[b].now = positions.middleRows(first[b], scaled.bodies[b].now.rows());
}

void PaperStack::update_seams() {
  update_join_multipliers(system.k_j, system.joins, positions);
  for (size_t i = 0; i < system.joins.size(); ++i)
    seam_multipliers_[i] = system.joins[i].multiplier;
}

PaperStack::State PaperStack::state() const {
  State state;
  for (const ScaledBody& body : scaled.bodies) state.now.push_back(body.now);
  for (const auto& guard : guards_)
    if (guard) state.guards.push_back(guard->memory());
  return state;
}

void PaperStack::restore(const State& state) {
  for (size_t b = 0; b < scaled.bodies.size(); ++b) scaled.bodies[b].now = state.now[b];
  auto memory = state.guards.begin();
  for (const auto& guard : guards_)
    if (guard) guard->remember(*memory++);
  build();
}

void PaperStack::put_at_rest() {
  for (ScaledBody& body : scaled.bodies) body.now = body.rest.points;
}

void PaperStack::carry(const std::vector<CarriedBody>& carried) {
  int block = 0;
  for (size_t b = 0; b < scaled.bodies.size(); ++b) {
    if (first[b] < 0) continue;
    ScaledBody& mine = scaled.bodies[b];
    const bool still = carried[b].points.rows() == 0;
    mine.carried =
        still ? mine.rest.points
              : Points((carried[b].points.rowwise() - scaled.origin.transpose()) / scaled.length);
    mine.placed = mine.carried;
    mine.rotations.assign(index(mine.rest.points.rows()), Mat3::Identity());
    if (!carried[b].rotations.empty()) mine.rotations = carried[b].rotations;
    carry_block(system, block++, mine.rest.points, mine.carried, mine.rotations);
    for (Eigen::Index i = 0; i < mine.now.rows(); ++i)
      if (mine.fixed[index(i)]) positions.row(first[b] + i) = mine.now.row(i) = mine.carried.row(i);
  }
}

void PaperStack::set_seam_offsets(const std::vector<Vec3>& offsets) {
  seam_offsets_ = offsets;
  for (Vec3& offset : seam_offsets_) offset /= scaled.length;
  place_seams();
}

void PaperStack::place_seams() {
  for (size_t i = 0; i < seam_offsets_.size(); ++i) system.joins[i].offset = seam_offsets_[i];
}

}  // namespace vasorod
