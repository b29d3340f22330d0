// A surface that cannot pass through itself: a barrier between its parts, and a bound on the steps
// of a minimisation.
//
// The contacts of self_contact.h look along normals and leave out what is near along the surface. A
// surface that crumples has creases, whose two sides are both. Here every vertex keeps its distance
// from every triangle, and every edge from every edge,
//
//   E = -kappa sum (d - r)^2 ln(d / r)   where d < r
//
// d is the distance of the two features, r a small share of an edge. Of features that are far
// from each other along a wall it is the distance of the faces that meet, so that the barrier is
// their contact. Steps end before a distance is
// zero, so that a surface which starts apart stays apart.
//
// Sources: Li et al., Incremental potential contact, 2020 (barrier); Li, Kaufman, Jiang,
// Codimensional incremental potential contact, 2021 (additive continuous collision detection).
#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "bodies/feature_distance.h"

namespace vasorod {

class NearOnSurface;

/// The wall whose surface is guarded: what is far along the surface stays apart by what lies
/// between it and the faces that meet.
struct GuardedWall {
  double inside = 0, outside = 0;  ///< from the surface to the wall's inner, outer face, length
  double along = 0;                ///< what is nearer along the edges than this is not far, length
};

/// The barrier of one surface. It keeps which features are near each other between calls.
class CrossingGuard {
 public:
  /// `reach`: r, length. `stiffness`: kappa, force / length. What is nearer than 1.5 r at rest is
  /// left out.
  CrossingGuard(const TriangleSurface& rest, double reach, double stiffness,
                std::optional<GuardedWall> wall = {});
  ~CrossingGuard();

  /// Looks at all of the surface in each search, not only at what has moved: where steps are dear
  /// beside a search, it is decided anew each time for the whole wall which faces meet.
  void search_all() { search_all_ = true; }

  /// What is near, and with which faces it meets, as it follows from the way so far.
  struct Memory;
  Memory memory() const;
  /// Goes on as from the moment of `memory`.
  void remember(Memory memory);

  /// The energy at p (n x 3), force * length; infinite where features meet.
  double energy(const Eigen::Ref<const Points>& p);
  /// gradient += dE/dp (n x 3); returns the energy.
  double gradient(const Eigen::Ref<const Points>& p, Eigen::Ref<Points> gradient);
  /// Appends the Hessian, both triangles, with `first` added to the vertices' numbers. With `blend`
  /// of 1 only its convex part; values between 0 and 1 interpolate.
  void hessian(const Eigen::Ref<const Points>& p, double blend, int first,
               std::vector<Eigen::Triplet<double>>& entries);
  /// Appends an upper bound of it as one entry for x, y and z.
  void bound(const Eigen::Ref<const Points>& p, int first,
             std::vector<Eigen::Triplet<double>>& entries);
  /// Smallest distance of faces of the wall that are far from each other along it, below 0 where
  /// they lie in each other; infinite where none are near, length.
  double smallest_gap(const Eigen::Ref<const Points>& p) const;
  /// The share of the step from `from` to `to`, in (0, 1], after which every distance is still a
  /// tenth of what it was; and no vertex moves by more than about a third of an edge. 0 where
  /// features are in each other already.
  double longest_step(const Eigen::Ref<const Points>& from, const Eigen::Ref<const Points>& to);

 private:
  struct Stencil {
    std::array<int, 4> at{};  // a vertex and its triangle, or two edges
    Features features = Features::two_edges;
    bool far = false;     // from each other along a wall
    double within = 0;    // what of the distance lies within walls, length
    double distance = 0;  // without that, where it was found
  };
  static bool nearer(const Stencil& a, const Stencil& b);
  // What is nearer than `reach`, faces of walls that are far from each other or surfaces; with
  // `moved` only that of which a vertex is marked.
  std::vector<Stencil> near(const Eigen::Ref<const Points>& p, double reach,
                            const std::vector<char>* moved = nullptr) const;
  double faces_between(const Eigen::Ref<const Points>& p, const Points& normals,
                       const Stencil& stencil) const;
  // What is nearer than r + margin_ with its faces, in the order of the distances.
  std::vector<Stencil> in_order(const Eigen::Ref<const Points>& p) const;
  std::vector<Stencil> in_order(std::vector<Stencil> found,
                                const Eigen::Ref<const Points>& now) const;
  void add_walls(const Eigen::Ref<const Points>& p, std::vector<Stencil>& found) const;
  void search(const Eigen::Ref<const Points>& p);
  // Calls take(stencil, corners, distance) for all within r.
  template <class Take>
  void within_reach(const Eigen::Ref<const Points>& p, Take&& take);
  double moved(const Eigen::Ref<const Points>& p) const;

  Triangles triangles_;
  std::vector<std::array<int, 2>> edges_;
  double reach_, stiffness_, margin_;
  std::array<double, 2> within_{};                // of walls that meet inside, outside
  std::unique_ptr<NearOnSurface> along_;          // none: everything is near
  std::vector<std::array<int, 4>> near_at_rest_;  // sorted
  bool search_all_ = false;
  // Everything nearer than r + margin_ at found_at_, where each vertex was when it was last
  // searched.
  std::vector<Stencil> found_;
  Points found_at_;
};

struct CrossingGuard::Memory {
  std::vector<Stencil> found;
  Points found_at;
};

}  // namespace vasorod
