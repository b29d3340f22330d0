#include "prepare/prepare.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "geometry/closest_point.h"
#include "geometry/triangle_surface.h"
#include "prepare/find_tips.h"
#include "prepare/guess_unit.h"
#include "prepare/mask_surface.h"
#include "prepare/open_tip.h"
#include "prepare/outer_wall.h"
#include "prepare/part_walls.h"
#include "prepare/smooth.h"
#include "surface_file/check_surface.h"
#include "surface_file/clean_surface.h"
#include "surface_file/open_caps.h"
#include "surface_file/read_polydata.h"
#include "surface_file/remesh.h"
#include "surface_file/self_intersections.h"
#include "surface_file/surface_file.h"
#include "vessel/vessel.h"

namespace vasorod {
namespace {

// Lengths of branches over their radii from which a bulge is an end: a half ball has pi/2.
constexpr double shortest_branch = 1.8;

std::string mm(double value, int digits = 3) {
  return number_text(value, digits) + " mm";
}

std::string place_mm(const Vec3& place) {
  return place_text(place.unaryExpr([](double x) { return std::round(100 * x) / 100; }), 5);
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

// Area of an end over that of the circle of its perimeter. An ellipse of 2 to 1 has 0.84, one of
// 3 to 1 has 0.66, two circles that touch have 0.5.
constexpr double least_roundness = 0.7;

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
    open_ends();
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
    did("outer wall taken, for " + why + ": alpha wrap by a ball of radius " + mm(wall->ball) +
        ", put back on the input's wall but for " + number_text(100 * wall->lifted, 2) +
        " % of its points");
  }

  // Of two walls, parted at their rims, the outer one.
  bool keep_outer() {
    auto walls = part_walls(surface());
    if (!walls) return false;
    surface() = std::move(walls->outer);
    did("outer of two walls taken as it is, " + mm(walls->thickness) + " from the inner");
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
    did("remeshed to an edge of " + mm(edge));
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

  std::vector<Tip> tips() {
    if (request_.ends.empty()) return find_tips(surface(), shortest_branch);
    const std::vector<Tip> all = find_tips(surface(), 0.8);
    std::vector<Tip> chosen;
    for (const Vec3& place : request_.ends) {
      const Tip* nearest = nullptr;
      std::string found;
      for (const Tip& tip : all) {
        found += (found.empty() ? "" : ", ") + place_mm(tip.place);
        if (!nearest || (tip.place - place).norm() < (nearest->place - place).norm())
          nearest = &tip;
      }
      if (!nearest || (nearest->place - place).norm() > 3 * nearest->radius)
        throw InputError(name_ + ": found no closed end within three radii of " + place_mm(place) +
                         ", expected " + (found.empty() ? "none, all are open" : found));
      chosen.push_back(*nearest);
    }
    return chosen;
  }

  // Returns those that stay closed.
  std::vector<Tip> open_tips(const std::vector<Tip>& tips) {
    std::vector<Tip> closed;
    for (const Tip& tip : tips) {
      const auto sections = sections_behind_tip(surface(), tip);
      const auto cut = std::find_if(sections.begin(), sections.end(), [&](const FlatSection& one) {
        return cut_tip(surface(), tip, one);
      });
      if (cut == sections.end())
        closed.push_back(tip);
      else
        did("end opened at " + place_mm(cut->center) + ", " + mm((tip.place - cut->center).norm()) +
            " from its tip");
    }
    return closed;
  }

  void open_ends() {
    request_.progress("opening the ends");
    std::vector<Tip> left;
    for (const Tip& tip : tips()) {
      const auto sections = sections_behind_tip(surface(), tip);
      if (sections.empty() || sections.front().radius >= request_.cut_branches_below) {
        left.push_back(tip);
        continue;
      }
      const FlatSection foot = foot_of_branch(surface(), sections.front());
      if (!cut_tip(surface(), tip, foot)) {
        left.push_back(tip);
        continue;
      }
      Openings openings;
      for (const auto& loop : boundary_loops(surface().triangles))
        if ((surface().points.row(loop.front()).transpose() - foot.center).norm() <
                3 * foot.radius &&
            std::abs(
                (surface().points.row(loop.front()).transpose() - foot.center).dot(foot.normal)) <
                0.05 * foot.radius)
          openings.holes.push_back(loop);
      fill_loops(surface(), openings.holes);
      did("branch of radius " + mm(sections.front().radius) + " at " + place_mm(tip.place) +
          " taken off, its stump closed");
    }
    std::vector<Tip> closed;
    // Of one that stays closed, other points of its cap, found from an end that was opened.
    for (const Tip& tip : open_tips(left)) {
      const std::vector<Tip> others = find_tips(surface(), 0.8);
      if (std::none_of(others.begin(), others.end(), [&](const Tip& other) {
            return (other.place - tip.place).norm() < 3 * std::min(tip.radius, other.radius) &&
                   open_tips({other}).empty();
          }))
        closed.push_back(tip);
    }
    for (const Tip& tip : closed)
      out_.warnings.push_back("the end at " + place_mm(tip.place) +
                              " stays closed: no section across it parts it from the rest");
    clean();
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
      fit_vessel("prepared", surface());
    } catch (const InputError& error) {
      out_.refusal = error.what();
      out_.warnings.push_back("fit refuses it: " + out_.refusal);
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
