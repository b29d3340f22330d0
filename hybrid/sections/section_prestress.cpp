#include "sections/section_prestress.h"

#include <vasorod/error.h>

#include "numerics/stress_free_search.h"

namespace vasorod {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

HeldEnds held_at_rest(HeldEnds ends) {
  for (auto& end : ends) {
    if (!end) continue;
    end->fixed.fill(true);
    end->motion = {};
    end->force = end->moment = end->body_moment = Vec3::Zero();
  }
  return ends;
}

// A wall held as it was seen under the pressure of its scan.
class SeenWall final : public StressFreeProblem {
 public:
  SeenWall(const SectionWall& wall, const HeldEnds& ends, double scan_pressure,
           double axial_prestretch)
      : stretch_(axial_prestretch), system_(wall, held_at_rest(ends)) {
    system_.set_lumen({0, scan_pressure});
    std::array<Pose, 2> poses;
    for (size_t e = 0; e < 2; ++e)
      if (ends[e]) poses[e].position = ends[e]->rest.position;
    rest_ = system_.unknowns_of(wall.rest.coefficients, poses);
  }

  // The strain of its prestress where that is linear in the change.
  double rms_prestrain(const VectorXd& change) {
    system_.set_prestress(displacement(change), stretch_);
    return system_.energy().rms_prestrain();
  }

  // Of the stress of the axial prestretch alone.
  void set_stretch() {
    system_.set_prestress(MatrixXd::Zero(system_.space().row_size(), system_.space().along.count()),
                          stretch_);
    system_.set_time(1);
  }

  bool set(double share, const VectorXd& change) override {
    system_.set_stress_free_shape(displacement(change), 1 + share * (stretch_ - 1));
    system_.set_time(share);
    return true;
  }

  bool stiffen() {
    system_.set_time(0);
    stiffness_.emplace(system_.hessian(rest_, system_.gradient(rest_)));
    return stiffness_->factorise();
  }

  VectorXd step(const VectorXd&) override {
    VectorXd change = -system_.gradient(rest_).gradient;
    stiffness_->solve(change);
    return change;
  }

  double length(const VectorXd& change) const override { return displacement(change).norm(); }

  MatrixXd displacement(const VectorXd& change) const {
    return system_.coefficients(rest_ + change) - system_.coefficients(rest_);
  }

  VectorXd none() const { return VectorXd::Zero(rest_.size()); }

 private:
  double stretch_;
  SectionSystem system_;
  VectorXd rest_;
  std::optional<BandMatrix> stiffness_;
};

}  // namespace

SeenSections seen_sections(const SectionWall& wall, const HeldEnds& ends, double scan_pressure,
                           double axial_prestretch, const std::string& name, double largest_linear,
                           const std::function<bool()>& stop) {
  SeenWall seen(wall, ends, scan_pressure, axial_prestretch);
  if (!seen.stiffen())
    throw InputError(name +
                     ": nothing holds it against the pressure of its scan, expected a held end");
  seen.set_stretch();
  VectorXd change = seen.step(seen.none());
  SeenSections found;
  if (seen.rms_prestrain(change) > largest_linear)
    found.steps = search_stress_free(seen, change, stop);
  found.displacement = seen.displacement(change);
  return found;
}

void give_prestress(const SeenSections& seen, double axial_prestretch, SectionSystem& system) {
  if (seen.steps > 0)
    system.set_stress_free_shape(seen.displacement, axial_prestretch);
  else
    system.set_prestress(seen.displacement, axial_prestretch);
}

}  // namespace vasorod
