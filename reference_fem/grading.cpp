#include "reference_fem/grading.h"

#include <cmath>

namespace vasorod::fem {

double Grading::cells(double x) const {
  return std::log1p(growth * x / smallest) / growth + x / largest;
}

std::vector<double> Grading::stations(double length, int count) const {
  std::vector<double> out{0};
  for (int k = 1; k < count; ++k) {
    const double wanted = cells(length) * k / count;
    double low = out.back(), high = length;  // `cells` increases
    for (int i = 0; i < 200 && low < high; ++i) {
      const double middle = 0.5 * (low + high);
      if (middle == low || middle == high) break;
      (cells(middle) < wanted ? low : high) = middle;
    }
    out.push_back(0.5 * (low + high));
  }
  out.push_back(length);
  return out;
}

}  // namespace vasorod::fem
