#include "bodies/body_problem.h"

#include <algorithm>

#include <vasorod/error.h>

namespace vasorod {

bool BodyProblem::may_meet() const {
  return std::any_of(contacts.begin(), contacts.end(),
                     [](const std::pair<int, int>& pair) { return pair.first != pair.second; });
}

void check_contacts(const BodyProblem& problem) {
  const int count = static_cast<int>(problem.bodies.size());
  for (const auto& [a, b] : problem.contacts)
    if (std::min(a, b) < 0 || std::max(a, b) >= count)
      throw InputError("contact: found bodies " + std::to_string(a) + " and " + std::to_string(b) +
                       ", expected 0 to " + std::to_string(count - 1));
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

std::vector<std::pair<int, int>> self_contacts(const std::vector<SurfaceBody>& bodies) {
  std::vector<std::pair<int, int>> pairs;
  for (int b = 0; b < static_cast<int>(bodies.size()); ++b)
    if (!bodies[static_cast<size_t>(b)].obstacle) pairs.emplace_back(b, b);
  return pairs;
}

}  // namespace vasorod
