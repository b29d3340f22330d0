// Solves the 45 degree bend with the given number of elements: `rod_instructions N SOLVES`. Under
// `valgrind --tool=callgrind`, the instruction count has no noise. SOLVES 0 counts the set-up
// alone.
#include <cstdio>
#include <cstdlib>

#include "../chain.h"

int main(int argc, char** argv) {
  using namespace vasorod;
  const int n = argc > 1 ? std::atoi(argv[1]) : 100, solves = argc > 2 ? std::atoi(argv[2]) : 1;
  const RodTree tree = bench::chain(25 * std::numbers::pi, {0, .01, 0}, n,
                                    bench::stiffness(5e6, 1e7, 1e7 / 12, 833333.3));
  int iterations = 0;
  for (int i = 0; i < solves; ++i)
    iterations = solve_rod(tree, bench::cantilever(tree, {0, 600, 0})).summary.iterations;
  std::printf("%d elements, %d iterations\n", n, iterations);
}
