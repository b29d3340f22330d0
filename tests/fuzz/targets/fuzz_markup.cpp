// The input as a markups file of 3D Slicer.
#include "fuzz/targets/fuzz_input.h"
#include "scene/read_markup.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vasorod;
  static const fuzz::fs::path file = fuzz::folder() / "picks.mrk.json";
  fuzz::write_file(file, fuzz::text_of(data, size));
  fuzz::accepted([] {
    for (const MarkupPoint& point : read_markups(file)) {
      if (!point.point.allFinite()) fuzz::finding("a point that is not finite");
      if (point.space != "LPS" && point.space != "RAS") fuzz::finding("an unknown space");
    }
  });
  return 0;
}
