#include "vessel/rod_status.h"

#include <algorithm>

namespace vasorod {

Status status_of(RodStatus status) {
  switch (status) {
    case RodStatus::converged:
      return Status::converged;
    case RodStatus::equilibrium_only:
      return Status::equilibrium_only;
    case RodStatus::unstable:
      return Status::unstable;
    case RodStatus::iteration_limit:
      return Status::iteration_limit;
    case RodStatus::interrupted:
      return Status::interrupted;
  }
  return Status::iteration_limit;
}

Status worse(Status a, Status b) {
  return std::max(a, b);
}

}  // namespace vasorod
