// A look at a scene file before it becomes a tree of values, so that none can hang the program,
// fill its memory or overflow its stack.
#pragma once

#include <string>
#include <yaml-cpp/yaml.h>

namespace vasorod {

/// `text`, the whole file, as one document; null where there is none. Throws InputError "FILE:LINE:
/// found X, expected Y" on control bytes, tabs in the indentation, what is not YAML, more than one
/// document, and lists or aliases nested or repeated beyond any scene.
YAML::Node parse_yaml(const std::string& file, const std::string& text);

}  // namespace vasorod
