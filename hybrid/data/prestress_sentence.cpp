#include "data/prestress_sentence.h"

#include "data/sentence.h"

namespace vasorod {
namespace {

// Over the radius: a displacement beyond this, mostly of a wall that bends, is rough all the same.
constexpr double largest_share = 0.1;

}  // namespace

std::optional<std::string> large_prestress(const std::string& vessel, double share,
                                           std::optional<int> steps) {
  const std::string begin = "prestress of " + vessel + ": ";
  if (steps > 0)
    return joined_text(begin, "its shape without stress, which is up to ",
                       number_text(100 * share, 2), " % of the radius away, was found in ", *steps,
                       " steps, as a linear displacement would be rough");
  if (steps)
    return begin +
           "its shape without stress was not found; it is that of a linear displacement, "
           "which is rough, though the shape as seen is in equilibrium with it";
  if (share <= largest_share) return std::nullopt;
  return joined_text(begin, "it is that of a linear displacement of up to ",
                     number_text(100 * share, 2),
                     " % of the radius; beyond 10 % this is rough, though the shape as seen is in "
                     "equilibrium with it");
}

}  // namespace vasorod
