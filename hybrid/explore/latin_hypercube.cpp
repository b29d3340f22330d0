#include "explore/latin_hypercube.h"

#include <cstdint>
#include <numeric>
#include <random>
#include <utility>

#include "data/index.h"

namespace vasorod {

std::vector<std::vector<double>> latin_hypercube(int samples, int dimensions, int seed) {
  // The distributions of the standard library differ between its makers; its generators do not.
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<std::vector<double>> points(index(samples), std::vector<double>(index(dimensions)));
  std::vector<int> strata(index(samples));
  for (std::size_t d = 0; d < index(dimensions); ++d) {
    std::iota(strata.begin(), strata.end(), 0);
    for (std::size_t k = strata.size(); k > 1; --k)
      std::swap(strata[k - 1],
                strata[static_cast<std::size_t>(uniform() * static_cast<double>(k))]);
    for (std::size_t s = 0; s < strata.size(); ++s)
      points[s][d] = (strata[s] + uniform()) / samples;
  }
  return points;
}

}  // namespace vasorod
