// Fits a rod to a generated tube with the installed library and prints its length.
#include <cstdio>

#include "geometry/tube.h"
#include "vessel/vessel.h"

int main() {
  vasorod::TubeSpec spec;
  spec.length = 100;
  spec.radius = 10;
  const auto vessel = vasorod::fit_vessel("tube", vasorod::tube_surface(spec));
  double length = 0;
  for (const auto& element : vessel.rod.elements) length += element.length;
  std::printf("length %.6f\n", length);
  return length > 99.99 && length < 100.01 ? 0 : 1;
}
