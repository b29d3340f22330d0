// Brings a seam together along its way (SeamWay), for a vessel that has to fold on it.
//
// The walls start at rest, where nothing passes through anything. The offsets between the seam's
// vertices shrink in steps; at each the walls find a rough minimum with the contacts that are
// there. The next step starts from them: what is extrapolated from the last two crumples folds that
// are about to close, from where no minimisation finds back. A step that finds none is taken back
// and halved. Folds snap on the way, so that a state need not be near a minimum to go on from: it
// only must not be torn.
//
// Once the seam is closed, joined walls meet right up to it. What lies in each other there is
// brought apart in steps too (BodyContacts::allow): pushed out at once, the walls would be torn.
//
// Walls that are joined inflated (CoupledVessel::inflation) are let out in steps after that. They
// collapse on the way, so that contacts are searched often: a step ends with the first search that
// finds no walls in each other, and one that ends with walls in each other is taken back and
// halved.
#pragma once

#include <functional>
#include <string>

#include "coupled/coupled_path.h"

namespace vasorod {

/// One way of the seam of a CoupledStack, or only what comes after it.
class SeamClosing {
 public:
  /// CoupledMinimiserOptions::release_shift: walls that fold have indefinite Hessians.
  static constexpr double release_shift = 5;
  /// note() of walls that were let out.
  static constexpr const char* let_out_note =
      "the vessels were joined inflated, as the vein folds, and then let out";

  /// `stack` and `path` must outlive this; the path is at its start. `minimising`: options of all
  /// minimisations, of which tolerances and limits are chosen here. `count` is called after each.
  SeamClosing(CoupledStack& stack, CoupledPath& path, const CoupledMinimiserOptions& minimising,
              std::function<void(const CoupledMinimiserSummary&)> count);

  /// Goes to time 1, where joined walls then meet up to the seam. Returns `converged` there,
  /// `iteration_limit` where no step leads on, or `interrupted`.
  Status run();

  /// Of a closed seam: brings apart what lies in each other up to the seam, in a patch around it
  /// (CoupledStack::narrow()), as all else hardly moves; where that fails, with all of it. Returns
  /// as run() does.
  Status part();

  /// The same of a problem of which CoupledProblem::meet_up_to_seams was set only now: where this
  /// fails it is taken back, and the walls are where they were.
  Status part_or_stay();

  /// Of inflated walls: lets them out. Returns as run() does.
  Status let_out();

  /// A sentence for the certificate about the last of these; empty: none.
  const std::string& note() const { return note_; }
  double reached() const { return reached_; }  ///< the time of the last state that was found
  int steps() const { return steps_; }         ///< that were taken, without those taken back
  bool snapped() const { return snapped_; }    ///< a fold snapped on the way

 private:
  // How walls move between two searches of contacts: by less than an edge, or by many.
  enum class Walls { follow, collapse };
  // A rough minimum at the present offsets and pressures, in at most so many updates. Walls that
  // collapse come to rest in it or use the updates up, and must not cross.
  Status settle(int most_updates, Walls walls);
  Status follow_way();
  Status bring_apart();
  Status part_in_patch();
  void begin_again(const CoupledPath::Kept& kept);
  Status release();
  Points positions() const;

  CoupledStack& stack_;
  CoupledPath& path_;
  CoupledMinimiserOptions minimising_;
  std::function<void(const CoupledMinimiserSummary&)> count_;
  double reached_ = 0;
  int steps_ = 0;
  bool snapped_ = false;
  std::string note_;
};

}  // namespace vasorod
