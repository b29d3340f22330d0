#include "propose/propose_scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cmath>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/part_names.h"
#include "data/sentence.h"
#include "geometry/triangle_surface.h"
#include "propose/place_operation.h"
#include "propose/scene_text.h"
#include "surface_file/check_surface.h"
#include "surface_file/open_caps.h"
#include "surface_file/surface_file.h"
#include "vessel/name_ends.h"

namespace vasorod {
namespace {

// What a scene takes as a name (scene/read_vessels.cpp).
std::string scene_name(std::string text) {
  for (char& c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
  return text.substr(0, 100);
}

VesselSpec spec_of(const std::filesystem::path& surface) {
  VesselSpec spec;
  spec.name = scene_name(surface.stem().string());
  spec.surface = surface;
  spec.check = false;  // the unit is not known yet
  return spec;
}

void check_names(const std::vector<VesselSpec>& vessels) {
  for (size_t i = 0; i < vessels.size(); ++i)
    for (size_t j = 0; j < vessels.size(); ++j) {
      const std::string &one = vessels[i].name, &other = vessels[j].name;
      if (i < j && one == other)
        throw InputError(vessels[j].surface->string() + ": found the name " + in_quotes(one) +
                         ", which " + vessels[i].surface->string() +
                         " has too, expected files of different names, as vessels are called after "
                         "them");
      if (one == stump_name(other) || one == centerline_name(other))
        throw InputError(vessels[i].surface->string() + ": found the name " + in_quotes(one) +
                         ", which the result of " + other + " needs, expected another file name");
    }
}

// Whether the surface has no open end, also not under a lid.
bool closed(const VesselSpec& spec) {
  VesselSpec obstacle = spec;
  obstacle.role = Role::obstacle;
  LoadedSurface loaded = load_surface(obstacle, Scene());
  open_caps(loaded);
  return boundary_loops(loaded.surface.triangles).empty();
}

Units units_named(const std::string& length) {
  Units units;
  units.length = length;
  units.metres = length == "mm" ? 1e-3 : length == "cm" ? 1e-2 : 1;
  return units;
}

// The first unit in which all radii are those of great vessels (judge/validity.cpp asks outside of
// this range), else the first in which the program takes them at all.
Units guessed_units(const std::vector<double>& radii, std::string& reason) {
  for (const auto& [least, most] : {std::pair(1.5e-3, 20e-3), std::pair(0.5e-3, 50e-3)})
    for (const char* name : {"mm", "cm", "m"}) {
      const Units units = units_named(name);
      if (std::any_of(radii.begin(), radii.end(), [&, least = least, most = most](double r) {
            return r * units.metres < least || r * units.metres > most;
          }))
        continue;
      const auto [low, high] = std::minmax_element(radii.begin(), radii.end());
      reason =
          "in " + units.length + " the radii are " + number_text(*low * units.metres * 1e3, 2) +
          (radii.size() > 1 ? " to " + number_text(*high * units.metres * 1e3, 2) : "") + " mm";
      return units;
    }
  reason = "the radii fit no unit";
  return units_named("mm");
}

// An edge length for a surface that is too coarse or too irregular to be cut cleanly.
std::optional<double> remeshing(const TriangleSurface& surface, double radius,
                                std::string& reason) {
  constexpr double fewest_around = 20, wanted_around = 48, thin = 15, most_thin = 0.005;
  int slivers = 0;
  for (Eigen::Index t = 0; t < surface.triangles.rows(); ++t) {
    double smallest = 180;
    for (int k = 0; k < 3; ++k) {
      const Vec3 at = surface.points.row(surface.triangles(t, k)),
                 b = Vec3(surface.points.row(surface.triangles(t, (k + 1) % 3))) - at,
                 c = Vec3(surface.points.row(surface.triangles(t, (k + 2) % 3))) - at;
      smallest = std::min(smallest, std::atan2(b.cross(c).norm(), b.dot(c)) * 180 / M_PI);
    }
    slivers += smallest < thin ? 1 : 0;
  }
  const double around = 2 * M_PI * radius / mean_edge_length(surface);
  const double share = static_cast<double>(slivers) / static_cast<double>(surface.triangles.rows());
  if (around >= fewest_around && share <= most_thin) return std::nullopt;
  reason = share > most_thin ? number_text(100 * share, 2) +
                                   " % of the file's triangles have an angle below 15 "
                                   "degrees"
                             : "the file has about " + number_text(around, 2) + " edges around";
  return std::stod(number_text(2 * M_PI * radius / wanted_around, 2));
}

// The surface's path from the scene's folder: as it was given where it lies below that folder, else
// with links followed, as `..` does not go back through a link.
std::string relative_to(const std::filesystem::path& scene, const std::filesystem::path& surface) {
  std::error_code error;
  const auto folder = std::filesystem::absolute(scene, error).lexically_normal().parent_path();
  const auto file = std::filesystem::absolute(surface, error).lexically_normal();
  const auto below = file.lexically_relative(folder);
  if (!below.empty() && *below.begin() != "..") return below.generic_string();
  const auto beside = std::filesystem::proximate(file, folder, error);
  return error || beside.empty() ? file.generic_string() : beside.generic_string();
}

// Without the rounding errors of zero.
std::string place_of(const Vec3& point) {
  return place_text(point.unaryExpr([](double x) { return std::abs(x) < 1e-6 ? 0.0 : x; }), 4);
}

class Proposer {
 public:
  explicit Proposer(const ProposalRequest& request) : request_(request) {
    scene_.file = request.scene;
    scene_.name = scene_name(request.scene.stem().string());
  }

  Proposal propose() {
    for (const auto& surface : request_.surfaces) scene_.vessels.push_back(spec_of(surface));
    check_names(scene_.vessels);
    read();
    for (size_t v = 0; v < scene_.vessels.size(); ++v) add_vessel(v);
    add_operation();
    proposal_.decide.push_back("surface_is and wall of each vessel: the files say neither");
    proposal_.text = scene_text(scene_, vessels_, unit_reason_, keep_reason_);
    return std::move(proposal_);
  }

 private:
  void read() {
    std::vector<double> radii;
    for (VesselSpec& spec : scene_.vessels) {
      request_.progress("reading " + spec.surface->string());
      if (closed(spec)) spec.role = Role::obstacle;
      prepared_.push_back(read_vessel(spec, scene_));
      if (spec.role == Role::deformable)
        radii.push_back(typical_radius(prepared_.back().vessel.surface));
    }
    check_spaces();
    if (radii.empty())
      throw InputError(request_.surfaces.front().string() +
                       ": found a closed surface without an open end" +
                       (scene_.vessels.size() > 1 ? ", as all others are" : "") +
                       ", expected at least one vessel with two open ends");
    const StatedUnit stated = stated_unit();
    const bool guess = !request_.length_unit && stated.unit.empty();
    scene_.units = guess ? guessed_units(radii, unit_reason_)
                         : units_named(request_.length_unit.value_or(stated.unit));
    if (!guess) unit_reason_ = request_.length_unit ? "as --length-unit says" : stated.reason();
    for (size_t v = 0; v < scene_.vessels.size(); ++v) {
      scene_.vessels[v].check = true;
      if (scene_.vessels[v].role == Role::deformable)
        check_unit(scene_.vessels[v].surface->string(), prepared_[v].vessel.surface, scene_.units);
    }
    if (guess) {
      proposal_.decide.push_back("units: " + scene_.units.length + " is a guess, " + unit_reason_);
      unit_reason_ = "decide: " + unit_reason_;
    } else if (!stated.unit.empty() && stated.unit != scene_.units.length) {
      proposal_.decide.push_back("units: " + scene_.units.length + ", as --length-unit says, but " +
                                 stated.file + " says " + stated.unit);
    }
  }

  // The unit of length that the files state.
  struct StatedUnit {
    std::string unit,  // empty: none of them states one
        file;          // the first that does
    std::string reason() const { return "as " + file + " says"; }
  };

  StatedUnit stated_unit() const {
    StatedUnit first;
    for (const VesselSpec& spec : scene_.vessels) {
      if (spec.surface->extension() != ".vtp") continue;
      const std::string unit = units_in_vtp(*spec.surface);
      if (unit.empty()) continue;
      if (first.unit.empty()) first = {unit, one_line(spec.surface->filename().string())};
      if (unit != first.unit && !request_.length_unit)
        throw InputError(spec.surface->string() + ": found lengths in " + unit +
                         " (Units in the file) where " + first.file + " has them in " + first.unit +
                         ", expected all surfaces in one unit");
    }
    return first;
  }

  // The scene would be refused (predict/predict.cpp).
  void check_spaces() const {
    const PreparedVessel* first = nullptr;
    for (const PreparedVessel& vessel : prepared_) {
      const std::string& space = vessel.loaded.space;
      if (space.empty()) continue;
      if (first == nullptr) first = &vessel;
      if (space != first->loaded.space)
        throw InputError(vessel.spec.surface->string() + ": found the space " + space +
                         " (SPACE in the file) where " + first->spec.surface->string() + " is in " +
                         first->loaded.space + ", expected all surfaces in one space");
    }
  }

  void add_vessel(size_t v) {
    VesselSpec& spec = scene_.vessels[v];
    ProposedVessel one;
    one.surface = relative_to(request_.scene, *spec.surface);
    if (spec.role == Role::obstacle) {
      proposal_.found.push_back(spec.name + ": closed, an obstacle");
      one.spec = spec;
      vessels_.push_back(std::move(one));
      return;
    }
    request_.progress("fitting " + spec.name);
    const double radius = typical_radius(prepared_[v].vessel.surface);
    spec.remesh = remeshing(prepared_[v].vessel.surface, radius, one.remesh_reason);
    if (spec.remesh) prepared_[v] = read_vessel(spec, scene_);
    one.kind = kind_of(spec.name);
    const double mm = 1e3 * scene_.units.metres;
    const ProposedWall wall = propose_wall(one.kind, radius, mm);
    one.wall_source = wall.source;
    spec.wall = Wall{wall.thickness, Material::isotropic(wall.young, wall.poisson)};
    prepared_[v].spec = spec;
    try {
      fit(prepared_[v]);
    } catch (const InputError& error) {
      throw InputError(spec.surface->string() + ": " + error.what());
    }
    one.spec = spec;
    one.vessel = prepared_[v].vessel;
    // Of the surface as it is, as `vasorod fit` shows them.
    for (double& r : one.vessel.rod.radius) r -= prepared_[v].mid_offset();
    for (size_t k = 0; k < one.vessel.ends.size(); ++k) {
      EndCondition end;
      end.vessel = spec.name;
      end.end = selector_of(one.vessel, static_cast<int>(k));
      end.hold = true;
      scene_.ends.push_back(end);
    }
    const auto [least, most] =
        std::minmax_element(one.vessel.rod.radius.begin(), one.vessel.rod.radius.end());
    proposal_.found.push_back(
        spec.name + ": " +
        (one.kind == VesselKind::other ? "a vessel, not recognised by its name"
                                       : to_string(one.kind) + ", by its name") +
        ", " + std::to_string(one.vessel.ends.size()) + " ends, radius " + number_text(*least, 3) +
        " to " + number_text(*most, 3) + " " + scene_.units.length + ", wall " +
        number_text(wall.thickness, 3) + " " + scene_.units.length + ", young " +
        number_text(wall.young, 3) + " MPa" +
        (spec.remesh ? ", remeshed to " + number_text(*spec.remesh, 3) : ""));
    vessels_.push_back(std::move(one));
  }

  // The one vessel of a kind, -1 where there is none or more than one.
  int only(VesselKind kind) const {
    int found = -1;
    for (size_t v = 0; v < vessels_.size(); ++v) {
      if (vessels_[v].kind != kind || vessels_[v].spec.role == Role::obstacle) continue;
      if (found >= 0) return -1;
      found = static_cast<int>(v);
    }
    return found;
  }

  void add_operation() {
    const int vein = only(VesselKind::superior_vena_cava),
              artery = only(VesselKind::pulmonary_artery);
    if (vein < 0 || artery < 0) {
      proposal_.decide.push_back(
          "surgery: none, as the files' names do not show one superior vena cava (svc) and one "
          "pulmonary artery (pa, rpa, pulmonary_artery)");
      return;
    }
    request_.progress("looking for a cut and an incision that fit");
    const PreparedVessel &svc = prepared_[index(vein)], &rpa = prepared_[index(artery)];
    const int kept = head_end(svc.vessel, rpa.vessel, svc.loaded.space);
    keep_reason_ = svc.loaded.space.empty()
                       ? "the head's end, taken to be the one farther from the artery's ends"
                       : "the head's end, the higher one in " + svc.loaded.space;
    const auto placed = place_operation(scene_, svc, rpa, kept);
    if (!placed) {
      proposal_.decide.push_back("surgery: no cut and incision were found that fit; add your own");
      return;
    }
    scene_.glenn = placed->spec;
    proposal_.found.push_back("operation: cut of " + svc.spec.name + " at " +
                              place_of(placed->report.cut.point) + ", incision of " +
                              number_text(placed->report.incision.length, 3) + " " +
                              scene_.units.length + " in " + rpa.spec.name + " at " +
                              place_of(placed->report.incision.pick) + ": built, and it fits");
    proposal_.decide.push_back("cut and incision: a first place that fits, not a recommendation");
    proposal_.decide.push_back("keep: " + keep_reason_);
  }

  const ProposalRequest& request_;
  Scene scene_;
  std::vector<PreparedVessel> prepared_;
  std::vector<ProposedVessel> vessels_;
  std::string unit_reason_, keep_reason_;
  Proposal proposal_;
};

}  // namespace

Proposal propose_scene(const ProposalRequest& request) {
  return Proposer(request).propose();
}

}  // namespace vasorod
