#include "rod/rod_tree.h"

#include "data/index.h"

namespace vasorod {

std::vector<char> leaves_fork(const RodTree& rod) {
  std::vector<char> leaves(rod.elements.size(), 0);
  for (const RodBranch& branch : rod.branches)
    if (branch.parent >= 0) leaves[index(branch.elements.front())] = 1;
  return leaves;
}

}  // namespace vasorod
