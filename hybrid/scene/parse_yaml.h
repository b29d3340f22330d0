// Checks a scene file before yaml-cpp builds its tree, so that no file can hang the program,
// exhaust its memory or overflow its stack.
#pragma once

#include <string>
#include <yaml-cpp/yaml.h>

namespace vasorod {

/// Parses `text`, the whole file, as one document; null if there is none. Throws InputError
/// "FILE:LINE: found X, expected Y" ("line LINE: ..." where `file` is empty) on control bytes, tabs
/// in the indentation, invalid YAML, more than one document, and more nesting or more values
/// (aliases counted in full) than any scene has.
YAML::Node parse_yaml(const std::string& file, const std::string& text);

}  // namespace vasorod
