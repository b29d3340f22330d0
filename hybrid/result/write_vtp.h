// The geometry of a result as the bytes of its files: VTK XML, appended binary, zlib; and
// ParaView's list of them.
#pragma once

#include <string>

#include <vasorod/result.h>

namespace vasorod {

/// NAME.vtp: points where surgery left them, in the input's order; RestPosition, Displacement,
/// AxialStretch (1 at rest), TwistShear, ContactPressure as Float64, then the input's own arrays
/// with the type they had. An input array that has the name of one of ours is kept as NAME_input.
std::string vessel_vtp(const VesselResult& vessel);

/// NAME_centerline.vtp: rod nodes in order, one polyline per branch; Abscissas,
/// MaximumInscribedSphereRadius (where there is a surface), Director1..3, RestPosition, u, v, u0,
/// v0.
std::string centerline_vtp(const CenterlineResult& centerline);

/// NAME_stump.vtp: points and triangles alone.
std::string surface_vtp(const TriangleSurface& surface);

/// scene.pvd: every file of the result, one part each.
std::string scene_pvd(const Result& result);

}  // namespace vasorod
