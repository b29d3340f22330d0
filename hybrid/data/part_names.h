// Names after a vessel's, of what a result has beside the vessel itself. No vessel of a scene may
// have them.
#pragma once

#include <string>

namespace vasorod {

/// What the cut left of `vessel`: in contacts and crossings, and as a file with .vtp behind.
inline std::string stump_name(const std::string& vessel) {
  return vessel + "_stump";
}

/// The file of the rod, with .vtp behind.
inline std::string centerline_name(const std::string& vessel) {
  return vessel + "_centerline";
}

}  // namespace vasorod
