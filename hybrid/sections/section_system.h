// One vessel's wall in one space with its ends and its lumen: unknowns, energy, Hessian, forces.
// The unknowns are those of the end at u = 0, the free rows of coefficients, and those of the end
// at u = 1.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include <vasorod/material.h>

#include "coupled/coupled_problem.h"
#include "sections/banded_cholesky.h"
#include "sections/held_rows.h"
#include "sections/section_energy.h"

namespace vasorod {

/// What is held at u = 0 and at u = 1; empty: free.
using HeldEnds = std::array<std::optional<HeldSection>, 2>;

/// The system of one level. All in one system of units.
class SectionSystem {
 public:
  SectionSystem(const SectionWall& wall, const HeldEnds& ends);

  int unknowns() const;
  const SectionSpace& space() const { return energy_.space(); }
  const SectionEnergy& energy() const { return energy_; }

  /// The pressure in the lumen at times 0 and 1, stress.
  void set_lumen(const LumenPressure& pressure) { lumen_ = pressure; }
  /// SectionEnergy::set_prestress.
  void set_prestress(const Eigen::MatrixXd& displacement, double axial_prestretch);
  /// SectionEnergy::set_stress_free_shape.
  void set_stress_free_shape(const Eigen::MatrixXd& displacement, double axial_prestretch);
  /// Moves the ends' fixed freedoms to time t in 0..1 and applies that share of the loads and of
  /// the change of the pressure.
  void set_time(double t);
  /// The unknowns nearest to a shape in this space, with the ends in poses (rotation from rest)
  /// near to the given ones.
  Eigen::VectorXd unknowns_of(const Eigen::MatrixXd& coefficients,
                              const std::array<Pose, 2>& poses);
  Eigen::MatrixXd coefficients(const Eigen::VectorXd& z) const;
  /// SectionPose::recentre of both ends: the largest change of a moment, force * length.
  double recentre(Eigen::VectorXd& z);
  bool has_potential() const;

  /// Energy less the loads' potential.
  double value(const Eigen::VectorXd& z) const;
  struct Gradient {
    double value = 0;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd rows;  ///< of the energy of wall and pressure, per coefficient
    double size = 0;       ///< the length of what is summed in `gradient`
  };
  Gradient gradient(const Eigen::VectorXd& z) const;
  /// `at`: the gradient at the same unknowns. `stress_share`: as in WallPoint::energy.
  BandMatrix hessian(const Eigen::VectorXd& z, const Gradient& at, double stress_share = 1);

  /// What a held end exerts on the wall, without what it carries of the pressure on its lid; empty:
  /// it is free.
  std::optional<SectionSolution> wrench(int end, const Eigen::VectorXd& z,
                                        const Gradient& at) const;
  /// The force of the pressure on the lid of an end that carries it; zero of one that is free to
  /// move, where the lid pulls at the wall.
  Vec3 carried_lid(int end, const Eigen::VectorXd& z) const;

 private:
  // The part of z of the end, and of the free rows.
  Eigen::VectorXd part(int end, const Eigen::VectorXd& z) const;
  int first_free() const { return ends_[0] ? static_cast<int>(ends_[0]->rows().size()) : 0; }
  int end_of_free() const;
  int place_of_row(int row) const;  // of a free row in z
  int end_unknowns(int end) const;
  // The same with the moment about `center`.
  void carried_lid(int end, const Eigen::VectorXd& z, const Vec3& center, Vec3& force,
                   Vec3& moment) const;

  SectionEnergy energy_;
  std::array<std::optional<HeldRows>, 2> ends_;
  BlockBand band_;
  LumenPressure lumen_;
};

}  // namespace vasorod
