// Latin hypercube samples (McKay, Beckman and Conover 1979).
#pragma once

#include <vector>

namespace vasorod {

/// `samples` points in [0, 1)^dimensions: in each dimension every one of `samples` equal strata has
/// one point, at a random place in it, and the strata of the dimensions are paired at random. The
/// same numbers for the same seed on every machine (Mersenne Twister mt19937_64, 53 bits of each
/// draw).
std::vector<std::vector<double>> latin_hypercube(int samples, int dimensions, int seed);

}  // namespace vasorod
