#include "accuracy/bent_ring.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace vasorod::bench {
namespace {

using Eigen::VectorXd;
using std::numbers::pi;

constexpr int modes = 12, points = 144;
constexpr int most_iterations = 200;
constexpr double step_tolerance = 1e-12, difference = 1e-6;
constexpr double closure_weight = 1e3;  // the ring closes to 1e-6 of its energy's scale

// Lengths in R. Unknowns: phi = theta + sum_n a_n sin n theta, symmetric about the plane of
// bending, then c over the larger of k and k0.
class Ring {
 public:
  // `stiff`: D / (E t R^2), k and k0 in 1 / R.
  Ring(double stiff, double k, double k0)
      : stiff_(stiff), k_(k), k0_(k0), scale_(std::max(k, k0)) {}

  VectorXd solve() const {
    VectorXd unknown = VectorXd::Zero(modes + 1);
    for (int i = 0; i < most_iterations; ++i) {  // Gauss-Newton
      const VectorXd at = residual(unknown);
      Eigen::MatrixXd slope(at.size(), unknown.size());
      for (int n = 0; n <= modes; ++n) {
        const VectorXd by = difference * VectorXd::Unit(modes + 1, n);
        slope.col(n) = (residual(unknown + by) - residual(unknown - by)) / (2 * difference);
      }
      const VectorXd step = slope.colPivHouseholderQr().solve(at);
      unknown -= step;
      if (step.norm() < step_tolerance) break;
    }
    return unknown;
  }

  struct Shape {
    VectorXd y, z, angle_slope;  // at equal arcs, from the outermost point on
    double gap = 0;              // of z: 0 where the ring is closed
  };
  Shape shape(const VectorXd& unknown) const {
    Shape s{VectorXd(points), VectorXd(points), VectorXd(points)};
    const double step = 2 * pi / points;
    double y = 0, z = 0, phi = 0;
    for (int i = 0; i < points; ++i) {
      s.y[i] = y;
      s.z[i] = z;
      s.angle_slope[i] = angle_slope(unknown, i * step);
      const double middle = angle(unknown, (i + 0.5) * step), next = angle(unknown, (i + 1) * step);
      y -= step / 6 * (std::sin(phi) + 4 * std::sin(middle) + std::sin(next));  // Simpson
      z += step / 6 * (std::cos(phi) + 4 * std::cos(middle) + std::cos(next));
      phi = next;
    }
    s.y.array() -= s.y.mean();
    s.gap = z;
    return s;
  }

  double rest(int i) const { return std::cos(i * 2 * pi / points); }
  double strain(const Shape& s, double c, int i) const {
    return (k_ * s.y[i] + scale_ * c - k0_ * rest(i)) / (1 + k0_ * rest(i));
  }

 private:
  static double angle(const VectorXd& unknown, double theta) {
    double phi = theta;
    for (int n = 1; n <= modes; ++n) phi += unknown[n - 1] * std::sin(n * theta);
    return phi;
  }
  static double angle_slope(const VectorXd& unknown, double theta) {
    double slope = 1;
    for (int n = 1; n <= modes; ++n) slope += n * unknown[n - 1] * std::cos(n * theta);
    return slope;
  }

  VectorXd residual(const VectorXd& unknown) const {
    const Shape s = shape(unknown);
    VectorXd r(2 * points + 1);
    for (int i = 0; i < points; ++i) {
      const double weight = std::sqrt((1 + k0_ * rest(i)) / points);
      r[2 * i] = weight * strain(s, unknown[modes], i) / scale_;
      r[2 * i + 1] = weight * std::sqrt(stiff_) * (s.angle_slope[i] - 1) / scale_;
    }
    r[2 * points] = closure_weight * s.gap;
    return r;
  }

  double stiff_, k_, k0_, scale_;
};

}  // namespace

BentRing bent_ring(double radius, double thickness, double nu, double curvature,
                   double curvature_at_rest) {
  const double ratio = thickness / radius;
  const Ring ring(ratio * ratio / (12 * (1 - nu * nu)), curvature * radius,
                  curvature_at_rest * radius);
  const VectorXd unknown = ring.solve();
  const Ring::Shape shape = ring.shape(unknown);
  BentRing bent;
  for (int i = 0; i < points; ++i)
    bent.moment += ring.strain(shape, unknown[modes], i) * shape.y[i] * thickness * radius *
                   radius * 2 * pi / points;
  bent.flattening = 1 - (shape.y.maxCoeff() - shape.y.minCoeff()) / 2;
  bent.widening = (shape.z.maxCoeff() - shape.z.minCoeff()) / 2 - 1;
  return bent;
}

double curved_tube_softening(double radius, double thickness, double nu, double curvature_at_rest) {
  constexpr double change = 1e-2;
  const auto moment = [&](double by) {
    return bent_ring(radius, thickness, nu, (1 + by) * curvature_at_rest, curvature_at_rest).moment;
  };
  return pi * std::pow(radius, 3) * thickness * 2 * change * curvature_at_rest /
         (moment(change) - moment(-change));
}

}  // namespace vasorod::bench
