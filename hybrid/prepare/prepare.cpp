#include "prepare/prepare.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "geometry/closest_point.h"
#include "geometry/crossing_triangles.h"
#include "geometry/triangle_surface.h"
#include "mask/mask_surface.h"
#include "prepare/guess_unit.h"
#include "prepare/in_mm.h"
#include "prepare/open_ends.h"
#include "prepare/outer_wall.h"
#include "prepare/part_walls.h"
#include "prepare/smooth.h"
#include "surface_file/check_surface.h"
#include "surface_file/clean_surface.h"
#include "surface_file/open_caps.h"
#include "surface_file/read_polydata.h"
#include "surface_file/remesh.h"
#include "surface_file/surface_file.h"
#include "vessel/vessel.h"

namespace vasorod {
namespace {

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

// Area of an end over that of the circle of its perimeter. An ellipse of 2 to 1 has 0.84, one of
// 3 to 1 has 0.66, two circles that touch have 0.5.
constexpr double least_roundness = 0.7;

// Difference of the fitted radius at an end from that of the circle of its area, over the latter.
// Long branches have up to 5 %, nearly flat ends a little more.
constexpr double well_found = 0.1, most_bridged = 0.15;

double radius_off(const Vessel& vessel, const VesselEnd& end) {
  const double radius = std::sqrt(area_vector(vessel.surface.points, end.loop).norm() / M_PI);
  return std::abs(vessel.rod.radius[static_cast<std::size_t>(end.node)] / radius - 1);
}

// At the worst end; infinite where `fit` refuses the surface.
double radius_off(const TriangleSurface& surface) {
  try {
    const Vessel vessel = fit_vessel("prepared", surface);
    double worst = 0;
    for (const VesselEnd& end : vessel.ends) worst = std::max(worst, radius_off(vessel, end));
    return worst;
  } catch (const InputError&) {
    return HUGE_VAL;
  }
}

// The surface with the points of a loop before all others.
TriangleSurface with_first(const TriangleSurface& surface, const std::vector<int>& loop) {
  const auto n = surface.points.rows();
  std::vector<int> place(static_cast<std::size_t>(n), -1);
  int next = 0;
  for (const int v : loop) place[static_cast<std::size_t>(v)] = next++;
  for (int& p : place)
    if (p < 0) p = next++;
  TriangleSurface out = surface;
  for (Eigen::Index v = 0; v < n; ++v)
    out.points.row(place[static_cast<std::size_t>(v)]) = surface.points.row(v);
  for (int& v : out.triangles.reshaped()) v = place[static_cast<std::size_t>(v)];
  return out;
}

class Preparation {
 public:
  explicit Preparation(const PrepareRequest& request) : request_(request) {}

  PreparedSurface run() {
    read();
    one_part();
    in_millimetres();
    in_space();
    const TriangleSurface reference = surface();
    one_wall();
    remesh_wall();
    out_.volume_after = lidded_volume(surface());
    open_closed_ends();
    best_end_first();
    check();
    measure(reference);
    return std::move(out_);
  }

 private:
  TriangleSurface& surface() { return out_.surface; }
  void did(const std::string& what) { out_.done.push_back(what); }
  void clean() {
    check_manifold(name_, surface());
    LoadedSurface loaded;
    loaded.surface = std::move(surface());
    clean_surface(loaded);
    surface() = std::move(loaded.surface);
  }

  void read() {
    if (request_.files.empty()) throw InputError("found no file, expected a mask or a surface");
    name_ = one_line(request_.files.front().string());
    request_.progress("reading " + name_);
    if (is_mask(request_.files.front())) {
      if (request_.files.size() > 1)
        throw InputError(name_ + ": found " + std::to_string(request_.files.size()) +
                         " files, expected one mask or several surfaces of one vessel");
      Mask mask = read_mask(request_.files.front());
      unit_ = mask.head.unit;
      out_.space = mask.head.space;
      MaskSurface found = mask_surface(name_, std::move(mask), request_.label);
      voxel_ = found.voxel;
      for (const std::string& note : found.notes) out_.warnings.push_back(note);
      surface() = std::move(found.surface);
      did("label " + std::to_string(found.label) + " of the mask taken, " +
          counted(static_cast<std::size_t>(surface().triangles.rows()), "triangle", "triangles"));
      return;
    }
    if (request_.label) throw InputError(name_ + ": found a surface, expected a mask with --label");
    for (const auto& file : request_.files) {
      if (is_mask(file))
        throw InputError(one_line(file.string()) +
                         ": found a mask beside a surface, expected one or the other");
      const LoadedSurface loaded = read_polydata(file);
      const bool vtp = loaded.surface.points.rows() > 0 && file.extension() == ".vtp";
      const std::string unit = vtp ? units_in_vtp(file) : "";
      if (file != request_.files.front() && (unit != unit_ || loaded.space != out_.space))
        throw InputError(one_line(file.string()) + ": found another unit or space than that of " +
                         name_ + ", expected parts of one vessel in the same");
      unit_ = unit;
      out_.space = loaded.space;
      append(surface(), loaded.surface);
      for (const std::string& line : loaded.report.lines()) did(line);
    }
  }

  void one_part() {
    for (const std::string& line : orient(surface())) did(line);
    if (surface().triangles.rows() == 0)
      throw InputError(name_ + ": found only triangles without area, expected a surface");
    const bool inverted = lidded_volume(surface()) < 0;
    out_.left_out = keep_largest(surface());
    if (inverted && !voxel_) did("the surface turned inside out: it faced inwards");
    clean();
  }

  void in_millimetres() {
    const Vec3 extent =
        surface().points.colwise().maxCoeff() - surface().points.colwise().minCoeff();
    std::string unit = request_.units.value_or(unit_);
    if (request_.units && !unit_.empty() && unit_ != *request_.units)
      out_.warnings.push_back("the file says " + unit_ + ", --units says " + unit);
    if (unit.empty()) {
      const double radius =
          handles_of(surface()) > 0 ? facing_width(surface()) / 2 : typical_radius(surface());
      const GuessedUnit guess = guess_unit(radius, extent.norm());
      unit = guess.unit;
      did("units: " + guess.reason);
    } else {
      did("units: " + unit + (request_.units ? ", as --units says" : ", as the file says"));
    }
    const double scale = millimetres(unit);
    surface().points *= scale;
    if (voxel_) *voxel_ *= scale;
    for (LeftOut& part : out_.left_out) {
      part.center *= scale;
      part.volume *= scale * scale * scale;
    }
    if (scale != 1) did("converted to mm");
  }

  void in_space() {
    if (request_.from_space) {
      if (!out_.space.empty() && out_.space != *request_.from_space)
        out_.warnings.push_back("the file says " + out_.space + ", --from-space says " +
                                *request_.from_space);
      out_.space = *request_.from_space;
    }
    if (request_.space && out_.space.empty())
      throw InputError(name_ +
                       ": found no coordinate system in the file, expected --from-space "
                       "LPS or RAS to convert it to " +
                       *request_.space);
    if (request_.space && *request_.space != out_.space) {
      surface().points.leftCols<2>() *= -1;
      for (LeftOut& part : out_.left_out) part.center.head<2>() *= -1;
      did("converted from " + out_.space + " to " + *request_.space);
      out_.space = *request_.space;
    }
    say_left_out();
  }

  void say_left_out() {
    const double volume = std::abs(lidded_volume(surface()));
    std::size_t specks = 0;
    for (const LeftOut& part : out_.left_out) {
      const std::string what = part.inside ? "an inner wall or cavity" : "an island";
      if (part.volume < 1e-3 * volume) {
        ++specks;
        continue;
      }
      did(what + " of " + number_text(part.volume, 3) + " mm^3 left out, at " +
          place_mm(part.center));
      if (!part.inside && part.volume > 0.2 * volume)
        out_.warnings.push_back("a second vessel may be in it: the part left out at " +
                                place_mm(part.center) + " has " +
                                number_text(100 * part.volume / volume, 2) +
                                " % of the volume of the one that is kept");
    }
    if (specks > 0) did(counted(specks, "speck", "specks") + " left out");
  }

  void close_openings() {
    const Openings openings = openings_of(surface());
    std::vector<std::vector<int>> close = openings.holes;
    if (!openings.holes.empty()) did(counted(openings.holes.size(), "hole", "holes") + " closed");
    std::vector<std::vector<int>> uneven;
    for (const auto& loop : openings.ends)
      if (unevenness(surface().points, loop) > 0.4) uneven.push_back(loop);
    // What `fit` takes as it is stays as it is.
    if (!uneven.empty() && !(close.empty() && fits())) {
      close.insert(close.end(), uneven.begin(), uneven.end());
      did(counted(uneven.size(), "uneven end", "uneven ends") + " closed, to be cut flat");
    }
    fill_loops(surface(), close);
    out_.volume_before = std::abs(lidded_volume(surface()));
  }

  void one_wall() {
    close_openings();
    smooth_wall();
    std::size_t crossings = 0;
    int handles = 0;
    const auto is_one = [&] {
      crossings = self_intersections(surface()).size();
      handles = handles_of(surface());
      return crossings == 0 && handles == 0;
    };
    if (is_one() || (keep_outer() && is_one())) return;
    request_.progress("wrapping");
    fill_loops(surface(), boundary_loops(surface().triangles));
    const std::string why =
        handles > 0 ? "two walls or a bridge (" +
                          counted(static_cast<std::size_t>(handles), "handle", "handles") + ")"
                    : counted(crossings, "pair", "pairs") + " of crossing triangles";
    auto wall = outer_wall(surface());
    if (!wall)
      throw InputError(name_ + ": found " + why +
                       " that no wrap removes, expected branches that do not meet again");
    surface() = std::move(wall->surface);
    out_.volume_before = std::abs(lidded_volume(surface()));
    rebuilt_ = true;
    did("outer wall taken, for " + why + ": alpha wrap by a ball of radius " + in_mm(wall->ball) +
        ", put back on the input's wall but for " + number_text(100 * wall->lifted, 2) +
        " % of its points");
  }

  // Of two walls, parted at their rims, the outer one.
  bool keep_outer() {
    auto walls = part_walls(surface());
    if (!walls) return false;
    surface() = std::move(walls->outer);
    did("outer of two walls taken as it is, " + in_mm(walls->thickness) + " from the inner");
    // The rims of what was smoothed are uneven all around.
    if (stairs_) fill_loops(surface(), boundary_loops(surface().triangles));
    clean();
    close_openings();
    return true;
  }

  bool fits() {
    try {
      fit_vessel("prepared", surface());
      return true;
    } catch (const InputError&) {
      return false;
    }
  }

  void smooth_wall() {
    stairs_ = voxel_.has_value() || has_stairs(surface());
    if (!stairs_) return;
    request_.progress("smoothing");
    smooth(surface());
    rebuilt_ = true;
    did("stairs of voxels smoothed");
  }

  void remesh_wall() {
    const double radius = typical_radius(surface());
    if (!rebuilt_ && !request_.remesh) {
      open_lids();
      return;
    }
    const double edge = request_.remesh.value_or(std::max(radius / 6, voxel_.value_or(0) / 2));
    if (edge > radius || edge < radius / 50)
      throw InputError(joined_text(name_, ": found an edge of ", edge,
                                   " mm to remesh to, expected ", radius / 50, " to ", radius,
                                   ", from 1/50 to 1 of the radius"));
    if (!stairs_) open_lids();
    request_.progress("remeshing");
    surface() = remesh(surface(), edge);
    clean();
    did("remeshed to an edge of " + in_mm(edge));
  }

  // Flat lids come off whole; voxels have facets that are none.
  void open_lids() {
    LoadedSurface loaded;
    loaded.surface = std::move(surface());
    open_caps(loaded);
    surface() = std::move(loaded.surface);
    if (!loaded.lids.empty())
      did(counted(loaded.lids.size(), "flat lid", "flat lids") + " taken off");
  }

  void open_closed_ends() {
    request_.progress("opening the ends");
    OpenedEnds opened;
    try {
      opened = open_ends(surface(), {request_.ends, request_.cut_branches_below});
    } catch (const InputError& error) {
      throw InputError(name_ + ": " + error.what());
    }
    for (const std::string& line : opened.done) did(line);
    for (const std::string& line : opened.warnings) out_.warnings.push_back(line);
    clean();
  }

  // `fit` follows the branches from the first end. From a short branch, or towards a fork that is
  // wide, it has no closed sections to go by, so that of branched vessels the end comes first from
  // which the radii at all ends are found best: the widest, where they are found well.
  void best_end_first() {
    auto loops = boundary_loops(surface().triangles);
    if (loops.size() < 3) return;
    request_.progress("choosing the first end");
    std::stable_sort(loops.begin(), loops.end(), [&](const auto& a, const auto& b) {
      return perimeter(surface().points, a) > perimeter(surface().points, b);
    });
    std::optional<TriangleSurface> best;
    double least = HUGE_VAL;
    for (const auto& loop : loops) {
      TriangleSurface one = with_first(surface(), loop);
      const double off = radius_off(one);
      if (off < least) {
        least = off;
        best = std::move(one);
      }
      if (least < well_found) break;
    }
    if (best) surface() = std::move(*best);
  }

  void check() {
    const std::string name = name_ + " prepared";
    check_manifold(name, surface());
    if (boundary_loops(surface().triangles).size() < 2 && !out_.warnings.empty())
      throw InputError(name_ + ": " + out_.warnings.back() +
                       ", expected two open ends at least: name the places of the ends (--end), "
                       "or cut it open before");
    check_ends(name, surface(), Role::deformable);
    check_outward(name, surface());
    check_unit(name, surface(), Units{});
    check_self_intersections(name, surface());
    for (const auto& loop : boundary_loops(surface().triangles)) {
      PreparedEnd end;
      for (const int v : loop)
        end.center += surface().points.row(v).transpose() / static_cast<double>(loop.size());
      const Vec3 area = area_vector(surface().points, loop);
      end.normal = -area.normalized();
      end.radius = perimeter(surface().points, loop) / (2 * M_PI);
      out_.ends.push_back(end);
      const double share = area.norm() / (M_PI * end.radius * end.radius);
      if (share < least_roundness)
        out_.warnings.push_back("the end at " + place_mm(end.center) + " encloses " +
                                number_text(100 * share, 2) +
                                " % of the circle of its perimeter: two vessels that touch may be "
                                "in it, or it is nearly flat");
    }
    request_.progress("fitting");
    try {
      say_bridged(fit_vessel("prepared", surface()));
    } catch (const InputError& error) {
      out_.refusal = error.what();
      out_.warnings.push_back("fit refuses it: " + out_.refusal);
    }
  }

  // Between a fork and an end that is near for the branch's width no section is closed: `fit` takes
  // the radius from elsewhere. Of a thin branch the cut may lie in the rounding of its cap.
  void say_bridged(const Vessel& vessel) {
    for (const VesselEnd& end : vessel.ends) {
      const double fitted = vessel.rod.radius[static_cast<std::size_t>(end.node)],
                   radius = std::sqrt(area_vector(surface().points, end.loop).norm() / M_PI);
      if (radius_off(vessel, end) > most_bridged)
        out_.warnings.push_back("the end at " + place_mm(end.center) + " has a radius of " +
                                in_mm(radius) + ", fit finds " + in_mm(fitted) +
                                " there: its branch is short for its width, or the cut lies in its "
                                "rounded cap; segment it farther");
    }
  }

  void measure(const TriangleSurface& reference) {
    const ClosestPoint wall(reference);
    const Eigen::VectorXd area = vertex_areas(surface());
    double sum = 0;
    for (Eigen::Index i = 0; i < surface().points.rows(); ++i) {
      const Vec3 p = surface().points.row(i);
      const double distance = (wall.query(p).point - p).norm();
      sum += area[i] * distance;
      out_.largest_distance = std::max(out_.largest_distance, distance);
    }
    out_.mean_distance = sum / area.sum();
  }

  PrepareRequest request_;
  PreparedSurface out_;
  std::string name_, unit_;
  std::optional<double> voxel_;  // spacing of a mask, mm
  bool stairs_ = false, rebuilt_ = false;
};

}  // namespace

PreparedSurface prepare(const PrepareRequest& request) {
  return Preparation(request).run();
}

}  // namespace vasorod
