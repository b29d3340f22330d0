// The way of a vein's mouth from where it was cut to its seam: at each time the shape of the vein's
// rod, and where each vertex of the mouth is to be beside the vertex that it will be joined to.
#pragma once

#include <cstddef>
#include <vector>

#include "predict/prediction.h"

namespace vasorod {

/// The way of a Glenn operation's mouth. Up to `lifted` the rod goes by equal shares of its strain
/// to a mouth that is lifted off the incision; then the mouth comes down, while its rim goes from
/// its section's shape to the incision's.
class JoiningPath {
 public:
  /// `prediction` must outlive this; its operation joins a vein's mouth to an incision.
  explicit JoiningPath(const Prediction& prediction);

  /// Whether the vessel with this index in Prediction::vessels is the vein.
  bool is_vein(std::size_t vessel) const { return vessel == vein_; }
  /// The vein's rod at time t.
  RodPoses vein(double t) const;
  /// Offset of each pair of the seam at time t, length: its first vertex less its second. Zero at
  /// time 1.
  std::vector<Vec3> offsets(double t) const;
  /// The step of the time in which no vertex of the mouth goes farther than a share of its radius.
  double step() const { return step_; }

 private:
  Points rim(const RodPoses& poses) const;
  Points incision() const;

  const Prediction& prediction_;
  std::size_t vein_, artery_;
  RodPoses lifted_;  // the rod at the time lifted_at_
  double lifted_at_ = 0, step_ = 1;
};

}  // namespace vasorod
