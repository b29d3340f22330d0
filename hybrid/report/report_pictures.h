// The pictures of a result: each stage of the operation, then what came out, coloured by each
// field; all from one side; an operation's stages from higher up, the contact pressure from where
// most of it is seen.
#pragma once

#include <string>
#include <vector>

#include <vasorod/result.h>

#include "report/camera.h"
#include "report/colour_scale.h"

namespace vasorod {

struct NamedPicture {
  std::string file;    ///< picture_rest.png, ..., picture_twist_shear.png
  std::string title;   ///< what is seen
  bool field = false;  ///< coloured by a field, with its legend
  std::string png;     ///< bytes
  int width = 0, height = 0;
};

/// A field of a result with the scale that all its pictures and views share. The vectors are per
/// vessel; empty: not modelled.
struct DrawnField {
  std::string file;  ///< twist_shear, axial_stretch, contact_pressure
  ColourScale scale;
  double at_rest = 0;
  const Eigen::VectorXd VesselResult::*values = nullptr;
};

std::vector<DrawnField> drawn_fields(const Result& result);

/// A body of the view and of the pictures: a vessel's surface, a tube about the centerline where
/// only that was asked for, or a stump. Row i of `rest` and of `current` is the same point of the
/// wall.
struct DrawnBody {
  std::string name;
  Points rest, current;
  Triangles triangles;
  Colour colour{};     ///< what is wanted as veins are drawn, the rest as arteries and heart are
  bool glass = false;  ///< beside what is wanted: seen through
  bool wanted =
      true;  ///< what the pictures are about: an operation's two vessels, else what may move
  const VesselResult* vessel = nullptr;  ///< whose fields it carries; a stump has none

  /// The field's values at the points, or null where it was not modelled.
  const Eigen::VectorXd* values(const DrawnField& field) const;
};

/// Refers to `result`, which must outlive it.
std::vector<DrawnBody> drawn_bodies(const Result& result);

/// The camera of the pictures of the result and of the view: what may move fills it, at rest and in
/// the result.
Camera report_camera(const Result& result, const std::vector<DrawnBody>& bodies, double aspect);

/// Up to `threads` are drawn at once; the bytes do not depend on it.
std::vector<NamedPicture> report_pictures(const Result& result, int threads = 1);

}  // namespace vasorod
