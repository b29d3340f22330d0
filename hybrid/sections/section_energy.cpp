#include "sections/section_energy.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "data/index.h"
#include "numerics/dense_blocks.h"
#include "wall/axial_stretch.h"
#include "wall/lumen.h"

namespace vasorod {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// The jet's vectors, the point itself last: order of their derivative along and around.
constexpr std::array<int, 6> order_along{1, 0, 2, 1, 0, 0}, order_around{0, 1, 0, 1, 2, 0};
// The vectors of a WallPoint and of a LumenPoint.
constexpr std::array<int, 5> of_wall{0, 1, 2, 3, 4};
constexpr std::array<int, 3> of_lumen{5, 0, 1};

// Two vectors of a jet whose orders along are these.
struct Pair {
  int a, b;
};
// With six vectors, those of the point itself that meet in the lumen's Hessian follow.
std::vector<Pair> pairs_of(const std::array<int, 2>& along, int vectors) {
  std::vector<Pair> pairs;
  const auto add = [&](int a, int b) {
    if (order_along[index(a)] == along[0] && order_along[index(b)] == along[1])
      pairs.push_back({a, b});
  };
  for (int a = 0; a < 5; ++a)
    for (int b = 0; b < 5; ++b) add(a, b);
  if (vectors == 6)
    for (const int first : {0, 1}) {
      add(5, first);
      add(first, 5);
    }
  return pairs;
}
constexpr std::array<std::array<int, 2>, 6> orders{
    {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

// Gauss and Legendre on [-1, 1] by Newton's method.
void gauss(int count, VectorXd& abscissa, VectorXd& weight) {
  abscissa.resize(count);
  weight.resize(count);
  for (int i = 0; i < count; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5)), slope = 1;
    for (int iteration = 0; iteration < 100; ++iteration) {
      double before = 1, now = x;
      for (int k = 2; k <= count; ++k) {
        const double next = ((2 * k - 1) * x * now - (k - 1) * before) / k;
        before = now;
        now = next;
      }
      slope = count * (x * now - before) / (x * x - 1);
      const double step = now / slope;
      x -= step;
      if (std::abs(step) < 1e-15) break;
    }
    abscissa[i] = -x;
    weight[i] = 2 / ((1 - x * x) * slope * slope);
  }
}

// C = A B by the BLAS; of A as many columns as B has rows.
void multiply(const MatrixXd& a, const MatrixXd& b, MatrixXd& c) {
  const int rows = static_cast<int>(a.rows()), columns = static_cast<int>(b.cols()),
            inner = static_cast<int>(b.rows());
  c.resize(rows, columns);
  const double one = 1, zero = 0;
  dgemm_("N", "N", &rows, &columns, &inner, &one, a.data(), &rows, b.data(), &inner, &zero,
         c.data(), &rows);
}

}  // namespace

// The vectors of the jet at all points around one station, each points x 3.
struct SectionEnergy::Jets {
  std::array<MatrixXd, 6> vector;
  SurfaceJet at(Eigen::Index q) const {
    SurfaceJet jet;
    for (int a = 0; a < 5; ++a) jet.col(a) = vector[index(a)].row(q).transpose();
    return jet;
  }
  Mat3 of_lumen_at(Eigen::Index q) const {
    Mat3 jet;
    for (int k = 0; k < 3; ++k) jet.col(k) = vector[index(of_lumen[index(k)])].row(q).transpose();
    return jet;
  }
};

SectionEnergy::SectionEnergy(const SectionWall& wall) : space_(wall.rest.space), wall_(wall) {
  // Twice as many points as harmonics integrate a quadratic energy of the strains exactly; the
  // strains hold products of the surface's harmonics.
  const int around = 4 * space_.harmonics + 4;
  const VectorXd angles =
      VectorXd::LinSpaced(around, 0, 2 * std::numbers::pi * (around - 1) / around);
  for (int k = 0; k < 3; ++k) around_[index(k)] = harmonic_values(angles, space_.harmonics, k);
  VectorXd abscissa, weight;
  gauss(stations_per_span(), abscissa, weight);
  for (int span = 0; span < space_.along.spans(); ++span) {
    const double from = space_.along.begin(span), half = (space_.along.end(span) - from) / 2;
    for (Eigen::Index g = 0; g < abscissa.size(); ++g) {
      Station station;
      const double u = from + half * (1 + abscissa[g]);
      const AxialBasis::Values basis = space_.along.at(u, span);
      station.first = basis.first;
      station.basis = basis.values;
      station.u = u;
      station.measure = half * weight[g] * 2 * std::numbers::pi / around;
      set_points(station, wall_.rest.coefficients, Vec2::Ones());
      stations_.push_back(std::move(station));
    }
  }
  set_products(5);
}

// `shape`: without stress but for the stretch, along and across the fibre, that leads to it.
void SectionEnergy::set_points(Station& station, const MatrixXd& shape, const Vec2& stretch) const {
  // The fibre follows the vessel's axis as seen, the middle of its sections, and is the same line
  // of matter in the shape without stress.
  const VectorXd slope = wall_.rest.coefficients.middleCols(station.first, station.basis.cols()) *
                         station.basis.row(1).transpose();
  const Vec3 axis(slope[0], slope[space_.modes()], slope[2 * space_.modes()]);
  const double thickness = wall_.thickness(station.u),
               thinning = thinning_exponent(wall_.material) - 1;
  const Jets seen = jets(wall_.rest.coefficients, station), free = jets(shape, station);
  const auto area_of = [](const SurfaceJet& jet) { return jet.col(0).cross(jet.col(1)).norm(); };
  station.points.clear();
  for (Eigen::Index q = 0; q < around_[0].rows(); ++q) {
    // Heights are those of the wall as seen, which is thinner than without stress.
    const double widened = area_of(seen.at(q)) / area_of(free.at(q)) * stretch.prod(),
                 thicker = std::pow(widened, -thinning);
    const Eigen::Matrix<double, 3, 2> sides = seen.at(q).leftCols<2>();
    const Vec3 fibre = free.at(q).leftCols<2>() * (sides.transpose() * sides).inverse() *
                       (sides.transpose() * axis);
    station.points.emplace_back(free.at(q), fibre, thicker * (wall_.mid_offset - thickness / 2),
                                thicker * (wall_.mid_offset + thickness / 2), station.measure,
                                wall_.material, stretch);
  }
}

void SectionEnergy::set_products(int vectors) {
  const int modes = space_.modes(), around = static_cast<int>(around_[0].rows());
  for (size_t o = 0; o < orders.size(); ++o) {
    const std::vector<Pair> pairs = pairs_of(orders[o], vectors);
    MatrixXd& products = products_[o];
    products.resize(modes * modes, std::ssize(pairs) * around);
    for (size_t p = 0; p < pairs.size(); ++p)
      for (int q = 0; q < around; ++q) {
        const MatrixXd& left = around_[index(order_around[index(pairs[p].a)])];
        const MatrixXd& right = around_[index(order_around[index(pairs[p].b)])];
        products.col(static_cast<int>(p) * around + q) =
            (left.row(q).transpose() * right.row(q)).reshaped();
      }
  }
}

void SectionEnergy::set_prestress(const MatrixXd& displacement, double axial_prestretch) {
  const Vec3 strain = strain_of_stretch(wall_.material, axial_prestretch);
  for (Station& station : stations_) {
    const Jets rest = jets(wall_.rest.coefficients, station), moved = jets(displacement, station);
    for (Eigen::Index q = 0; q < around_[0].rows(); ++q)
      station.points[index(q)].set_prestress(rest.at(q), moved.at(q), strain);
  }
}

double SectionEnergy::rms_prestrain() const {
  double sum = 0, area = 0;
  for (const Station& station : stations_)
    for (const WallPoint& point : station.points) {
      const Vec3 e = point.membrane_prestrain();
      sum += point.area() * (e.squaredNorm() - e[2] * e[2] / 2);
      area += point.area();
    }
  return std::sqrt(sum / area);
}

void SectionEnergy::set_stress_free_shape(const MatrixXd& displacement, double axial_prestretch) {
  const Vec2 stretch = stretches_along_and_across(wall_.material, axial_prestretch);
  const MatrixXd shape = wall_.rest.coefficients - displacement;
  for (Station& station : stations_) set_points(station, shape, stretch);
}

void SectionEnergy::set_pressure(double pressure) {
  pressure_ = pressure;
  if (pressure != 0 && stations_.front().lumen.empty()) set_lumen();
}

void SectionEnergy::set_lumen() {
  set_products(6);
  const double thinning = thinning_exponent(wall_.material);
  for (Station& station : stations_) {
    const Jets rest = jets(wall_.rest.coefficients, station);
    for (Eigen::Index q = 0; q < around_[0].rows(); ++q) {
      const SurfaceJet jet = rest.at(q);
      station.lumen.emplace_back(jet.col(0).cross(jet.col(1)).norm(), depth(station.u), thinning,
                                 station.measure);
    }
  }
}

std::array<SectionLid, 2> SectionEnergy::lids() const {
  return {SectionLid(space_.harmonics, false), SectionLid(space_.harmonics, true)};
}

SectionEnergy::Jets SectionEnergy::jets(const MatrixXd& coefficients,
                                        const Station& station) const {
  const Eigen::Index functions = station.basis.cols();
  // Columns: the section's derivatives along.
  const MatrixXd sections =
      coefficients.middleCols(station.first, functions) * station.basis.transpose();
  Jets jets;
  for (size_t a = 0; a < index(vectors()); ++a)
    jets.vector[a].noalias() =
        around_[index(order_around[a])] * sections.col(order_along[a]).reshaped(space_.modes(), 3);
  return jets;
}

double SectionEnergy::gradient(const MatrixXd& coefficients, MatrixXd& gradient,
                               double& size) const {
  gradient.setZero(coefficients.rows(), coefficients.cols());
  double energy = 0, square = 0;
  const Eigen::Index around = around_[0].rows();
  std::array<MatrixXd, 6> force;
  for (MatrixXd& f : force) f.resize(around, 3);
  MatrixXd sections(space_.row_size(), 3), local;
  // Adds the forces on these vectors of the jets at a station.
  const auto add = [&](const Station& station, const auto& used) {
    sections.setZero();
    for (const int a : used)
      sections.col(order_along[index(a)]).reshaped(space_.modes(), 3) +=
          around_[index(order_around[index(a)])].transpose() * force[index(a)];
    local.noalias() = sections * station.basis;
    square += local.squaredNorm();
    gradient.middleCols(station.first, station.basis.cols()) += local;
  };
  for (const Station& station : stations_) {
    const Jets here = jets(coefficients, station);
    for (Eigen::Index q = 0; q < around; ++q) {
      const PointEnergy e = station.points[index(q)].energy(here.at(q), false);
      energy += e.membrane + e.bending;
      for (int a = 0; a < 5; ++a) force[index(a)].row(q) = e.gradient.col(a).transpose();
    }
    add(station, of_wall);
    if (pressure_ == 0) continue;
    for (Eigen::Index q = 0; q < around; ++q) {
      const PointVolume v = station.lumen[index(q)].volume(here.of_lumen_at(q), false);
      energy -= pressure_ * v.value;
      for (int k = 0; k < 3; ++k)
        force[index(of_lumen[index(k)])].row(q) = -pressure_ * v.gradient.col(k).transpose();
    }
    add(station, of_lumen);
  }
  if (pressure_ != 0)
    for (const SectionLid& lid : lids()) {
      const Eigen::Index row = lid.last() ? coefficients.cols() - 1 : 0;
      VectorXd on_lid = VectorXd::Zero(space_.row_size());
      energy -= pressure_ * lid.add_gradient(coefficients.col(row), -pressure_, on_lid);
      square += on_lid.squaredNorm();
      gradient.col(row) += on_lid;
    }
  size = std::sqrt(square);
  return energy;
}

BlockBand SectionEnergy::empty_hessian() const {
  return {space_.along.count(), space_.row_size(), space_.along.degree()};
}

void SectionEnergy::hessian(const MatrixXd& coefficients, BlockBand& hessian,
                            double stress_share) const {
  hessian.set_zero();
  const int modes = space_.modes(), functions = space_.along.degree() + 1,
            stations = stations_per_span(), around = static_cast<int>(around_[0].rows()),
            square = modes * modes;
  // Columns (order pair, station): blocks of two sections' derivatives, modes^2 * 9.
  MatrixXd sums(square * 9, 6 * stations), values, product;
  const int rows = 3 * vectors();
  MatrixXd points(rows * rows, around);
  for (int span = 0; span < space_.along.spans(); ++span) {
    for (int g = 0; g < stations; ++g) {
      const Station& station = stations_[index(span * stations + g)];
      const Jets here = jets(coefficients, station);
      for (int q = 0; q < around; ++q) {
        points.col(q).setZero();
        auto point = points.col(q).reshaped(rows, rows);
        point.topLeftCorner<15, 15>() =
            station.points[index(q)].energy(here.at(q), true, stress_share).hessian;
        if (pressure_ == 0) continue;
        const PointVolume v = station.lumen[index(q)].volume(here.of_lumen_at(q), true);
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l)
            point.block<3, 3>(3 * of_lumen[index(k)], 3 * of_lumen[index(l)]) -=
                stress_share * pressure_ * v.hessian.block<3, 3>(3 * k, 3 * l);
      }
      for (size_t o = 0; o < orders.size(); ++o) {
        const std::vector<Pair> pairs = pairs_of(orders[o], vectors());
        values.resize(std::ssize(pairs) * around, 9);
        for (size_t p = 0; p < pairs.size(); ++p)
          for (int c = 0; c < 9; ++c)
            values.col(c).segment(static_cast<int>(p) * around, around) =
                points.row(3 * pairs[p].a + c % 3 + rows * (3 * pairs[p].b + c / 3)).transpose();
        multiply(products_[o], values, product);
        sums.col(static_cast<int>(o) * stations + g) = product.reshaped();
      }
    }
    // Per pair of B-splines i <= j the sums as they are, and those of different orders transposed.
    const int pairs = functions * (functions + 1) / 2;
    MatrixXd straight = MatrixXd::Zero(6 * stations, pairs), turned = straight;
    for (int i = 0, column = 0; i < functions; ++i)
      for (int j = i; j < functions; ++j, ++column)
        for (size_t o = 0; o < orders.size(); ++o)
          for (int g = 0; g < stations; ++g) {
            const MatrixXd& basis = stations_[index(span * stations + g)].basis;
            const auto [a, b] = orders[o];
            const int row = static_cast<int>(o) * stations + g;
            straight(row, column) = basis(a, i) * basis(b, j);
            if (a != b) turned(row, column) = basis(b, i) * basis(a, j);
          }
    MatrixXd direct, reversed;
    multiply(sums, straight, direct);
    multiply(sums, turned, reversed);
    const int first = stations_[index(span * stations)].first;
    for (int i = 0, column = 0; i < functions; ++i)
      for (int j = i; j < functions; ++j, ++column) {
        MatrixXd& block = hessian.upper(first + i, first + j);
        for (int c = 0; c < 9; ++c) {
          const int row = c % 3, other = c / 3;
          block.block(row * modes, other * modes, modes, modes) +=
              direct.col(column).segment(c * square, square).reshaped(modes, modes);
          block.block(other * modes, row * modes, modes, modes) +=
              reversed.col(column).segment(c * square, square).reshaped(modes, modes).transpose();
        }
      }
  }
  if (pressure_ != 0)
    for (const SectionLid& lid : lids()) {
      const int row = lid.last() ? hessian.rows() - 1 : 0;
      lid.add_hessian(coefficients.col(row), -stress_share * pressure_, hessian.upper(row, row));
    }
}

SectionEnergy::Report SectionEnergy::report(const MatrixXd& coefficients) const {
  Report report;
  for (const Station& station : stations_) {
    const Jets here = jets(coefficients, station);
    const VectorXd section =
        wall_.rest.coefficients.middleCols(station.first, station.basis.cols()) *
        station.basis.row(0).transpose();
    for (Eigen::Index q = 0; q < around_[0].rows(); ++q) {
      const WallPoint& point = station.points[index(q)];
      const PointEnergy e = point.energy(here.at(q), false);
      report.membrane += e.membrane;
      report.bending += e.bending;
      const FaceStretches faces = point.faces(here.at(q));
      const Vec3 place = (around_[0].row(q) * section.reshaped(space_.modes(), 3)).transpose();
      if (faces.least < report.faces.least) {
        report.faces.least = faces.least;
        report.least_place = place;
      }
      if (faces.largest > report.faces.largest) {
        report.faces.largest = faces.largest;
        report.largest_place = place;
      }
    }
  }
  return report;
}

}  // namespace vasorod
