#include "report/camera.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace vasorod {

namespace {

Mat3 axes_of(const Vec3& towards_eye, const Vec3& up) {
  const Vec3 eye = towards_eye.normalized();
  Vec3 right = up.cross(eye);
  if (right.norm() < 1e-9) right = eye.unitOrthogonal();
  right.normalize();
  Mat3 axes;
  axes.row(0) = right.transpose();
  axes.row(1) = eye.cross(right).transpose();
  axes.row(2) = eye.transpose();
  return axes;
}

// Smallest and largest coordinates of the points along the axes.
std::pair<Vec3, Vec3> bounds(const std::vector<Seen>& scene, const Mat3& axes, bool only_wanted) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Seen& seen : scene)
    if (seen.wanted || !only_wanted)
      for (Eigen::Index i = 0; i < seen.points->rows(); ++i) {
        const Vec3 at = axes * seen.points->row(i).transpose();
        low = low.cwiseMin(at);
        high = high.cwiseMax(at);
      }
  if (low.allFinite() && high.allFinite()) return {low, high};
  return {Vec3::Constant(-1), Vec3::Constant(1)};
}

// The nearest body in each cell of a coarse grid over the wanted bodies.
class FrontGrid {
 public:
  FrontGrid(const std::vector<Seen>& scene, const Mat3& axes) : axes_(axes) {
    const auto [low, high] = bounds(scene, axes, true);
    low_ = low;
    size_ = std::max({high.x() - low.x(), high.y() - low.y(), 1e-300}) / cells;
    constexpr Eigen::Index enough = 6000;  // points of a body: several per covered cell
    for (const Seen& seen : scene)
      for (Eigen::Index i = 0; i < seen.points->rows(); i += 1 + seen.points->rows() / enough) {
        double depth = 0;
        Cell* cell = cell_at(seen.points->row(i).transpose(), depth);
        if (cell && depth > cell->depth) *cell = {depth, seen.wanted};
      }
  }

  int wanted_cells() const {
    return static_cast<int>(
        std::count_if(grid_.begin(), grid_.end(), [](const Cell& cell) { return cell.wanted; }));
  }

  // Of the covered cells.
  double wanted_share() const {
    const auto covered = std::count_if(grid_.begin(), grid_.end(),
                                       [](const Cell& c) { return std::isfinite(c.depth); });
    return covered > 0 ? double(wanted_cells()) / static_cast<double>(covered) : 0;
  }

  // Whether no body is more than two cells in front of a point.
  bool shows(const Vec3& point) {
    double depth = 0;
    const Cell* cell = cell_at(point, depth);
    return cell && depth > cell->depth - 2 * size_;
  }

 private:
  static constexpr int cells = 64;
  struct Cell {
    double depth = -std::numeric_limits<double>::infinity();
    bool wanted = false;
  };
  Cell* cell_at(const Vec3& point, double& depth) {
    const Vec3 at = axes_ * point - low_;
    const double column = at.x() / size_, row = at.y() / size_;
    if (!(column >= 0 && column <= cells && row >= 0 && row <= cells)) return nullptr;
    depth = at.z();
    return &grid_[static_cast<std::size_t>(row) * (cells + 1) + static_cast<std::size_t>(column)];
  }
  Mat3 axes_;
  Vec3 low_ = Vec3::Zero();
  double size_ = 1;
  std::vector<Cell> grid_ = std::vector<Cell>(static_cast<std::size_t>(cells + 1) * (cells + 1));
};

// The best of the directions perpendicular to `up` or lifted; the first if several are equal.
template <class Score>
Vec3 best_direction(const Vec3& up, Score&& score, std::initializer_list<double> lifts) {
  constexpr int around = 24;
  const Vec3 axis = up.normalized(), start = axis.unitOrthogonal();
  Vec3 best = start;
  double most = -1;
  for (const double lift : lifts)
    for (int k = 0; k < around; ++k) {
      const Vec3 direction =
          (Eigen::AngleAxisd(2 * M_PI * k / around, axis) * start + lift * axis).normalized();
      const double value = score(direction);
      if (value > most) {
        most = value;
        best = direction;
      }
    }
  return best;
}

// The weight of the spots that a direction shows.
double shown_weight(FrontGrid& grid, const std::vector<Spot>& spots, const Vec3& direction) {
  double sum = 0;
  for (const Spot& spot : spots)
    if (const double facing = spot.normal.dot(direction); facing > 0 && grid.shows(spot.at))
      sum += facing * spot.weight;
  return sum;
}

constexpr auto low = {0.12, 0.35};       // a little above the level
constexpr auto any = {0.12, 0.35, 0.8};  // as high as the stages of an operation are seen from

}  // namespace

Vec2 pixel_of(const Camera& camera, const Vec3& point, int width, int height) {
  const Vec3 at = camera.axes * (point - camera.centre);
  const double scale =
      camera.distance / (camera.distance - at.z()) * 0.5 * height / camera.half_height;
  return {0.5 * (1 - camera.shift) * width + scale * at.x(), 0.5 * height - scale * at.y()};
}

Vec3 clearest_direction(const std::vector<Seen>& scene, const Vec3& up) {
  return best_direction(
      up,
      [&](const Vec3& direction) {
        return static_cast<double>(FrontGrid(scene, axes_of(direction, up)).wanted_cells());
      },
      low);
}

Vec3 clearest_direction(const std::vector<Seen>& scene, const std::vector<Spot>& spots,
                        const Vec3& up) {
  if (spots.empty()) return clearest_direction(scene, up);
  double whole = 0;
  for (const Spot& spot : spots) whole += spot.weight;
  return best_direction(
      up,
      [&](const Vec3& direction) {
        FrontGrid grid(scene, axes_of(direction, up));
        return grid.wanted_share() + shown_weight(grid, spots, direction) / whole;
      },
      any);
}

Vec3 facing_direction(const std::vector<Seen>& scene, const std::vector<Spot>& spots,
                      const Vec3& up) {
  return best_direction(
      up,
      [&](const Vec3& direction) {
        FrontGrid grid(scene, axes_of(direction, up));
        return shown_weight(grid, spots, direction);
      },
      low);
}

Vec3 level_up(const std::vector<Seen>& scene) {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (const Seen& seen : scene)
    if (seen.wanted) {
      sum += seen.points->colwise().sum().transpose();
      count += static_cast<double>(seen.points->rows());
    }
  if (count == 0) return Vec3::UnitY();
  Mat3 spread = Mat3::Zero();
  for (const Seen& seen : scene)
    if (seen.wanted) {
      const Points from_mean = seen.points->rowwise() - sum.transpose() / count;
      spread += from_mean.transpose() * from_mean;
    }
  const Mat3 axes =
      Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors();  // smallest spread first
  Vec3 up = axes.col(1);
  Eigen::Index largest = 0;
  up.cwiseAbs().maxCoeff(&largest);
  return up[largest] < 0 ? Vec3(-up) : up;
}

Camera fit_camera(const std::vector<Seen>& scene, const Vec3& towards_eye, const Vec3& up,
                  double aspect, double clear_right) {
  Camera camera;
  camera.shift = clear_right;
  camera.axes = axes_of(towards_eye, up);
  const auto [low, high] = bounds(scene, camera.axes, true);
  const Vec3 middle = 0.5 * (low + high);
  camera.centre = camera.axes.transpose() * middle;
  const double nearest = bounds(scene, camera.axes, false).second.z() - middle.z();
  camera.distance = std::max(3 * (high - low).norm(), 1.5 * nearest);
  camera.half_height = 0;
  for (const Seen& seen : scene)
    if (seen.wanted)
      for (Eigen::Index i = 0; i < seen.points->rows(); ++i) {
        const Vec3 at = camera.axes * (seen.points->row(i).transpose() - camera.centre);
        const double shrink = camera.distance / (camera.distance - at.z());
        camera.half_height = std::max({camera.half_height, std::abs(at.y()) * shrink,
                                       std::abs(at.x()) * shrink / (aspect * (1 - clear_right))});
      }
  constexpr double margin = 1.1;
  camera.half_height = camera.half_height > 0 ? margin * camera.half_height : 1;
  return camera;
}

}  // namespace vasorod
