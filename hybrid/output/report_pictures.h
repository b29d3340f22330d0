// The pictures of a result: each stage of the operation, then what came out, coloured by each field; all from
// one place.
#pragma once

#include <string>
#include <vector>

#include "output/camera.h"
#include "output/colour_scale.h"
#include "output/result.h"

namespace vasorod {

struct NamedPicture {
  std::string file;    ///< picture_rest.png, ..., picture_twist_shear.png
  std::string title;   ///< what is seen
  bool field = false;  ///< coloured by a field, with its legend
  std::string png;     ///< bytes
  int width = 0, height = 0;
};

/// A field of a result with the scale that all its pictures and views share. The vectors are per vessel;
/// empty: not modelled.
struct DrawnField {
  std::string file;  ///< twist_shear, axial_stretch, contact_pressure
  ColourScale scale;
  double at_rest = 0;
  const Eigen::VectorXd VesselResult::*values = nullptr;
};

std::vector<DrawnField> drawn_fields(const Result& result);

/// A vessel's surface as it is drawn: its own, or a tube about the centerline where only that was asked for.
/// Row i of `rest` and of `current` is the same point of the wall.
struct DrawnShape {
  Points rest, current;
  Triangles triangles;
};
DrawnShape drawn_shape(const VesselResult& vessel);

/// Each vessel's colour: the operation's own two as veins are drawn, obstacles as arteries and heart are.
std::vector<Colour> vessel_colours(const Result& result);

/// Whether anything in the result may move; obstacles beside it are then drawn as glass.
bool has_deformable(const Result& result);

/// The camera of all pictures and of the view: what may move fills it, at rest and in the result.
Camera report_camera(const Result& result, const std::vector<DrawnShape>& shapes, double aspect,
                     double clear_right = 0);

/// Up to `threads` are drawn at once; the bytes do not depend on it.
std::vector<NamedPicture> report_pictures(const Result& result, int threads = 1);

}  // namespace vasorod
