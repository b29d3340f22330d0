// What a start is like, from which a minimisation goes.
#pragma once

namespace vasorod {

enum class Roughness {
  near,    ///< near a minimum, where the Hessian is positive definite
  smooth,  ///< far from it, in a smooth shape, as a coarser mesh's minimum leads to
  rough    ///< neither
};

}  // namespace vasorod
