// What `explore` asks for beyond the options that it lists: uncertainty carried through, and a
// search near the best.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <vasorod/read_scene.h>

#include "scene/field.h"

namespace vasorod {

/// A quantity of the scene that is not known exactly, with its distribution.
struct Uncertain {
  /// Which quantity. The first four are multiplied by a factor, the others are moved by a length.
  enum class What {
    young,      ///< all moduli of the wall
    poisson,    ///< both Poisson's ratios of the wall
    thickness,  ///< the wall's thickness
    pressure,   ///< the pressures of all vessels
    cut,        ///< the place of the cut, along the vein's axis from the kept end
    incision    ///< the place of the incision, along the artery's axis
  } what = What::young;
  std::string vessel;  ///< of a wall; empty: all deformable vessels, by one factor
  /// Uniform from `low` to `high`: factors, or length. Both 0: normal.
  double low = 0, high = 0;
  double sd = 0;  ///< of a normal one about 1 (factor) or 0 (length), cut off at 4 sd

  /// Whether it is a factor.
  bool scales() const { return what != What::cut && what != What::incision; }
};

/// The word in scene files.
std::string to_string(Uncertain::What what);

/// `vary:`
struct VarySpec {
  std::vector<Uncertain> uncertain;     ///< at least one
  int samples = 20;                     ///< for each option
  int best = 3;                         ///< number of options, the first of the ranking
  int seed = 1;                         ///< of the random numbers
  std::optional<std::string> fidelity;  ///< of the samples; empty: that of the last stage
};

/// `refine:`
struct RefineSpec {
  int evaluations = 20;  ///< at most, of new options
  int best = 1;          ///< number of options from which a search starts
};

/// The parts of `explore` that are no list of options.
struct Exploration {
  std::optional<VarySpec> vary;      ///< empty: none
  std::optional<RefineSpec> refine;  ///< empty: none
};

/// Reads `vary` and `refine` of the field `explore` of a scene. Throws InputError.
Exploration read_exploration(const Field& explore, const Scene& scene);

/// Those of a scene's file, which is read again; of a scene without a file, those of its YAML
/// `text`. None of a scene without explore, or without both.
Exploration read_exploration(const Scene& scene, const std::string& text = {});

}  // namespace vasorod
