// What a picture needs to be read without its caption: names with leaders, a scale bar, the
// patient's directions, and a close-up of a patch too small to be seen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/camera.h"
#include "report/free_room.h"
#include "report/picture.h"

namespace vasorod {

/// Names the bodies: each in empty room near its body, with a line to the nearest visible place of
/// it. `bodies`: per pixel, as Drawing::bodies gives them; `names`: per body, empty for none. A
/// body that is hardly visible, or whose name has no room, is left unnamed.
void draw_labels(Picture& picture, FreeRoom& room, const std::vector<int>& bodies,
                 const std::vector<std::string>& names);

/// A bar of a round length at the lower left, true at the depth of the camera's centre.
void draw_scale_bar(Picture& picture, FreeRoom& room, const Camera& camera,
                    const std::string& length_unit);

/// The patient's axes as they lie in the picture, with the letters R, L, A, P, S and I at their
/// ends, at the lower left. `space`: LPS or RAS; nothing is drawn otherwise. An axis that points
/// along the line of sight has no letters.
void draw_orientation(Picture& picture, FreeRoom& room, const Camera& camera,
                      const std::string& space);

/// A round length (1, 2 or 5 times a power of ten), at most `most`.
double round_length(double most);

/// A place of a picture that is worth a close-up.
struct Patch {
  Vec3 centre = Vec3::Zero();  ///< length unit
  double radius = 0;           ///< length unit
};

/// What differs from `at_rest` by more than a fiftieth of the scale, around the largest of it;
/// empty where it spans more than a fifth of the picture's height, or where nothing differs.
struct PatchSource {
  const Points* points = nullptr;
  const Eigen::VectorXd* values = nullptr;  ///< per point
};
std::optional<Patch> small_patch(const std::vector<PatchSource>& sources, const ColourScale& scale,
                                 double at_rest, const Camera& camera);

/// The camera of a patch's close-up in a square picture: the same direction.
Camera close_up(const Patch& patch, const Camera& camera);

/// Draws the close-up into the picture where least is hidden, framed, with a frame around its place
/// and both linked by a line. `inset` must be smaller than the picture.
void draw_inset(Picture& picture, FreeRoom& room, const Picture& inset, const Patch& patch,
                const Camera& camera);

}  // namespace vasorod
