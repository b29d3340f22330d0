// Refuses a scene that the memory cannot hold before hours are spent on it.
#pragma once

#include <new>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/scene.h>

#include "data/memory.h"

namespace vasorod {

/// A scene is larger than the memory; what() is one sentence.
class TooLarge : public std::bad_alloc {
 public:
  explicit TooLarge(std::string sentence) : sentence_(std::move(sentence)) {}
  const char* what() const noexcept override { return sentence_.c_str(); }

 private:
  std::string sentence_;
};

/// The least peak memory, bytes, of a vessel with so many vertices at a fidelity; of a bare rod
/// with so many elements. Programs' own fidelities count as skin.
double least_memory(const VesselSpec& vessel, const std::string& fidelity, double size);

/// The sizes that the scene states, one per vessel: vertices of generated tubes, elements of bare
/// rods; 0 for surfaces, which have to be read first.
std::vector<double> stated_sizes(const Scene& scene);

/// Throws TooLarge where vessels of these sizes (vertices, elements) need more than `limit`, bytes;
/// empty: unknown, nothing is refused. The need is a lower bound, so that nothing that fits is
/// refused.
void require_memory(const Scene& scene, const std::string& fidelity,
                    const std::vector<double>& sizes, std::optional<double> limit = memory_limit());

}  // namespace vasorod
