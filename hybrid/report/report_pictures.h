// The pictures of a result: each stage of the operation, then the result coloured by each field.
// All look from one side, the stages of an operation from higher up. The contact pressure is shown
// from the side where most of it is visible.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <vasorod/result.h>

#include "report/camera.h"
#include "report/colour_scale.h"

namespace vasorod {

struct NamedPicture {
  std::string file;    ///< picture_rest.png, ..., picture_twist_shear.png
  std::string title;   ///< caption
  bool field = false;  ///< coloured by a field, with its legend
  std::string png;     ///< bytes
  int width = 0, height = 0;
};

/// A field of a result, with the scale that its picture and the view share.
struct DrawnField {
  std::string file,  ///< twist_shear, axial_stretch, contact_pressure
      array;         ///< its name in NAME.vtp
  ColourScale scale;
  double at_rest = 0;
  std::string found;  ///< the values of this result in words, for the legend
  const Eigen::VectorXd VesselResult::*values = nullptr;  ///< per vessel; empty: not modelled
};

/// The fields to draw that were modelled; none for `fit`. Their scales reach at least to a strain
/// of 0.2, where the laws of the wall end, and to 10 mmHg: what is harmless is pale. Fields of a
/// state that is no solution are grey and say so.
std::vector<DrawnField> drawn_fields(const Result& result);

/// A body of the view and of the pictures: a vessel's surface, a tube around the centerline where
/// there is no surface, a stump, or the axis of a fitted vessel. Row i of `rest` and of `current`
/// is the same point of the wall.
struct DrawnBody {
  std::string name;
  Points rest, current;
  Triangles triangles;
  Colour colour{};     ///< cool colours for the wanted bodies, warm ones for the others
  bool glass = false;  ///< drawn transparent
  /// What the pictures are about: the two vessels of an operation, else everything that may move.
  bool wanted = true;
  const VesselResult* vessel = nullptr;  ///< whose fields it carries; stumps and axes have none

  /// The field's values at the points, or null where it was not modelled.
  const Eigen::VectorXd* values(const DrawnField& field) const;
};

/// Refers to `result`, which must outlive it.
std::vector<DrawnBody> drawn_bodies(const Result& result);

/// From where a picture looks.
struct View {
  Vec3 towards_eye, up;
};

/// The space of the patient's coordinates, LPS or RAS; empty: no surface names one.
std::string space_of(const Result& result);

/// The names to write beside the bodies; none for the axes of a fit.
std::vector<std::string> labels_of(const std::vector<DrawnBody>& bodies);

/// The side from which the pictures of a result look: the bodies in the result are seen best, and
/// the seam of an operation with them.
View report_view(const Result& result, const std::vector<DrawnBody>& bodies);

/// The camera of the view and of the pictures of the result. The wanted bodies fill it, at rest and
/// in the result.
Camera report_camera(const Result& result, const std::vector<DrawnBody>& bodies, double aspect);

/// Draws up to `threads` pictures at once. The bytes do not depend on `threads`. `stop` is asked
/// before each, never by two threads at once; from then on pictures have no bytes. `width`: pixels
/// of every picture; 0: those of the page.
std::vector<NamedPicture> report_pictures(const Result& result, int threads = 1,
                                          const std::function<bool()>& stop = {}, int width = 0);

}  // namespace vasorod
