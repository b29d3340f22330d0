#include "predict/fidelity.h"

#include <algorithm>

#include "predict/fidelities/fidelities.h"

namespace vasorod {
namespace {

std::vector<Fidelity>& registry() {
  static std::vector<Fidelity> all = {
      {"rod", "the rods alone, no surface", false, false, solve_rod_only, LumenOf::rod},
      {"skin", "the rods, sections carried rigidly", true, true, solve_skin, LumenOf::rod},
      {"paper",
       "the rods, then the surfaces with the paper's energies, joining springs and contact", true,
       true, solve_paper_surfaces},
      {"section",
       "walls of vessels without branches as harmonics around and splines along; no surgery, no "
       "contact",
       true, false, solve_section, LumenOf::sections, false, true},
      {"coupled",
       "one minimum of walls, seams and contacts with stiffness from the walls' material", true,
       true, solve_coupled, LumenOf::wall, true, false, true},
  };
  return all;
}

}  // namespace

const std::vector<Fidelity>& fidelities() {
  return registry();
}

const Fidelity* find_fidelity(const std::string& name) {
  const auto& all = registry();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Fidelity& fidelity) { return fidelity.name == name; });
  return found == all.end() ? nullptr : &*found;
}

void register_fidelity(Fidelity fidelity) {
  registry().push_back(std::move(fidelity));
}

std::vector<std::string> fidelities_with_surgery() {
  std::vector<std::string> names;
  for (const Fidelity& fidelity : registry())
    if (fidelity.surgery) names.push_back(fidelity.name);
  return names;
}

std::vector<std::string> fidelity_names() {
  std::vector<std::string> names;
  for (const Fidelity& fidelity : registry()) names.push_back(fidelity.name);
  return names;
}

}  // namespace vasorod
