#include "explore/pattern_search.h"

#include <algorithm>
#include <utility>

namespace vasorod {
namespace {

constexpr double smallest_step = 1. / 32;

}  // namespace

PatternSearch::PatternSearch(std::vector<RefinedKey> keys, Option start, PickSpec incision)
    : keys_(std::move(keys)), centre_(std::move(start)), incision_(std::move(incision)) {
  std::erase_if(keys_, [&](const RefinedKey& key) { return !number_of(centre_, key.name); });
}

std::vector<Option> PatternSearch::poll() const {
  std::vector<Option> options;
  for (const RefinedKey& key : keys_) {
    const double here = number_of(centre_, key.name).value();
    for (const double sign : {1., -1.}) {
      const double to = std::clamp(here + sign * step_ * key.gap, key.low, key.high);
      if (to != here) options.push_back(with_number(centre_, key.name, to, incision_));
    }
  }
  return options;
}

void PatternSearch::go_on(bool better, const Option& centre) {
  centre_ = centre;
  if (!better) step_ /= 2;
}

bool PatternSearch::ended() const {
  return keys_.empty() || step_ < smallest_step;
}

}  // namespace vasorod
