#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <vasorod/compare.h>
#include <vasorod/error.h>

#include "data/part_names.h"
#include "data/sentence.h"
#include "geometry/closest_point.h"
#include "geometry/triangle_surface.h"
#include "result/read_json.h"
#include "result/read_vtp.h"

namespace vasorod {

namespace fs = std::filesystem;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void refuse(const fs::path& a, const fs::path& b, const std::string& why) {
  throw InputError(a.string() + " and " + b.string() + " are not results of one scene: " + why);
}

bool is_scene_file(const std::string& name) {
  const std::string extension = fs::path(name).extension().string();
  return extension == ".yaml" ||
         extension == ".yml";  // two scenes may differ in their fidelity only
}

void require_one_scene(const fs::path& folder_a, const Result& a, const fs::path& folder_b,
                       const Result& b) {
  const auto same = [&](const std::string& what, const std::string& in_a, const std::string& in_b) {
    if (in_a != in_b)
      refuse(folder_a, folder_b,
             what + " is " + shortened(in_a) + " in the first and " + shortened(in_b) +
                 " in the second");
  };
  same("the scene", a.scene, b.scene);
  same("the length unit", a.length_unit, b.length_unit);
  same("the stress unit", a.stress_unit, b.stress_unit);
  std::set<std::string> vessels_a, vessels_b;
  for (const VesselResult& vessel : a.vessels)
    vessels_a.insert(vessel.name + (vessel.obstacle ? ", an obstacle" : ""));
  for (const VesselResult& vessel : b.vessels)
    vessels_b.insert(vessel.name + (vessel.obstacle ? ", an obstacle" : ""));
  for (const auto& [these, others, which] :
       {std::tuple(&vessels_a, &vessels_b, "first"), std::tuple(&vessels_b, &vessels_a, "second")})
    for (const std::string& name : *these)
      if (!others->count(name))
        refuse(folder_a, folder_b, "only the " + std::string(which) + " has the vessel " + name);
  for (const auto& [file, sum] : a.environment.inputs)
    if (const auto other = b.environment.inputs.find(file);
        other != b.environment.inputs.end() && !is_scene_file(file))
      if (other->second != sum)
        refuse(folder_a, folder_b, "the input " + shortened(file) + " has another content");
}

std::optional<ReadVessel> vessel_in(const fs::path& folder, const std::string& name) {
  const fs::path file = folder / (name + ".vtp");
  if (!fs::exists(file)) return std::nullopt;
  return read_vessel_vtp(file);
}

std::optional<ReadCenterline> centerline_in(const fs::path& folder, const std::string& name) {
  const fs::path file = folder / (centerline_name(name) + ".vtp");
  if (!fs::exists(file)) return std::nullopt;
  return read_centerline_vtp(file);
}

// The two nodes of every segment of the polylines.
std::vector<std::array<int, 2>> segments(const ReadCenterline& line) {
  std::vector<std::array<int, 2>> pairs;
  for (const std::vector<int>& run : line.lines)
    for (std::size_t k = 0; k + 1 < run.size(); ++k) pairs.push_back({run[k], run[k + 1]});
  return pairs;
}

double mean_radius(const std::optional<ReadCenterline>& line) {
  if (!line || line->radius.empty()) return nan_value;
  double sum = 0, length = 0;
  for (const auto& [i, j] : segments(*line)) {
    const double part = (line->rest.row(i) - line->rest.row(j)).norm();
    sum += part * 0.5 *
           (line->radius[static_cast<std::size_t>(i)] + line->radius[static_cast<std::size_t>(j)]);
    length += part;
  }
  return length > 0 ? sum / length : nan_value;
}

double mean_end_radius(const std::optional<ReadVessel>& vessel) {
  if (!vessel) return nan_value;
  const auto loops = boundary_loops(vessel->triangles);
  double sum = 0;
  for (const std::vector<int>& loop : loops) sum += perimeter(vessel->rest, loop);
  return loops.empty() ? nan_value : sum / (2 * M_PI * static_cast<double>(loops.size()));
}

double length_of(const std::optional<ReadCenterline>& line) {
  double length = 0;
  if (line)
    for (const auto& [i, j] : segments(*line))
      length += (line->rest.row(i) - line->rest.row(j)).norm();
  return length;
}

// Sums weighted distances, in length units until over() divides by R.
class Sum {
 public:
  void add(double distance, double weight, const Vec3& at) {
    squares_ += weight * distance * distance;
    weights_ += weight;
    if (!(distance <= result_.largest)) {  // NaN counts as the largest
      result_.largest = distance;
      result_.largest_at = at;
    }
  }
  Distances over(double radius) const {
    Distances result = result_;
    result.rms = std::sqrt(squares_ / weights_) / radius;
    result.largest /= radius;
    return result;
  }

 private:
  Distances result_;
  double squares_ = 0, weights_ = 0;
};

// Where A is compared: at its vertices, those of the boundary moved a quarter of the way into their
// triangles. At an incision, whose two lips lie on each other at rest, the closest triangle of
// another mesh is then on the vertex's own side.
struct Samples {
  Points rest, current;
};

Samples samples_of(const ReadVessel& a) {
  const Eigen::Index n = a.rest.rows();
  Samples samples{a.rest, a.current};
  std::vector<double> triangles(static_cast<std::size_t>(n), 0);
  for (Eigen::Index t = 0; t < a.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) triangles[static_cast<std::size_t>(a.triangles(t, k))] += 1;
  std::vector<char> on_boundary(static_cast<std::size_t>(n), 0);
  for (const std::vector<int>& loop : boundary_loops(a.triangles))
    for (const int v : loop) on_boundary[static_cast<std::size_t>(v)] = 1;
  for (Eigen::Index t = 0; t < a.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int v = a.triangles(t, k);
      if (on_boundary[static_cast<std::size_t>(v)] == 0) continue;
      const double share = 0.25 / triangles[static_cast<std::size_t>(v)];
      for (const auto& [from, to] :
           {std::pair{&a.rest, &samples.rest}, std::pair{&a.current, &samples.current}}) {
        Eigen::RowVector3d centroid = Eigen::RowVector3d::Zero();
        for (int c = 0; c < 3; ++c) centroid += from->row(a.triangles(t, c)) / 3;
        to->row(v) += share * (centroid - from->row(v));
      }
    }
  return samples;
}

Distances surface_distances(const ReadVessel& a, const ReadVessel& b, double radius,
                            double& rest_distance) {
  const ClosestPoint closest({b.rest, b.triangles});
  const Points moved = b.current - b.rest;
  // On the same mesh, a point is its own partner. The closest point would be ambiguous at an
  // incision, whose two sides coincide at rest.
  const bool same_mesh = a.rest.rows() == b.rest.rows() && a.rest == b.rest &&
                         a.triangles.rows() == b.triangles.rows() && a.triangles == b.triangles;
  const Eigen::VectorXd areas = vertex_areas({a.rest, a.triangles});
  const Samples samples = same_mesh ? Samples{a.rest, a.current} : samples_of(a);
  Sum sum;
  for (Eigen::Index i = 0; i < a.rest.rows(); ++i) {
    if (areas[i] == 0) continue;  // a point without triangles
    const Vec3 at = a.rest.row(i).transpose();
    if (same_mesh) {
      sum.add((a.current.row(i) - b.current.row(i)).norm(), areas[i], at);
      continue;
    }
    const Vec3 sample = samples.rest.row(i).transpose();
    const ClosestPoint::Hit hit = closest.query(sample);
    const auto corners = b.triangles.row(hit.triangle);
    Vec3 other = Vec3::Zero();
    for (int k = 0; k < 3; ++k) other += hit.barycentric[k] * moved.row(corners[k]).transpose();
    const Vec3 own = samples.current.row(i).transpose() - sample;
    sum.add((own - other).norm(), areas[i], at);
    rest_distance = std::max(rest_distance, (hit.point - sample).norm() / radius);
  }
  return sum.over(radius);
}

Distances centerline_distances(const ReadCenterline& a, const ReadCenterline& b, double radius,
                               double& rest_distance) {
  std::vector<double> weights(static_cast<std::size_t>(a.rest.rows()), 0.0);
  for (const auto& [i, j] : segments(a)) {
    const double half = 0.5 * (a.rest.row(i) - a.rest.row(j)).norm();
    weights[static_cast<std::size_t>(i)] += half;
    weights[static_cast<std::size_t>(j)] += half;
  }
  const auto pairs = segments(b);
  Sum sum;
  for (Eigen::Index n = 0; n < a.rest.rows(); ++n) {
    const Vec3 at = a.rest.row(n).transpose();
    double nearest = std::numeric_limits<double>::infinity();
    Vec3 other = Vec3::Zero();
    for (const auto& [i, j] : pairs) {
      const Vec3 from = b.rest.row(i).transpose(), along = b.rest.row(j).transpose() - from;
      const double t =
          std::clamp((at - from).dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
      const double distance = (at - from - t * along).norm();
      if (distance >= nearest) continue;
      nearest = distance;
      other =
          ((1 - t) * (b.current.row(i) - b.rest.row(i)) + t * (b.current.row(j) - b.rest.row(j)))
              .transpose();
    }
    const Vec3 own = (a.current.row(n) - a.rest.row(n)).transpose();
    sum.add((own - other).norm(), weights[static_cast<std::size_t>(n)], at);
    rest_distance = std::max(rest_distance, nearest / radius);
  }
  return sum.over(radius);
}

VesselComparison compare_vessel(const std::string& name, const fs::path& folder_a,
                                const fs::path& folder_b) {
  VesselComparison result;
  result.name = name;
  const auto surface_a = vessel_in(folder_a, name), surface_b = vessel_in(folder_b, name);
  const auto line_a = centerline_in(folder_a, name), line_b = centerline_in(folder_b, name);
  for (const double radius :
       {mean_radius(line_a), mean_radius(line_b), mean_end_radius(surface_a),
        mean_end_radius(surface_b), 0.01 * length_of(line_a)})  // a bare rod has no radius
    if (std::isfinite(radius) && !(result.radius > 0)) result.radius = radius;
  if (!(result.radius > 0))
    throw InputError((folder_a / name).string() +
                     ": has neither surface nor centerline, expected one");
  if (surface_a && surface_b)
    result.surface = surface_distances(*surface_a, *surface_b, result.radius, result.rest_distance);
  if (line_a && line_b)
    result.centerline = centerline_distances(*line_a, *line_b, result.radius, result.rest_distance);
  if (!result.surface && !result.centerline)
    throw InputError((folder_a / name).string() +
                     ": one result has only a surface and the other only a centerline, "
                     "expected the same of both");
  return result;
}

const EndReaction* end_of(const Result& result, const EndReaction& like) {
  const auto found = std::find_if(
      result.ends.begin(), result.ends.end(),
      [&](const EndReaction& end) { return end.vessel == like.vessel && end.end == like.end; });
  return found == result.ends.end() ? nullptr : &*found;
}

// Two results of one scene may differ in their supported ends only where their fidelities do, and
// then one of them has all ends of the other.
std::vector<LoneEnd> lone_ends(const Result& a, const Result& b, const fs::path& folder_a,
                               const fs::path& folder_b) {
  std::vector<LoneEnd> lone;
  for (const EndReaction& end : a.ends)
    if (end_of(b, end) == nullptr) lone.push_back({end.vessel, end.end, true});
  const std::size_t only_a = lone.size();
  for (const EndReaction& end : b.ends)
    if (end_of(a, end) == nullptr) lone.push_back({end.vessel, end.end, false});
  const bool nested = only_a == 0 || only_a == lone.size();
  if (lone.empty() || (nested && a.fidelity != b.fidelity)) return lone;
  if (nested)
    refuse(folder_a, folder_b,
           "the first has " + std::to_string(a.ends.size()) + " supported ends and the second " +
               std::to_string(b.ends.size()));
  refuse(
      folder_a, folder_b,
      "only the first has the end " + shortened(lone[0].end) + " of " + shortened(lone[0].vessel));
}

// Of the ends that both have.
std::vector<ReactionComparison> compare_reactions(const Result& a, const Result& b) {
  double largest_force = 0, largest_moment = 0;
  for (const EndReaction& end : a.ends) {
    largest_force = std::max(largest_force, end.force.norm());
    largest_moment = std::max(largest_moment, end.moment.norm());
  }
  std::vector<ReactionComparison> reactions;
  for (const EndReaction& end : a.ends) {
    const EndReaction* other = end_of(b, end);
    if (other == nullptr) continue;
    ReactionComparison reaction{end.vessel, end.end,       end.force, other->force,
                                end.moment, other->moment, 0,         0};
    reaction.moment_b += (other->center - end.center).cross(other->force);
    reaction.force_difference = (reaction.force_a - reaction.force_b).norm() / largest_force;
    reaction.moment_difference = (reaction.moment_a - reaction.moment_b).norm() / largest_moment;
    reactions.push_back(reaction);
  }
  return reactions;
}

ComparedResult header(const fs::path& folder, const Result& result) {
  const auto total = result.seconds.find("total");
  return {folder.string(), result.program, result.fidelity, to_string(result.status),
          total == result.seconds.end() ? nan_value : total->second};
}

}  // namespace

Comparison compare_results(const fs::path& folder_a, const fs::path& folder_b) {
  const Result a = read_json(folder_a / "result.json"), b = read_json(folder_b / "result.json");
  require_one_scene(folder_a, a, folder_b, b);
  Comparison comparison{
      a.scene, a.length_unit, a.stress_unit, header(folder_a, a), header(folder_b, b), {}, {}, {}};
  for (const VesselResult& vessel : a.vessels) {
    if (vessel.obstacle) continue;
    const VesselComparison compared = compare_vessel(vessel.name, folder_a, folder_b);
    if (compared.rest_distance > 0.5)
      refuse(folder_a, folder_b,
             "the rest shapes of " + vessel.name + " lie up to " +
                 std::to_string(compared.rest_distance) + " radii apart");
    comparison.vessels.push_back(compared);
  }
  comparison.reactions = compare_reactions(a, b);
  comparison.lone_ends = lone_ends(a, b, folder_a, folder_b);
  return comparison;
}

}  // namespace vasorod
