// Writes the result folder: result.json, vessels, centerlines, stumps, scene.pvd, pictures and
// report.html.
#pragma once

#include <filesystem>
#include <functional>

#include <vasorod/result.h>

namespace vasorod {

/// How a result folder is written.
struct WriteOptions {
  /// Called before each picture; may be empty. Once `patience` seconds have passed since it was
  /// first true, the pictures that remain are left out, and model.left_out says so.
  std::function<bool()> stop;
  double patience = 1;    ///< seconds
  bool report = true;     ///< false: no pictures and no report.html, numbers and VTP only
  int picture_width = 0;  ///< of every picture, pixels; 0: 640 and 760, for the page
};

/// Writes a result to `folder`. The folder must be absent, empty or an earlier result; it is
/// replaced as a whole by one rename. Sets seconds["write"] and adds it to seconds["total"], so
/// that later output agrees with result.json. Throws FileError if the folder cannot be replaced or
/// written (the old folder is then unchanged), InputError if the files of two vessels would have
/// the same name.
void write_result_folder(Result& result, const std::filesystem::path& folder,
                         const WriteOptions& options = {});

}  // namespace vasorod
