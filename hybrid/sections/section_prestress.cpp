#include "sections/section_prestress.h"

#include <vasorod/error.h>

#include "data/index.h"

namespace vasorod {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd scan_displacement(const SectionWall& wall, HeldEnds ends, double scan_pressure,
                           double axial_prestretch, const std::string& name) {
  std::array<Pose, 2> poses;
  for (int e = 0; e < 2; ++e) {
    if (!ends[index(e)]) continue;
    HeldSection& end = *ends[index(e)];
    end.fixed.fill(true);
    end.motion = {};
    end.force = end.moment = end.body_moment = Vec3::Zero();
    poses[index(e)].position = end.rest.position;
  }
  const MatrixXd& rest = wall.rest.coefficients;
  SectionSystem system(wall, ends);
  system.set_prestress(MatrixXd::Zero(rest.rows(), rest.cols()), axial_prestretch);
  system.set_lumen({scan_pressure, scan_pressure});
  system.set_time(0);
  const VectorXd z = system.unknowns_of(rest, poses);
  const SectionSystem::Gradient at = system.gradient(z);
  BandMatrix stiffness = system.hessian(z, at, 0);
  if (!stiffness.factorise())
    throw InputError(name +
                     ": nothing holds it against the pressure of its scan, expected a held end");
  VectorXd change = -at.gradient;
  stiffness.solve(change);
  return system.coefficients(z + change) - system.coefficients(z);
}

}  // namespace vasorod
