#include "coupled/scan_displacement.h"

#include <cmath>
#include <optional>
#include <utility>

#include <vasorod/error.h>

#include "coupled/coupled_system.h"
#include "coupled/wall_lumen.h"
#include "geometry/triangle_surface.h"
#include "numerics/cholesky.h"
#include "numerics/stress_free_search.h"
#include "wall/shear_band.h"

namespace vasorod {
namespace {

using Eigen::VectorXd;

// Of a soft section, over E t: so stiff that its ring as a whole does not move, of what its wall
// is.
constexpr double tie_stiffness = 1e6;

// A wall in units of its mean edge and modulus, held as it was seen under the pressure of its scan.
class SeenWall final : public StressFreeProblem {
 public:
  SeenWall(const WallInput& given, std::vector<HeldSection> sections, double scan_pressure)
      : length_(mean_edge_length(given.rest)), sections_(std::move(sections)) {
    const double stress = given.material.young_axial;
    const Vec3 origin = given.rest.points.colwise().mean().transpose();
    TriangleSurface rest = given.rest;
    rest.points = (rest.points.rowwise() - origin.transpose()) / length_;
    wall_ = scaled(given, std::move(rest), length_, stress);
    wall_.prestress_displacement.resize(0, 3);
    wall_.from_stress_free_shape = false;
    for (HeldSection& section : sections_) {
      section = scaled(section, length_, stress * length_ * length_, origin);
      section.fixed.fill(true);
      section.motion = {};
      section.force = section.moment = section.body_moment = Vec3::Zero();
    }
    wall_.glued = glued_marks(sections_, wall_.rest.points.rows());
    wall_.lean = shear_band(wall_);
    WallInput free_of_stress = wall_;
    free_of_stress.axial_prestretch = 1;
    energy_.emplace(free_of_stress);
    system_.add_wall(*energy_, wall_.rest.points, sections_,
                     tie_stiffness * wall_.thickness.mean());
    system_.set_lumen(0, wall_lumen(wall_, sections_, {}, {0, scan_pressure / stress}));
    system_.finish();
    system_.put(0, wall_.rest.points, false, z_);
    for (size_t s = 0; s < sections_.size(); ++s)
      system_.put_pose(0, static_cast<int>(s), Mat3::Identity(), sections_[s].rest.position, z_);
  }

  // The length of a unit.
  double unit() const { return length_; }
  VectorXd no_displacement() const { return VectorXd::Zero(z_.size()); }

  bool stiffen() {
    system_.set_time(0);
    const Eigen::SparseMatrix<double> stiffness = system_.hessian(z_);
    factor_.analyse(stiffness);
    return factor_.factorise(stiffness);
  }

  bool set(double share, const VectorXd& u) override {
    WallInput stressed = wall_;
    stressed.from_stress_free_shape = true;
    stressed.axial_prestretch = 1 + share * (wall_.axial_prestretch - 1);
    stressed.prestress_displacement = points_of(u);
    try {
      if (is_shaped_)
        energy_->set_stress_free_shape(stressed);
      else
        become(stressed);
    } catch (const InputError&) {  // a triangle has no area there, or edges no equilibrium
      become(wall_);
      return false;
    }
    is_shaped_ = true;
    system_.set_time(share);
    return true;
  }

  // The wall with the stress of the axial prestretch alone.
  void set_stretch() {
    become(wall_);
    system_.set_time(1);
  }

  // The strain of its prestress where that is linear in u.
  double rms_prestrain(const VectorXd& u) const {
    WallInput stressed = wall_;
    stressed.prestress_displacement = points_of(u);
    return WallEnergy(stressed).rms_prestrain();
  }

  // The displacement that the forces would cause which u leaves, the ties' of a displaced ring
  // among them.
  VectorXd step(const VectorXd& u) override {
    VectorXd force;
    system_.gradient(z_, force);
    if (system_.has_ties()) {
      VectorXd displaced, of_ties = VectorXd::Zero(z_.size());
      CoupledForces parts;
      system_.gradient(z_ + u, displaced, &parts);
      system_.put(0, parts.ties, false, of_ties);  // at the places of their vertices
      force += of_ties;
    }
    VectorXd change(force.size());
    factor_.solve(force.data(), change.data(), 1);
    return -change;
  }

  double length(const VectorXd& u) const override {
    return points_of(u).rowwise().norm().maxCoeff();
  }

  Points points_of(const VectorXd& u) const {
    return system_.state(z_ + u).positions - wall_.rest.points;
  }

 private:
  void become(const WallInput& wall) {
    WallEnergy next(wall);  // throws before the system loses the one it has
    energy_ = std::move(next);
    system_.set_energy(0, *energy_);
    is_shaped_ = false;
  }

  double length_;
  std::vector<HeldSection> sections_;
  WallInput wall_;
  std::optional<WallEnergy> energy_;
  CoupledSystem system_;
  VectorXd z_;
  Cholesky factor_;
  bool is_shaped_ = false;  // the energy is one from a shape without stress
};

}  // namespace

ScanDisplacement scan_displacement(const WallInput& given, std::vector<HeldSection> sections,
                                   double scan_pressure, double largest_linear,
                                   const std::function<bool()>& stop) {
  SeenWall wall(given, std::move(sections), scan_pressure);
  if (!wall.stiffen())
    throw InputError(given.name +
                     ": nothing holds it against the pressure of its scan, expected a held end");
  wall.set_stretch();
  VectorXd u = wall.step(wall.no_displacement());
  ScanDisplacement found;
  if (std::isfinite(largest_linear) && wall.rms_prestrain(u) > largest_linear)
    found.steps = search_stress_free(wall, u, stop);
  found.from_stress_free_shape = found.steps > 0;
  found.points = wall.points_of(u) * wall.unit();
  return found;
}

}  // namespace vasorod
