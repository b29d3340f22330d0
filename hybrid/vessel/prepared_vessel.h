// A vessel of a scene, ready for the solvers: its surface is read, its rod is fitted and has the
// wall's stiffness.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <vasorod/scene.h>

#include "surface_file/read_surface.h"
#include "surface_file/remesh.h"
#include "vessel/vessel.h"

namespace vasorod {

/// A vessel of a scene, ready for the solvers.
struct PreparedVessel {
  VesselSpec spec;                     ///< the vessel in the scene
  LoadedSurface loaded;                ///< arrays and report; its surface has moved to `vessel`
  Vessel vessel;                       ///< an obstacle has only a surface; its rod is empty
  std::vector<double> node_thickness;  ///< wall thickness at each rod node, length
  /// Of the wall's prestress (wall/wall_energy.h), n x 3, length; empty: none.
  Points prestress_displacement;
  bool from_stress_free_shape = false;  ///< as in WallInput
  /// Its surface with other edges (predict/coarse_vessels.h); copies share it.
  std::shared_ptr<KeptRemesh> remeshed = std::make_shared<KeptRemesh>();

  bool obstacle() const { return spec.role == Role::obstacle; }
  double thickness() const { return spec.wall ? spec.wall->thickness : 0; }
  /// Distance from the given surface outwards to the wall's outer face, length: 0 if the surface is
  /// the outer face.
  double outer_offset() const;
  /// Distance from the given surface outwards to mid-wall, length: negative if the surface is the
  /// outer face.
  double mid_offset() const;
  /// Distance from the given surface inwards to the lumen, length: negative if the surface lies
  /// inside of it.
  double lumen_offset() const { return thickness() / 2 - mid_offset(); }
};

/// Reads the vessel's surface. Throws InputError.
PreparedVessel read_vessel(const VesselSpec& spec, const Scene& scene);

/// Fits a deformable vessel's rod, with mid-wall radii and section stiffness. Throws InputError.
void fit(PreparedVessel& vessel);

}  // namespace vasorod
