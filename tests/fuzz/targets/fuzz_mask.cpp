// The input as a mask of `vasorod prepare`, in the format that its first bytes name; then the
// surface of its first label. A header may name voxels.raw, which lies beside the input.
#include "fuzz/targets/fuzz_input.h"
#include "mask/mask_surface.h"

namespace {

using namespace vasorod;

constexpr std::size_t most_voxels = 20000;  // of those whose surface is drawn

std::string ending_of(std::string_view input) {
  using namespace std::string_view_literals;
  if (input.starts_with("NRRD")) return ".nrrd";
  for (const std::string_view nifti : {"\x1f\x8b"sv, "\x5c\x01\0\0"sv, "\0\0\x01\x5c"sv})
    if (input.starts_with(nifti)) return ".nii";
  return ".mha";
}

void check(const Mask& mask) {
  const auto& [head, label, count] = mask;
  if (!head.origin.allFinite() || !head.step.allFinite())
    fuzz::finding("a place that is not finite");
  std::int64_t voxels = 1;
  for (const std::int64_t n : head.size) voxels *= n;
  if (static_cast<std::int64_t>(label.size()) != voxels) fuzz::finding("another number of voxels");
  std::int64_t labelled = 0;
  for (const auto& [value, of_it] : count) labelled += of_it;
  if (labelled > voxels) fuzz::finding("more labels than voxels");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool beside = [] {
    fuzz::write_file(fuzz::folder() / "voxels.raw", std::string(60, '\1'));
    return true;
  }();
  static_cast<void>(beside);
  const std::string_view input = fuzz::text_of(data, size);
  const fuzz::fs::path file = fuzz::folder() / ("mask" + ending_of(input));
  fuzz::write_file(file, input);
  fuzz::accepted([&] {
    const Mask mask = read_mask(file);
    check(mask);
    if (mask.label.size() > most_voxels) return;
    std::optional<int> label;
    if (!mask.count.empty()) label = mask.count.begin()->first;
    const MaskSurface drawn = mask_surface(file.string(), mask, label);
    const auto& [points, triangles] = drawn.surface;
    if (!points.allFinite()) fuzz::finding("a point that is not finite");
    if (triangles.rows() == 0) fuzz::finding("no triangle");
    if (triangles.minCoeff() < 0 || triangles.maxCoeff() >= points.rows())
      fuzz::finding("a triangle with a point that does not exist");
  });
  return 0;
}
