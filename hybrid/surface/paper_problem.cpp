#include "surface/paper_problem.h"

namespace vasorod {

std::string to_string(PaperStatus status) {
  switch (status) {
    case PaperStatus::converged:
      return "converged";
    case PaperStatus::unstable:
      return "unstable";
    case PaperStatus::iteration_limit:
      return "iteration_limit";
    case PaperStatus::interrupted:
      return "interrupted";
  }
  return "";
}

std::vector<std::pair<int, int>> all_contacts(const std::vector<SurfaceBody>& bodies) {
  std::vector<std::pair<int, int>> pairs;
  const int count = static_cast<int>(bodies.size());
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b)
      if (!bodies[static_cast<size_t>(a)].obstacle || !bodies[static_cast<size_t>(b)].obstacle)
        pairs.emplace_back(a, b);
  return pairs;
}

}  // namespace vasorod
