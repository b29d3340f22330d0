#include "app/ending.h"

#include <iostream>

#include "predict/cause.h"

namespace vasorod {

int say_failure(const std::string& program) {
  const Cause cause = cause_now();
  std::cerr << program << ": " << cause.sentence << std::endl;
  return cause.kind == Cause::Kind::stopped ? 1 : cause.kind == Cause::Kind::input ? 2 : 3;
}

}  // namespace vasorod
