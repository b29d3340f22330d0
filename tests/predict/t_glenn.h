// A vein along z joined to the upper side of an artery along x, made in C++.
#pragma once

#include "predict/small_scenes.h"

namespace vasorod::testing {

/// R = 6; the vein is cut at z = 20, and the artery's axis runs `aside` of the vein's, at z = 6.
inline Scene t_glenn(int around, double aside) {
  using Kind = EndSelector::Kind;
  Scene scene;
  scene.name = "t";
  VesselSpec artery = tube("artery", 60, {-30, aside, 6}, around);
  artery.tube->tangent = {1, 0, 0};
  artery.tube->normal = {0, 0, 1};
  scene.vessels = {tube("vein", 48, {0, 0, 0}, around), artery};
  scene.ends = {held("vein", Kind::start), held("vein", Kind::end), held("artery", Kind::start),
                held("artery", Kind::end)};
  GlennSpec& spec = scene.glenn.emplace();
  spec.svc = "vein";
  spec.rpa = "artery";
  spec.cut.point = Vec3(6, 0, 20);
  spec.incision.point = Vec3(0, aside, 12);
  spec.keep.kind = Kind::end;
  return scene;
}

}  // namespace vasorod::testing
