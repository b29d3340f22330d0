// The bodies of a BodyProblem that are moved, joined or touched, as one PaperSystem. The system is
// built again when another body is touched. Scaled units (bodies/scaled_bodies.h).
#pragma once

#include <memory>
#include <vector>

#include "bodies/body_contacts.h"
#include "bodies/seam.h"
#include "bodies/seam_way.h"
#include "paper/paper_minimiser.h"
#include "paper/paper_solver.h"

namespace vasorod {

/// The problem in scaled units with its system, minimiser and contacts.
class PaperStack {
 public:
  /// `problem` and the others must outlive this; `bound` keeps the factor of the constant matrix.
  /// Throws InputError (one sentence) when the problem is invalid.
  PaperStack(const BodyProblem& problem, const PaperOptions& options, KeptFactor& bound,
             Work& work);
  PaperStack(const PaperStack&) = delete;  // the minimiser refers to the system
  PaperStack& operator=(const PaperStack&) = delete;

  bool any_modelled() const;
  /// Builds the system of the modelled bodies where they are now.
  void build();
  /// Adds bodies to the unknowns and builds the system again.
  void add(const std::vector<int>& touched);
  /// Numbers the contacts found last for the system.
  void stack_contacts();
  /// Sets the bodies' `now` from the positions.
  void unstack();
  /// Adds to the multipliers of the seam what its gaps ask for.
  void update_seams();
  double largest_seam_gap() const { return largest_gap(system.joins, positions); }

  /// Where the bodies are, and what their guards know there.
  struct State {
    std::vector<Points> now;                    ///< per body
    std::vector<CrossingGuard::Memory> guards;  ///< of those bodies that have one
  };
  State state() const;
  /// Builds the system where the bodies were then.
  void restore(const State& state);

  /// Contacts begin anew, as before walls met up to the seam.
  void renew_contacts();
  /// Moves all bodies to rest.
  void put_at_rest();
  /// Moves p' and the fixed vertices of the bodies, in the problem's units. Of the built system.
  void carry(const std::vector<CarriedBody>& carried);
  /// Places the seam's first vertices beside its second ones, length of the problem.
  void set_seam_offsets(const std::vector<Vec3>& offsets);

  const BodyProblem& problem;
  const PaperOptions& options;
  ScaledBodies scaled;
  std::unique_ptr<BodyContacts> contacts;
  double seam_radius = 0;  ///< of the mouth
  PaperSystem system;
  std::unique_ptr<PaperMinimiser> minimiser;
  StackedContacts stacked;
  std::vector<int> first;  ///< of each body in the stack, -1: not among the unknowns
  Points positions;        ///< the stack

 private:
  void place_seams();

  KeptFactor& bound_;
  Work& work_;
  std::vector<Vec3> seam_multipliers_, seam_offsets_;
  std::vector<std::shared_ptr<CrossingGuard>> guards_;  // per body
};

}  // namespace vasorod
