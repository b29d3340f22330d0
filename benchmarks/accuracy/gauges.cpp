#include "accuracy/gauges.h"

#include <cmath>

namespace vasorod::bench {

AxialGauge middle_half(const HeldTube& tube, const Points& positions) {
  double z[2] = {}, rest[2] = {}, wider = 0;
  int count[2] = {};
  for (Eigen::Index i = 0; i < positions.rows(); ++i) {
    const double s = tube.mesh.s[i] / tube.shape.length;
    if (s < 0.25 || s > 0.75) continue;
    const int upper = s > 0.5;
    z[upper] += positions(i, 2);
    rest[upper] += tube.mesh.s[i];
    wider += std::hypot(positions(i, 0), positions(i, 1)) / tube.shape.radius - 1;
    ++count[upper];
  }
  const double far = z[1] / count[1] - z[0] / count[0],
               far_rest = rest[1] / count[1] - rest[0] / count[0];
  return {far / far_rest - 1, wider / (count[0] + count[1])};
}

double off_cylinder(const HeldTube& tube, const Points& positions) {
  return (positions.leftCols<2>().rowwise().norm().array() / tube.shape.radius - 1)
      .abs()
      .maxCoeff();
}

EndMotion pure_bending(double curvature) {
  EndMotion end;
  end.change[4] = curvature;
  end.held = {false, true, false, true, true, true};
  return end;
}

double middle_curvature(const HeldTube& tube, const Points& positions) {
  const SectionMean a = section_mean(tube, positions, 0.4 * tube.shape.length);
  const SectionMean b = section_mean(tube, positions, 0.6 * tube.shape.length);
  return log_rotation(a.rotation.transpose() * b.rotation).y() / (b.s - a.s);
}

ShearGauge transverse_force(const HeldTube& tube) {
  // Over E R^2 1e-6 with the tubes here: linear, and far above rounding.
  constexpr double small = 1e-4;
  const double length = tube.shape.length;
  EndMotion end;
  end.held.fill(false);
  end.force = Vec3(small, 0, 0);
  const HeldAnswer answer = solve(tube, end);
  const SectionMean a = section_mean(tube, answer.positions, 0.4 * length);
  const SectionMean b = section_mean(tube, answer.positions, 0.6 * length);
  const SectionMean m = section_mean(tube, answer.positions, (a.s + b.s) / 2);
  const auto turn = [](const SectionMean& section) { return log_rotation(section.rotation).y(); };
  const double gauge = b.s - a.s;
  // The rotation is quadratic in s: its mean from three sections (Simpson if m is the middle).
  const double x = (m.s - a.s) / gauge, at_m = 1 / (6 * x * (1 - x)), at_b = 0.5 - at_m * x;
  const double turned = (1 - at_m - at_b) * turn(a) + at_m * turn(m) + at_b * turn(b);
  const double strain = (b.centre.x() - a.centre.x()) / gauge - turned;
  const double force = answer.force.x(), curvature = (turn(b) - turn(a)) / gauge;
  const double moment = force * (length - (a.s + b.s) / 2);
  return {moment / curvature / tube.inertia(),
          force / (strain * tube.shear_modulus() * tube.area()), answer.settled};
}

double cowper_coefficient(double radius, double thickness, double nu) {
  const double q = (radius - thickness / 2) / (radius + thickness / 2),
               square = std::pow(1 + q * q, 2);
  return 6 * (1 + nu) * square / ((7 + 6 * nu) * square + (20 + 12 * nu) * q * q);
}

}  // namespace vasorod::bench
