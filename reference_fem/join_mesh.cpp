#include "reference_fem/join_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "reference_fem/grading.h"

namespace vasorod::fem {
namespace {

constexpr Grading grading;

/// Length of the artery's first line per fraction of its axis.
double line_length(const TubeShape& tube) {
  return std::hypot(tube.length, tube.end_radius - tube.radius);
}

double half_around(const JoinProblem& problem) {
  const Incision& incision = problem.incision;
  return std::numbers::pi * problem.artery.shape.radius_at(0.5 * (incision.from + incision.to));
}

/// Stations from 0 to 1, graded from 0.
std::vector<double> unit_stations(double length, int count) {
  std::vector<double> out = grading.stations(length, count);
  for (double& x : out) x /= length;
  out.back() = 1;
  return out;
}

/// Maps stations of [0, 1] to [from, to] and appends them, increasing, without a repeated point.
void append(std::vector<double>& line, const std::vector<double>& stations, double from,
            double to) {
  std::vector<double> mapped;
  mapped.reserve(stations.size());
  for (const double x : stations) mapped.push_back(x == 1 ? to : from + x * (to - from));
  if (from > to) std::reverse(mapped.begin(), mapped.end());
  for (const double x : mapped)
    if (line.empty() || x > line.back() + 1e-14) line.push_back(x);
}

/// A whole tube whose rim is a side: equal cells around, graded along.
Strip tube_strip(const TubeShape& tube, int rim_side, int around, int along,
                 const JoinCells& cells) {
  Strip strip;
  strip.degree = cells.degree;
  strip.layers = cells.layers;
  for (int k = 0; k <= around; ++k) strip.around.push_back(static_cast<double>(k) / around);
  append(strip.along, unit_stations(tube.length, along), rim_side, 1 - rim_side);
  strip.welded.assign(strip.along.size(), 1);
  return strip;
}

Strip vein_strip(const JoinProblem& problem, const JoinCells& cells) {
  if (problem.other_rim)
    return tube_strip(problem.vein.shape, problem.seam_side, 4 * cells.seam, cells.vein, cells);
  const auto [mirror_x, mirror_y] = problem.mirror;
  Strip strip;
  strip.degree = cells.degree;
  strip.layers = cells.layers;
  // the seam's stations from a tip to the middle of a lip
  const std::vector<double> quarter = unit_stations(problem.incision.perimeter / 4, cells.seam);
  if (mirror_x && !mirror_y) append(strip.around, quarter, 0, -0.25);
  append(strip.around, quarter, 0, 0.25);
  if (!mirror_x) append(strip.around, quarter, 0.5, 0.25);
  if (!mirror_x && !mirror_y) {
    append(strip.around, quarter, 0.5, 0.75);
    append(strip.around, quarter, 1, 0.75);
  }
  const std::vector<double> along = unit_stations(problem.vein.shape.length, cells.vein);
  append(strip.along, along, problem.seam_side, 1 - problem.seam_side);
  strip.welded.assign(strip.along.size(), !mirror_x && !mirror_y);
  return strip;
}

Strip artery_strip(const JoinProblem& problem, const JoinCells& cells) {
  if (problem.other_rim)
    return tube_strip(problem.artery.shape, problem.other_rim->side, 4 * cells.seam, cells.after,
                      cells);
  const auto [mirror_x, mirror_y] = problem.mirror;
  const Incision& incision = problem.incision;
  const double line = line_length(problem.artery.shape);
  Strip strip;
  strip.degree = cells.degree;
  strip.layers = cells.layers;
  const std::vector<double> around = unit_stations(half_around(problem), cells.around);
  append(strip.around, around, 0, 0.5);
  if (!mirror_y) append(strip.around, around, 1, 0.5);
  const double middle = 0.5 * (incision.from + incision.to);
  const std::vector<double> quarter = unit_stations(incision.perimeter / 4, cells.seam);
  if (!mirror_x) {
    append(strip.along, unit_stations(incision.from * line, cells.before), incision.from, 0);
    append(strip.along, quarter, incision.from, middle);
  }
  append(strip.along, quarter, incision.to, middle);
  append(strip.along, unit_stations((1 - incision.to) * line, cells.after), incision.to, 1);
  for (const double s : strip.along)
    strip.welded.push_back(!mirror_y && !(s > incision.from + 1e-12 && s < incision.to - 1e-12));
  return strip;
}

Chart chart_of(const JoinWall& wall) {
  return [&wall](const Vec3& p) { return wall.shape.point(wall.parameters(p)); };
}

/// The strip of a vessel that was not cut, from that of its kept part: goes on beyond the cut with
/// cells that grow away from it, and is closed.
Strip seen_strip(const JoinWall& wall, Strip strip, bool whole_around) {
  for (double& s : strip.along) s = wall.kept_from + s * (wall.kept_to - wall.kept_from);
  const double cut = wall.kept_from > 0 ? wall.kept_from : wall.kept_to,
               far = wall.kept_from > 0 ? 0 : 1, stump = std::abs(far - cut) * wall.whole.length;
  if (stump > 0) {
    const double like_the_kept = static_cast<double>(strip.along.size() - 1) /
                                 grading.cells(wall.shape.length) * grading.cells(stump);
    const int count = std::max(1, static_cast<int>(std::ceil(like_the_kept)));
    std::vector<double> beyond;
    append(beyond, unit_stations(stump, count), cut, far);
    if (far == 0) {
      beyond.pop_back();
      strip.along.insert(strip.along.begin(), beyond.begin(), beyond.end());
    } else {
      strip.along.insert(strip.along.end(), beyond.begin() + 1, beyond.end());
    }
  }
  strip.welded.assign(strip.along.size(), whole_around ? 1 : 0);
  return strip;
}

bool same(double a, double b) {
  return std::abs(a - b) < 1e-12;
}

bool at_mid_wall(const Mesh& mesh, int node) {
  return std::abs(mesh.parameters(node, 2) - 0.5) < 1e-9;
}

/// Node and share of every mid-wall node of a tube's rim, by share.
std::vector<std::pair<double, int>> tube_rim(int side, const Mesh& mesh) {
  std::vector<std::pair<double, int>> rim;
  for (const int node : mesh.nodes_on(1, side)) {
    if (!at_mid_wall(mesh, node)) continue;
    const double share = mesh.parameters(node, 0);
    rim.emplace_back(share - std::floor(share + 1e-9), node);
  }
  std::sort(rim.begin(), rim.end());
  return rim;
}

std::vector<std::pair<double, int>> lip_rim(const JoinProblem& problem, const Mesh& mesh) {
  if (problem.other_rim) return tube_rim(problem.other_rim->side, mesh);
  const Incision& incision = problem.incision;
  std::vector<std::pair<double, int>> rim;
  for (int node = 0; node < mesh.node_count(); ++node) {
    const Vec3 at = mesh.parameters.row(node);
    if (std::min(std::abs(at[0]), std::abs(at[0] - 1)) > 1e-12 || at[1] < incision.from - 1e-12 ||
        at[1] > incision.to + 1e-12 || !at_mid_wall(mesh, node))
      continue;
    rim.emplace_back(incision.rim_share(at), node);
  }
  std::sort(rim.begin(), rim.end());
  return rim;
}

}  // namespace

JoinCells first_cells(const JoinProblem& problem, int seam, int vein, int multiple) {
  const Incision& incision = problem.incision;
  const double perimeter = problem.other_rim ? 2 * std::numbers::pi : incision.perimeter;
  const double factor = seam / grading.cells(perimeter / 4);
  const auto count = [&](double length) {
    return multiple *
           std::max(1, static_cast<int>(std::lround(factor * grading.cells(length) / multiple)));
  };
  const double line = line_length(problem.artery.shape);
  JoinCells cells;
  cells.seam = seam;
  cells.vein = vein;
  if (problem.other_rim) {
    cells.after = count(problem.artery.shape.length);
    if (vein == 0) cells.vein = count(problem.vein.shape.length);
    cells.around = cells.before = 0;
    return cells;
  }
  cells.around = count(half_around(problem));
  cells.before = count(incision.from * line);
  cells.after = count((1 - incision.to) * line);
  if (vein == 0) cells.vein = count(problem.vein.shape.length);
  return cells;
}

JoinCells refined(const JoinCells& cells, double factor) {
  JoinCells out = cells;
  for (int JoinCells::*number : {&JoinCells::seam, &JoinCells::vein, &JoinCells::around,
                                 &JoinCells::before, &JoinCells::after})
    out.*number = static_cast<int>(std::lround(factor * (cells.*number)));
  return out;
}

JoinLines join_lines(const JoinProblem& problem, const JoinCells& cells) {
  return {vein_strip(problem, cells).along, artery_strip(problem, cells).along};
}

JoinMesh make_join_mesh(const JoinProblem& problem, const JoinCells& cells,
                        const Processes& processes) {
  JoinMesh mesh{make_strip(vein_strip(problem, cells), chart_of(problem.vein), processes),
                make_strip(artery_strip(problem, cells), chart_of(problem.artery), processes),
                {}};
  const auto rim = tube_rim(problem.seam_side, mesh.vein), lips = lip_rim(problem, mesh.artery);
  if (rim.size() != lips.size()) throw std::logic_error("join: rim and lips differ in nodes");
  for (std::size_t k = 0; k < rim.size(); ++k) {
    if (std::abs(rim[k].first - lips[k].first) > 1e-9)
      throw std::logic_error("join: rim and lips differ in shares");
    const int a = rim[k].second, b = lips[k].second;
    mesh.seam.push_back({a, b, lips[k].first, mesh.vein.nodes.row(a) - mesh.artery.nodes.row(b)});
  }
  return mesh;
}

JoinMesh make_seen_mesh(const JoinProblem& problem, const JoinCells& cells,
                        const Processes& processes) {
  const auto [mirror_x, mirror_y] = problem.mirror;
  const JoinWall vein = as_seen(problem.vein), artery = as_seen(problem.artery);
  return {make_strip(seen_strip(problem.vein, vein_strip(problem, cells), !mirror_x && !mirror_y),
                     chart_of(vein), processes),
          make_strip(seen_strip(problem.artery, artery_strip(problem, cells), !mirror_y),
                     chart_of(artery), processes),
          {}};
}

std::array<bool, 2> planes_of_vein(const JoinProblem& problem, const Vec3& at) {
  return {problem.mirror[0] && same(std::abs(at[0]), 0.25),
          problem.mirror[1] && (same(at[0], 0) || same(at[0], 0.5))};
}

std::array<bool, 2> planes_of_artery(const JoinProblem& problem, const Vec3& at) {
  const Incision& incision = problem.incision;
  return {problem.mirror[0] && same(at[1], 0.5 * (incision.from + incision.to)),
          problem.mirror[1] && (same(at[0], 0) || same(at[0], 0.5))};
}

Folded fold_vein(const JoinProblem& problem, double share, double fraction) {
  const auto [mirror_x, mirror_y] = problem.mirror;
  Folded out;
  if (mirror_y && share > 0.5) {
    share = 1 - share;
    out.sign[1] = -1;
  }
  if (mirror_x && share > 0.25 && share < 0.75) {
    share = 0.5 - share;
    out.sign[0] = -1;
  } else if (mirror_x && share >= 0.75) {
    share -= 1;
  }
  out.parameter = {share, fraction, 0.5};
  return out;
}

Folded fold_artery(const JoinProblem& problem, double share, double fraction) {
  const auto [mirror_x, mirror_y] = problem.mirror;
  const double middle = 0.5 * (problem.incision.from + problem.incision.to);
  Folded out;
  if (mirror_y && share > 0.5) {
    share = 1 - share;
    out.sign[1] = -1;
  }
  if (mirror_x && fraction < middle) {
    fraction = 2 * middle - fraction;
    out.sign[0] = -1;
  }
  out.parameter = {share, fraction, 0.5};
  return out;
}

}  // namespace vasorod::fem
