#include "bodies/unmet_criteria.h"

#include "data/sentence.h"

namespace vasorod {

void UnmetCriteria::require(const std::string& what, double value, double tolerance) {
  if (value <= tolerance) return;
  add(what + " " + number_text(value, 3) + ", expected at most " + number_text(tolerance, 3));
}

std::string UnmetCriteria::sentence(const std::string& when) const {
  return "ended " + when + " without an equilibrium" + (list_.empty() ? "" : ": " + list_);
}

}  // namespace vasorod
