// Names of options that change with everything their numbers depend on.
#pragma once

#include <map>
#include <string>

#include <vasorod/scene.h>

#include "explore/options.h"

namespace vasorod {

/// Names for the options of one scene.
class OptionNames {
 public:
  /// `inputs`: FittedVessels::inputs. Of a scene without Scene::text only they count.
  OptionNames(const Scene& scene, const std::map<std::string, std::string>& inputs);

  /// 16 hexadecimal digits: the first of the SHA-256 of the program's version, the scene without
  /// comments, folders of surfaces, `explore`, `fidelity`, `accuracy` and `study`, the hashes of
  /// its files, and the option's values. `sample`: what an uncertain sample changes; empty: none.
  std::string of(const Option& option, const std::string& sample = "") const;

 private:
  std::string common_;
};

}  // namespace vasorod
