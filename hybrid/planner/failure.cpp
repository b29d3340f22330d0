#include "planner/failure.h"

#include "data/sentence.h"
#include "planner/body.h"
#include "predict/cause.h"

namespace vasorod::planner {

Failure failure_now() {
  try {
    throw;
  } catch (const Refusal& error) {
    return {error.status, one_line(error.what())};
  } catch (...) {
    const Cause cause = cause_now();
    return {cause.kind == Cause::Kind::input ? 400 : 500, one_line(cause.sentence)};
  }
}

}  // namespace vasorod::planner
