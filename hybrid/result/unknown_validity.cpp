#include "result/unknown_validity.h"

namespace vasorod {

std::optional<bool> known_range(const Result& result) {
  if (!is_solution(result.status) || result.fit) return std::nullopt;
  return result.validity.in_range;
}

std::string why_unknown(Status status) {
  if (is_solution(status)) return {};
  const std::string shown = "the numbers and fields are those of a state that is no solution";
  if (status == Status::unstable)
    return "the equilibrium is unstable, the vessels would leave it: validity is unknown, and " +
           shown;
  return "no equilibrium was found (" + to_string(status) + "): validity is unknown, and " + shown;
}

}  // namespace vasorod
