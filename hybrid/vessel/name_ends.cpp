#include "vessel/name_ends.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "data/index.h"

namespace vasorod {
namespace {

std::optional<int> whole_number(const std::string& text) {
  int value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || stop != text.data() + text.size() || value < 0 ||
      value > 2'000'000'000)
    return std::nullopt;
  return value;
}

}  // namespace

void name_ends(Vessel& vessel, const std::vector<Lid>& lids) {
  for (VesselEnd& end : vessel.ends) {
    double nearest = vessel.rod.radius[index(end.node)];
    for (const Lid& lid : lids)
      if (const double distance = (lid.center - end.center).norm(); distance <= nearest) {
        nearest = distance;
        end.face = lid.name;
      }
  }
}

EndSelector selector_of(const Vessel& vessel, int end) {
  const VesselEnd& here = vessel.ends[index(end)];
  EndSelector selector;
  const auto same = std::count_if(vessel.ends.begin(), vessel.ends.end(),
                                  [&](const VesselEnd& other) { return other.face == here.face; });
  // ModelFaceID is a whole number in every file of SimVascular; others are not taken.
  if (const auto face = whole_number(here.face); face && same == 1) {
    selector.kind = EndSelector::Kind::face;
    selector.face = *face;
  } else if (end == 0) {
    selector.kind = EndSelector::Kind::start;
  } else if (vessel.ends.size() == 2) {
    selector.kind = EndSelector::Kind::end;
  } else {
    selector.kind = EndSelector::Kind::near;
    const double step =
        1e-3 * std::pow(10, std::floor(std::log10(vessel.rod.radius[index(here.node)])));
    selector.near = here.center.unaryExpr([&](double x) { return std::round(x / step) * step; });
  }
  return selector;
}

}  // namespace vasorod
