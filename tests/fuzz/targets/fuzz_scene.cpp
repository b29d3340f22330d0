// The input as a scene file, read and checked; no surface is opened.
#include <vasorod/read_scene.h>

#include "fuzz/targets/number_mutator.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vasorod;
  static const fuzz::fs::path file = fuzz::folder() / "scene.yaml";
  fuzz::write_file(file, fuzz::text_of(data, size));
  fuzz::accepted([] {
    const Scene scene = read_scene(file);
    if (scene.vessels.empty()) fuzz::finding("a scene without vessels");
  });
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  return vasorod::fuzz::mutate_scene(data, size, most, seed);
}
