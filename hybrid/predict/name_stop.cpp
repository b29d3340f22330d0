#include "predict/name_stop.h"

#include "data/sentence.h"

namespace vasorod {

std::string time_limit_of(double seconds) {
  return "the time limit of " + number_text(seconds) + " s";
}

void name_stop(const std::string& by, const std::string& stage, Result& result) {
  if (result.status == Status::interrupted)
    result.certificate.notes.push_back(
        "stopped by " + by + " at " + in_quotes(stage) +
        ", before there was an equilibrium; this is the best state so far, expected more time or a "
        "cheaper fidelity");
  else if (!is_solution(result.status) || result.status == Status::self_intersecting)
    result.certificate.notes.push_back("the search for a better state was stopped by " + by +
                                       " at " + in_quotes(stage) +
                                       "; with more time another way may end well");
}

}  // namespace vasorod
