#include "surgery/tilted_cut.h"

#include <Eigen/Geometry>
#include <cmath>
#include <set>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/sentence.h"

namespace vasorod {
namespace {

std::string found(double degrees) {
  return "cut_tilt_deg: found " + number_text(degrees);
}

class ObliqueCut {
 public:
  ObliqueCut(const TriangleSurface& surface, const std::vector<int>& branch_of, const Pose& section,
             const Vec3& axis, const Vec3& pick, const Vec3& keep_near)
      : surface_(surface),
        branch_of_(branch_of),
        section_(section),
        axis_(axis),
        pick_(pick),
        keep_near_(keep_near),
        branches_(branches_of(at(0))) {}

  // Throws InputError where the plane meets an end or a fork.
  CutOutcome operator()(double degrees) const {
    CutOutcome outcome = at(degrees);
    for (const int branch : branches_of(outcome))
      if (!branches_.contains(branch))
        throw InputError("cut at " + place_text(pick_) +
                         ": the section's plane runs into a fork of the vessel, expected a "
                         "section clear of its forks");
    return outcome;
  }

  // The largest number of whole degrees, with the sign of `degrees`, that can be cut.
  int largest(double degrees) const {
    const int sign = degrees < 0 ? -1 : 1;
    int possible = 0, impossible = static_cast<int>(std::ceil(std::abs(degrees)));
    while (impossible - possible > 1) {
      const int middle = (possible + impossible) / 2;
      (can(sign * middle) ? possible : impossible) = middle;
    }
    return sign * possible;
  }

 private:
  CutOutcome at(double degrees) const {
    return cut_vessel(surface_, tilted_section(section_, {degrees, axis_}), pick_, keep_near_);
  }

  bool can(double degrees) const {
    try {
      (*this)(degrees);
    } catch (const InputError&) {
      return false;
    }
    return true;
  }

  std::set<int> branches_of(const CutOutcome& outcome) const {
    std::set<int> branches;
    if (branch_of_.empty()) return branches;
    for (const int v : outcome.mouth)
      branches.insert(branch_of_[index(outcome.kept_sources[index(v)].dominant())]);
    return branches;
  }

  const TriangleSurface& surface_;
  const std::vector<int>& branch_of_;
  const Pose& section_;
  const Vec3 axis_, pick_, keep_near_;
  std::set<int> branches_;  // of the straight cut
};

}  // namespace

void check_tilt(double degrees) {
  if (!(std::abs(degrees) <= largest_tilt))
    throw InputError(found(degrees) + ", expected -75 to 75");
}

Pose tilted_section(const Pose& section, const CutTilt& tilt) {
  const Eigen::AngleAxisd turn(tilt.degrees * (M_PI / 180), tilt.axis.normalized());
  return {turn.toRotationMatrix() * section.rotation, section.position};
}

CutOutcome cut_obliquely(const TriangleSurface& surface, const std::vector<int>& branch_of,
                         const Pose& section, const CutTilt& tilt, const Vec3& pick,
                         const Vec3& keep_near) {
  check_tilt(tilt.degrees);
  const ObliqueCut cut(surface, branch_of, section, tilt.axis, pick, keep_near);
  try {
    return cut(tilt.degrees);
  } catch (const InputError& error) {
    throw InputError(found(tilt.degrees) + ", expected " +
                     (tilt.degrees < 0 ? "at least " : "at most ") +
                     std::to_string(cut.largest(tilt.degrees)) + " there: " + error.what());
  }
}

}  // namespace vasorod
