// A wall as the contact searches of all its pairs ask it.
#pragma once

#include <memory>

#include <vasorod/types.h>

#include "geometry/closest_point.h"

namespace vasorod {

/// A wall at rest and where it moves. Copies are one wall.
class ContactWall {
 public:
  /// Throws InputError as ClosestPoint does.
  ContactWall(const TriangleSurface& rest);  // NOLINT(google-explicit-constructor)

  const TriangleSurface& rest() const;
  const ClosestPoint& at_rest() const;
  double mean_edge() const;              ///< at rest, length
  const Eigen::VectorXd& areas() const;  ///< vertex_areas() at rest

  /// The wall moved to where it is now (n x 3). Several threads may ask at once for the same place;
  /// the reference holds until another one is asked for.
  const ClosestPoint& now_at(const Points& points);
  /// The same of where its rod's sections carry it rigidly.
  const ClosestPoint& carried_to(const Points& points);

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace vasorod
