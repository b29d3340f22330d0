#include "coupled/wall_lumen.h"

#include <algorithm>
#include <utility>

#include "data/index.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

int section_at(const std::vector<HeldSection>& sections, int vertex) {
  for (size_t s = 0; s < sections.size(); ++s)
    if (std::find(sections[s].ring.begin(), sections[s].ring.end(), vertex) !=
        sections[s].ring.end())
      return static_cast<int>(s);
  return WallLumen::free_end;
}

}  // namespace

WallLumen wall_lumen(const WallInput& wall, const std::vector<HeldSection>& sections,
                     const std::vector<int>& seam, const LumenPressure& pressure) {
  std::vector<LumenFan> fans;
  WallLumen lumen;
  for (std::vector<int>& loop : boundary_loops(wall.rest.triangles)) {
    const auto first = seam.empty() ? loop.end() : std::find(loop.begin(), loop.end(), seam[0]);
    const bool joined = first != loop.end();
    if (joined) std::rotate(loop.begin(), first, loop.end());
    lumen.behind_fan.push_back(joined ? WallLumen::seam : section_at(sections, loop[0]));
    fans.push_back({std::move(loop), joined});
  }
  const Eigen::VectorXd depth = (wall.thickness / 2).array() - wall.mid_offset;
  lumen.volume = Lumen(wall.rest, depth, thinning_exponent(wall.material), std::move(fans));
  lumen.scan = pressure.scan;
  lumen.after = pressure.after;
  return lumen;
}

}  // namespace vasorod
