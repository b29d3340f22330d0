// The geometry of a result as the bytes of its files: VTK XML, appended binary, zlib; and
// ParaView's list of these files.
#pragma once

#include <string>

#include <vasorod/result.h>

namespace vasorod {

/// Type of VTK's XML format with which an input's own array is written: that of the input, else
/// Float64, or Int32 or Int64 by its values.
std::string written_type(const NamedArray& array);

/// What the field data of a file say about it, one text each. An empty text is left out.
struct FileStamp {
  std::string units,  ///< Units: "length mm, stress MPa"
      program,        ///< Program: name and version
      scene_hash,     ///< SceneHash: SHA-256 of the scene file
      space;          ///< SPACE: LPS or RAS, as 3D Slicer writes and reads it
};

/// The stamp of the files of one vessel of a result.
FileStamp stamp_of(const Result& result, const VesselResult& vessel);

/// NAME.vtp: the points where surgery left them, in the input's order. Arrays: RestPosition,
/// Displacement, AxialStretch (1 at rest), TwistShear and ContactPressure as Float64, then the
/// input's own arrays with their types. An input array with the name of one of ours is kept as
/// NAME_input.
std::string vessel_vtp(const VesselResult& vessel, const FileStamp& stamp = {});

/// NAME_centerline.vtp: the rod nodes in order, one polyline per branch. Arrays: Abscissas,
/// MaximumInscribedSphereRadius (where there is a surface), Director1..3, RestPosition, u, v, u0,
/// v0.
std::string centerline_vtp(const CenterlineResult& centerline, const FileStamp& stamp = {});

/// NAME_stump.vtp: points and triangles alone.
std::string surface_vtp(const TriangleSurface& surface, const FileStamp& stamp = {});

/// scene.pvd: every file of the result, one part each.
std::string scene_pvd(const Result& result);

}  // namespace vasorod
