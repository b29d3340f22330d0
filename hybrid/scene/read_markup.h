// Reads points from a markups file of 3D Slicer (.mrk.json, schema 1.0).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// A control point of a markup.
struct MarkupPoint {
  std::string label;          ///< as Slicer shows it
  Vec3 point = Vec3::Zero();  ///< in `space`, mm
  std::string space;          ///< LPS or RAS
};

/// The placed control points of all markups in the file. A coordinate system is LPS, RAS or
/// Slicer's number of one of them (0: RAS, 1: LPS); without one it is LPS. Throws InputError (one
/// sentence with the file) for what is no such file, FileError if it cannot be read.
std::vector<MarkupPoint> read_markups(const std::filesystem::path& file);

}  // namespace vasorod
