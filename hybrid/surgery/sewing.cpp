#include "surgery/sewing.h"

#include "rod/binding.h"
#include "surgery/edited_vessel.h"

namespace vasorod {

Stage stage_of(const std::string& title, const PreparedVessel& first,
               const PreparedVessel& second) {
  return {
      title, {first.vessel.surface, second.vessel.surface}, {first.spec.name, second.spec.name}};
}

Points carried_rim(const PreparedVessel& vessel, const RodPoses& poses,
                   const std::vector<int>& rim) {
  const Points carried = carried_points(vessel.vessel.rod, poses, vessel.vessel.carry);
  Points points(static_cast<Eigen::Index>(rim.size()), 3);
  for (size_t k = 0; k < rim.size(); ++k)
    points.row(static_cast<Eigen::Index>(k)) = carried.row(rim[k]);
  return points;
}

void sew(const JoinOutcome& seam, PreparedVessel& first, PreparedVessel& second) {
  follow_edit(first, seam.first, seam.first_sources);
  follow_edit(second, seam.second, seam.second_sources);
  bind_again(first);
  bind_again(second);
}

}  // namespace vasorod
