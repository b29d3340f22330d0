#include "data/scene_place.h"

#include "data/sentence.h"

namespace vasorod {

std::string place_in(const Scene& scene, int line) {
  if (scene.file.empty()) return "scene " + in_quotes(scene.name);
  return scene.file.string() + (line > 0 ? ":" + std::to_string(line) : "");
}

std::string place_of(const Scene& scene, const VesselSpec& vessel) {
  return place_in(scene, vessel.line) + ": vessel " + vessel.name + ": ";
}

}  // namespace vasorod
