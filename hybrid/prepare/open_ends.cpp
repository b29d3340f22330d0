#include "prepare/open_ends.h"

#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "geometry/triangle_surface.h"
#include "prepare/find_caps.h"
#include "prepare/find_tips.h"
#include "prepare/in_mm.h"
#include "prepare/open_tip.h"
#include "prepare/repair.h"
#include "surface_file/check_surface.h"

namespace vasorod {
namespace {

// Lengths of branches over their radii from which a bulge is an end: a half ball has pi/2.
constexpr double shortest_branch = 1.8;
// For an end that was named, or of which another point was tried.
constexpr double shortest_bulge = 0.8;
// From a tip to its cut, over the radius: a tip on the rim of a cap across the axis loses about
// 1.3, one on the rim of a leaning cap up to 1.6. More takes off what belongs to the vessel.
constexpr double most_lost = 2;
// Radii of caps over the vessel's typical one. Smaller flats are dents and facets, larger ones
// sides.
constexpr double least_cap = 0.2, largest_cap = 2;

// "3.1,-4,12.5", as --end takes it.
std::string end_option(const Vec3& place) {
  const auto rounded = [](double x) { return number_text(std::round(10 * x) / 10, 5); };
  return "--end " + rounded(place.x()) + "," + rounded(place.y()) + "," + rounded(place.z());
}

class Opening {
 public:
  Opening(TriangleSurface& surface, const EndsToOpen& wanted)
      : surface_(surface), wanted_(wanted) {}

  OpenedEnds run() {
    if (wanted_.places.empty())
      open_all();
    else
      open_named();
    return std::move(out_);
  }

 private:
  std::vector<FlatCap> caps(bool named) const {
    const double radius = typical_radius(surface_);
    std::vector<FlatCap> all = find_caps(surface_, least_cap * radius, named);
    all.erase(std::remove_if(all.begin(), all.end(),
                             [&](const FlatCap& cap) { return cap.radius > largest_cap * radius; }),
              all.end());
    return all;
  }

  void open_all() {
    std::vector<FlatCap> ends;  // that may be, seen before openings cut sections open
    for (const FlatCap& cap : caps(false))
      if (may_end(cap)) ends.push_back(cap);
    open_tips(left_of(find_tips(surface_, shortest_branch)), most_lost);
    for (const FlatCap& cap : caps(false))
      if (!(cap.radius < wanted_.cut_branches_below && taken_off(cap)))
        opened(cap, surely_cut(cap));
    // What has no nearer section: find_tips again, as caps may have opened some.
    std::vector<Tip> closed =
        other_points(open_tips(left_of(find_tips(surface_, shortest_branch)), HUGE_VAL));
    for (const Tip& tip : closed)
      out_.warnings.push_back("the end at " + place_mm(tip.place) +
                              " stays closed: no section across it parts it from the rest");
    say_flat(closed, ends);
  }

  // Whether a branch may end at the cap: the lumen behind it is not much wider, nor is its other
  // side as near as that of a tube, 2.
  bool may_end(const FlatCap& cap) const {
    constexpr double side = 2.4;
    return depth_behind(surface_, cap) > side && !sections_behind_cap(surface_, cap, true).empty();
  }

  // Flat parts that are left, in one sentence. `ends`: those that were seen before.
  void say_flat(const std::vector<Tip>& closed, const std::vector<FlatCap>& ends) {
    std::string places, option;
    for (const Vec3& place : opened_at_) option += " " + end_option(place);
    for (const FlatCap& cap : caps(false)) {
      const auto at_cap = [&](const Vec3& place, double radii) {
        return (place - cap.center).norm() < radii * cap.radius;
      };
      const bool seen = std::any_of(ends.begin(), ends.end(),
                                    [&](const FlatCap& end) { return at_cap(end.center, 0.5); });
      const bool said = std::any_of(closed.begin(), closed.end(),
                                    [&](const Tip& tip) { return at_cap(tip.place, 1.5); });
      if (said || !(seen || may_end(cap))) continue;
      places += (places.empty() ? "" : ", ") + place_mm(cap.center) + " over a radius of " +
                in_mm(cap.radius);
      option += " " + end_option(cap.center);
    }
    if (!places.empty())
      out_.warnings.push_back("the wall is flat behind a rim, as over a closed end, at " + places +
                              ": where a branch ends there, name all ends," + option);
  }

  void open_named() {
    const std::vector<Tip> tips = find_tips(surface_, shortest_bulge);
    const std::vector<FlatCap> flat = caps(true), sure = caps(false);
    std::vector<Tip> chosen;
    std::vector<FlatCap> chosen_caps;
    for (const Vec3& place : wanted_.places) {
      const Tip* tip = nullptr;
      const FlatCap* cap = nullptr;
      std::string found;
      const auto name = [&](const Vec3& at) {
        found += (found.empty() ? "" : ", ") + place_mm(at);
      };
      for (const Tip& one : tips) {
        name(one.place);
        if (!tip || (one.place - place).norm() < (tip->place - place).norm()) tip = &one;
      }
      for (const FlatCap& one : sure)
        if (std::none_of(tips.begin(), tips.end(), [&](const Tip& other) {
              return (other.place - one.center).norm() < 1.5 * one.radius;
            }))
          name(one.center);
      for (const FlatCap& one : flat) {
        if (!cap || (one.center - place).norm() < (cap->center - place).norm()) cap = &one;
      }
      // A cap's centre is where a user points; a tip may lie on its rim.
      const bool on_cap = cap && (cap->center - place).norm() < cap->radius,
                 at_tip = tip && (tip->place - place).norm() < 3 * tip->radius;
      if (!on_cap && !at_tip)
        throw InputError("found no closed end within three radii of " + place_mm(place) +
                         ", expected " + (found.empty() ? "none, all are open" : found));
      const bool tip_of_cap =
          on_cap && at_tip && (tip->place - cap->center).norm() < 1.5 * cap->radius;
      if (at_tip && (!on_cap || tip_of_cap))
        chosen.push_back(*tip);
      else
        chosen_caps.push_back(*cap);
    }
    std::vector<Tip> closed;
    for (const Tip& tip : open_tips(left_of(chosen), most_lost)) {
      const auto cap = std::find_if(flat.begin(), flat.end(), [&](const FlatCap& one) {
        return (tip.place - one.center).norm() < 1.5 * one.radius;
      });
      if (cap == flat.end() || !opened(*cap, true)) closed.push_back(tip);
    }
    closed = other_points(open_tips(closed, HUGE_VAL));
    for (const FlatCap& cap : chosen_caps)
      if (!opened(cap, true)) closed.push_back({cap.center, 0, cap.radius});
    for (const Tip& tip : closed)
      out_.warnings.push_back("the end at " + place_mm(tip.place) +
                              " stays closed: no section across it parts it from the rest");
  }

  // Takes narrow branches off; returns the other tips.
  std::vector<Tip> left_of(const std::vector<Tip>& tips) {
    std::vector<Tip> left;
    for (const Tip& tip : tips) {
      const auto sections = sections_behind_tip(surface_, tip);
      if (sections.empty() || sections.front().radius >= wanted_.cut_branches_below ||
          !taken_off(tip, sections.front()))
        left.push_back(tip);
    }
    return left;
  }

  bool taken_off(const FlatCap& cap) {
    const auto sections = sections_behind_cap(surface_, cap, false);
    return !sections.empty() && taken_off({cap.center, 0, cap.radius}, sections.front());
  }

  bool taken_off(const Tip& tip, const FlatSection& section) {
    const FlatSection foot = foot_of_branch(surface_, section);
    if (!cut_tip(surface_, tip, foot)) return false;
    std::vector<std::vector<int>> stump;
    for (const auto& loop : boundary_loops(surface_.triangles)) {
      const Vec3 off = surface_.points.row(loop.front()).transpose() - foot.center;
      if (off.norm() < 3 * foot.radius && std::abs(off.dot(foot.normal)) < 0.05 * foot.radius)
        stump.push_back(loop);
    }
    fill_loops(surface_, stump);
    out_.done.push_back("branch of radius " + in_mm(section.radius) + " at " + place_mm(tip.place) +
                        " taken off, its stump closed");
    return true;
  }

  // Returns those that stay closed; with them those that would lose more than `lost` radii.
  std::vector<Tip> open_tips(const std::vector<Tip>& tips, double lost) {
    std::vector<Tip> closed;
    for (const Tip& tip : tips) {
      const auto sections = sections_behind_tip(surface_, tip);
      // Later sections are second choices, not nearer ones: without a first there is none.
      const bool near = !sections.empty() && (tip.place - sections.front().center).norm() <=
                                                 lost * sections.front().radius;
      const auto cut = std::find_if(sections.begin(), sections.end(), [&](const FlatSection& one) {
        return near && cut_tip(surface_, tip, one);
      });
      if (cut == sections.end()) {
        closed.push_back(tip);
        continue;
      }
      const double length = (tip.place - cut->center).norm();
      opened_at_.push_back(tip.place);
      out_.done.push_back("end opened at " + place_mm(cut->center) + ", " + in_mm(length) +
                          " from its tip");
      if (length > most_lost * cut->radius)
        out_.warnings.push_back("the end at " + place_mm(tip.place) + " lost " + in_mm(length) +
                                " of its length: no nearer section is closed across the axis; "
                                "segment it farther");
    }
    return closed;
  }

  // Of those that stay closed, other points of their caps, found from an end that was opened.
  std::vector<Tip> other_points(const std::vector<Tip>& tips) {
    std::vector<Tip> closed;
    for (const Tip& tip : tips) {
      const std::vector<Tip> others = find_tips(surface_, shortest_bulge);
      if (std::none_of(others.begin(), others.end(), [&](const Tip& other) {
            return (other.place - tip.place).norm() < 3 * std::min(tip.radius, other.radius) &&
                   open_tips({other}, HUGE_VAL).empty();
          }))
        closed.push_back(tip);
    }
    return closed;
  }

  bool opened(const FlatCap& cap, bool known) {
    for (const FlatSection& section : sections_behind_cap(surface_, cap, known)) {
      TriangleSurface whole = surface_;
      if (!cut_tip(surface_, {cap.center, 0, cap.radius}, section)) continue;
      // The cap and at most a radius of tube, which may lean.
      constexpr double most_area = 4;
      if (total_area(whole) - total_area(surface_) <
          most_area * M_PI * section.radius * section.radius) {
        out_.done.push_back("end opened at " + place_mm(section.center) + " along its flat cap, " +
                            in_mm((cap.center - section.center).dot(cap.normal)) + " behind it");
        opened_at_.push_back(cap.center);
        return true;
      }
      surface_ = std::move(whole);
    }
    return false;
  }

  TriangleSurface& surface_;
  const EndsToOpen& wanted_;
  std::vector<Vec3> opened_at_;  // outermost places of the ends that were opened
  OpenedEnds out_;
};

}  // namespace

OpenedEnds open_ends(TriangleSurface& surface, const EndsToOpen& wanted) {
  return Opening(surface, wanted).run();
}

}  // namespace vasorod
