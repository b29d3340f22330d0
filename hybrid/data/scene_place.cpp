#include "data/scene_place.h"

#include "data/sentence.h"

namespace vasorod {

std::string place_in(const Scene& scene, int line) {
  if (scene.file.empty()) return "scene " + in_quotes(scene.name);
  return scene.file.string() + (line > 0 ? ":" + std::to_string(line) : "");
}

}  // namespace vasorod
