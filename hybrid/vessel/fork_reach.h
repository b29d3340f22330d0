// How far a fork reaches along its branches, and how a rod carries the wall there.
//
// Beside a fork the sections of one branch meet the wall of another: they are not closed, and their
// motions differ, so that a wall whose vertices each follow their own section would tear along the
// border. Within the reach a of the fork, all branches follow the node of the fork instead. From
// there to three reaches away, a branch catches up with its own sections:
//
//   p = M(s') p_rest,   s' = 0 up to a,   3/2 (s - a) up to 3 a,   s beyond
//
// with s the arc length of the vertex' section from the fork and M(s') the motion of the section at
// s'. The wall there takes 3/2 of the rod's strains. On a branch too short for that, s' catches up
// by the branch's other end, at most three times as fast; the reaches are shortened if that is not
// enough.
#pragma once

#include "vessel/vessel.h"

namespace vasorod {

/// Where an element lies: its branch, and the arc length from the branch's start to the element.
struct ElementPlace {
  size_t branch = 0;
  double start = 0;
};

/// One entry per element.
std::vector<ElementPlace> element_places(const RodTree& rod);

/// How far the forks at a branch's ends reach along it.
struct ForkReach {
  double length = 0;  ///< of the branch, at rest
  /// Arc length from the branch's start and from its end up to which triangles join its wall to
  /// that of another branch; 0 at open ends.
  double start = 0, end = 0;
  /// Whether the piece between these arc lengths comes within the reach of a fork.
  bool meets(double from, double to) const {
    return (start > 0 && from < start) || (end > 0 && to > length - end);
  }
};

/// One entry per branch.
std::vector<ForkReach> fork_reach(const Vessel& vessel);

/// Half width of the band of vertices that stands for the sections of one element, length: the
/// element's length, or 1.2 mean edges where that is more.
double section_band(const RodElement& element, double mean_edge);

/// Per element: whether the band of a section of it comes within the reach of a fork, where
/// sections are not tubes.
std::vector<char> fork_elements(const Vessel& vessel);

/// Branches, by number, that have no element outside fork_elements().
std::vector<size_t> branches_within_forks(const Vessel& vessel);

/// Sets `binding` and `carry` of the vessel from its surface, rod and branches. Throws InputError
/// as bind() does.
void bind_wall(Vessel& vessel);

}  // namespace vasorod
