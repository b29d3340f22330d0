// Where in a scene something was found, as the sentences for a user begin.
#pragma once

#include <string>

#include <vasorod/scene.h>

namespace vasorod {

/// "FILE:LINE", or "FILE" where the line is not known (0). A scene made in C++ has neither: then
/// `scene "NAME"`.
std::string place_in(const Scene& scene, int line = 0);

/// "FILE:LINE: vessel NAME: ", as far as known.
std::string place_of(const Scene& scene, const VesselSpec& vessel);

}  // namespace vasorod
