// Two small result folders, one file of one of them replaced by the input: JSON replaces
// result.json, everything else the vessel's surface or its centerline. The input's bytes choose
// which file and which folder, so that an input costs one comparison.
#include <nlohmann/json.hpp>
#include <numeric>

#include <vasorod/compare.h>

#include "fuzz/targets/fuzz_input.h"
#include "result/example_result.h"
#include "result/write_vtp.h"

namespace {

using namespace vasorod;

struct Example {
  std::string json, surface, centerline;
  fuzz::fs::path a = fuzz::folder() / "a", b = fuzz::folder() / "b";

  Example() {
    Result result = test::example_result(6, 2);
    result.vessels.resize(1);
    result.balance.clear();
    result.contact.clear();
    result.metrics.clear();
    result.glenn.reset();
    VesselResult& vessel = result.vessels.front();
    vessel.centerline = test::centerline(5, 60, 5, 0.02, 0.01, 1.1);
    json = to_json(result);
    surface = vessel_vtp(vessel);
    centerline = centerline_vtp(*vessel.centerline);
    for (const fuzz::fs::path& folder : {a, b}) {
      fuzz::fs::create_directories(folder);
      fuzz::write_file(folder / "result.json", json);
      fuzz::write_file(folder / "svc.vtp", surface);
      fuzz::write_file(folder / "svc_centerline.vtp", centerline);
      fuzz::write_file(folder / "svc_stump.vtp", surface);
    }
    if (!fuzz::accepted([&] { compare_results(a, b); }))
      fuzz::finding("the example cannot be compared with itself");
  }
};

void compare(const fuzz::fs::path& a, const fuzz::fs::path& b) {
  fuzz::accepted([&] {
    const Comparison comparison = compare_results(a, b);
    if (comparison_table(comparison).empty()) fuzz::finding("an empty table");
    if (!nlohmann::json::accept(comparison_json(comparison))) fuzz::finding("what is no JSON");
  });
}

void compare_with(const Example& example, const std::string& name, std::string_view input,
                  const std::string& before, bool second) {
  fuzz::write_file(example.a / name, input);
  if (second)
    compare(example.b, example.a);
  else
    compare(example.a, example.b);
  fuzz::write_file(example.a / name, before);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Example example;
  const std::string_view input = fuzz::text_of(data, size);
  const unsigned sum = std::accumulate(data, data + size, 0U);
  const bool second = sum % 2 == 1;
  if (input.starts_with('{'))
    compare_with(example, "result.json", input, example.json, second);
  else if (sum / 2 % 2 == 1)
    compare_with(example, "svc.vtp", input, example.surface, second);
  else
    compare_with(example, "svc_centerline.vtp", input, example.centerline, second);
  return 0;
}
