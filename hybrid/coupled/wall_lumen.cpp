#include "coupled/wall_lumen.h"

#include <algorithm>
#include <utility>

#include <vasorod/error.h>

#include "data/index.h"
#include "geometry/triangle_surface.h"
#include "numerics/cholesky.h"
#include "wall/shear_band.h"

namespace vasorod {
namespace {

// Of a soft section, over E t. The linear displacement does not depend on it.
constexpr double tie_stiffness = 100;

int section_at(const std::vector<HeldSection>& sections, int vertex) {
  for (size_t s = 0; s < sections.size(); ++s)
    if (std::find(sections[s].ring.begin(), sections[s].ring.end(), vertex) !=
        sections[s].ring.end())
      return static_cast<int>(s);
  return WallLumen::free_end;
}

}  // namespace

WallLumen wall_lumen(const WallInput& wall, const std::vector<HeldSection>& sections,
                     const std::vector<int>& seam, const LumenPressure& pressure) {
  std::vector<LumenFan> fans;
  WallLumen lumen;
  for (std::vector<int>& loop : boundary_loops(wall.rest.triangles)) {
    const auto first = seam.empty() ? loop.end() : std::find(loop.begin(), loop.end(), seam[0]);
    const bool joined = first != loop.end();
    if (joined) std::rotate(loop.begin(), first, loop.end());
    lumen.behind_fan.push_back(joined ? WallLumen::seam : section_at(sections, loop[0]));
    fans.push_back({std::move(loop), joined});
  }
  const Eigen::VectorXd depth = (wall.thickness / 2).array() - wall.mid_offset;
  lumen.volume = Lumen(wall.rest, depth, thinning_exponent(wall.material), std::move(fans));
  lumen.scan = pressure.scan;
  lumen.after = pressure.after;
  return lumen;
}

Points scan_displacement(const WallInput& given, std::vector<HeldSection> sections,
                         double scan_pressure) {
  const double length = mean_edge_length(given.rest), stress = given.material.young_axial;
  const Vec3 origin = given.rest.points.colwise().mean().transpose();
  TriangleSurface rest = given.rest;
  rest.points = (rest.points.rowwise() - origin.transpose()) / length;
  WallInput wall = scaled(given, std::move(rest), length, stress);
  wall.prestress_displacement.resize(0, 3);
  for (HeldSection& section : sections) {
    section = scaled(section, length, stress * length * length, origin);
    section.fixed.fill(true);
    section.motion = {};
    section.force = section.moment = section.body_moment = Vec3::Zero();
  }
  wall.glued = glued_marks(sections, wall.rest.points.rows());
  wall.lean = shear_band(wall);
  WallEnergy stretched(wall);
  wall.axial_prestretch = 1;
  WallEnergy free_of_stress(wall);

  CoupledSystem system;
  system.add_wall(free_of_stress, wall.rest.points, sections,
                  tie_stiffness * wall.thickness.mean());
  system.set_lumen(0, wall_lumen(wall, sections, {}, {0, scan_pressure / stress}));
  system.finish();
  system.set_time(0);
  Eigen::VectorXd z, force;
  system.put(0, wall.rest.points, false, z);
  for (size_t s = 0; s < sections.size(); ++s)
    system.put_pose(0, static_cast<int>(s), Mat3::Identity(), sections[s].rest.position, z);
  const Eigen::SparseMatrix<double> stiffness = system.hessian(z);
  system.set_energy(0, stretched);
  system.set_time(1);
  system.gradient(z, force);
  Cholesky factor;
  factor.analyse(stiffness);
  if (!factor.factorise(stiffness))
    throw InputError(given.name +
                     ": nothing holds it against the pressure of its scan, expected a held end");
  Eigen::VectorXd change(force.size());
  factor.solve(force.data(), change.data(), 1);
  return (system.state(z - change).positions - wall.rest.points) * length;
}

}  // namespace vasorod
