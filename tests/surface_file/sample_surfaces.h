// Surfaces and files for the tests of the readers. VTK writes the files whose encoding matters.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <vasorod/named_array.h>
#include <vasorod/scene.h>
#include <vasorod/tube.h>
#include <vasorod/types.h>

class vtkXMLWriter;

namespace vasorod {

TubeSpec small_tube();  ///< length 40, radius 10 mm, 24 around, 20 strips
TriangleSurface sample_tube();
/// `sample_tube` with a fan over each of `ends` (0, 1). The fan's centre is `height` outside the
/// end's plane.
TriangleSurface closed_tube(const std::vector<int>& ends, double height);
TriangleSurface joined(const TriangleSurface& a, const TriangleSurface& b);

enum class Encoding { ascii, inline_binary, appended_raw, appended_base64, zlib };
void set_encoding(vtkXMLWriter& writer, Encoding encoding);
void write_vtp(const std::filesystem::path& file, const TriangleSurface& surface,
               Encoding encoding = Encoding::zlib, const std::vector<NamedArray>& point_arrays = {},
               const std::vector<NamedArray>& cell_arrays = {});
void write_stl(const std::filesystem::path& file, const TriangleSurface& surface, bool ascii);
void write_ply(const std::filesystem::path& file, const TriangleSurface& surface, bool ascii);
void write_obj(const std::filesystem::path& file, const TriangleSurface& surface);

/// A vessel with the surface `file`, in a scene in millimetres.
VesselSpec vessel_of(const std::filesystem::path& file);

}  // namespace vasorod
