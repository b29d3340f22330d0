// How a rod's ending is named in a result.
#pragma once

#include "output/result.h"
#include "rod/newton.h"

namespace vasorod {

/// The result's status of the same name.
Status status_of(RodStatus status);

/// The worse of two: a whole is as good as its worst part, and the enumeration runs from good to bad.
Status worse(Status a, Status b);

}  // namespace vasorod
