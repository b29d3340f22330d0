// Scenes with other walls, pressures and picks: one sample of what is uncertain.
#pragma once

#include <string>
#include <vector>

#include <vasorod/scene.h>

#include "predict/fitted_vessels.h"

namespace vasorod {

/// The value below which this share (0 to 1) of the distribution lies: a factor or a length.
double value_at(const Uncertain& uncertain, double share);

/// One value for each uncertain quantity.
struct Sample {
  std::vector<double> values;  ///< in the order of VarySpec::uncertain
  std::string text;            ///< "young svc 1.07, cut -0.3"
};

/// The samples of a study: the same for all options.
std::vector<Sample> samples_of(const VarySpec& spec);

/// The scene with a sample's walls and pressures. Throws InputError where a material is impossible.
Scene with_sampled_walls(const Scene& scene, const VarySpec& spec, const Sample& sample);

/// The same with the sample's picks, which move along the vessels' axes; one that is a point first
/// becomes its place there. Throws InputError also where a pick leaves its axis.
Scene with_sample(const Scene& scene, const VarySpec& spec, const Sample& sample,
                  const FittedVessels& fitted);

/// The fitted vessels with the walls and pressures of a scene with the same surfaces.
FittedVessels with_walls(const FittedVessels& fitted, const Scene& scene);

}  // namespace vasorod
