// The hybrid vessel: a triangle surface bound to its reference rod.
#pragma once

#include <string>
#include <vector>

#include <vasorod/types.h>

#include "rod/binding.h"
#include "rod/rod_tree.h"

namespace vasorod {

/// An open end of a vessel: a boundary loop of the surface, and the rod node of its section.
struct VesselEnd {
  std::vector<int> loop;         ///< vertex indices in order around the end
  Vec3 center = Vec3::Zero();    ///< centroid of the end's section, length
  Vec3 outward = Vec3::UnitZ();  ///< unit normal of the end's section, out of the vessel
  int node = 0;                  ///< rod node at this end: the tree's root or a branch's last node
  std::string face;              ///< ModelFaceID of the lid that closed it; empty: there was none
};

/// Geometry of a vessel: rest surface, fitted rod, binding. No material.
struct Vessel {
  TriangleSurface surface;     ///< at rest
  RodTree rod;                 ///< stiffness still zero; rest_strain = natural_strain
  std::vector<int> branch_of;  ///< branch index per vertex
  Binding binding;             ///< rod coordinates of the vertices [6]
  /// Rod coordinates by which the rod carries the vertices: `binding`, except beside forks
  /// (vessel/fork_reach.h), where the vertex lies outside the section that it follows.
  Binding carry;
  std::vector<VesselEnd> ends;  ///< ends[0] is `start`: its loop has the lowest point index
  double mean_radius = 0;       ///< mean of RodTree::radius by arc length, length
};

/// Options of fit_vessel.
struct FitOptions {
  double spacing = 0;  ///< rod element length over the local radius; 0: the default 0.25
};

/// Fits centerline, radii and rest rod with twist-free frames to an open tubular surface with two
/// or more ends, and binds the surface to the rod. Needs no seed points. Throws InputError (a
/// sentence with `name`) if the surface is not tubular.
Vessel fit_vessel(const std::string& name, const TriangleSurface& surface,
                  const FitOptions& options = {});

}  // namespace vasorod
