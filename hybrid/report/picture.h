// Pictures of triangle surfaces, drawn on the processor: no window system, no graphics card.
// Machines that round alike write the same bytes.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <vasorod/types.h>

#include "report/camera.h"
#include "report/colour_scale.h"

namespace vasorod {

/// Straight (not premultiplied) RGBA, 8 bits each, row by row from the top left.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// One body of a picture. It refers to its vectors, which must outlive the call.
struct DrawnSurface {
  const Points* points = nullptr;  ///< length unit
  const Triangles* triangles =
      nullptr;  ///< counter-clockwise seen from outside; inner faces are drawn darker
  Colour colour{0.8F, 0.8F, 0.8F};          ///< of the whole body if `values` is null
  float opacity = 1;                        ///< below 1: transparent, less so at the outline
  const Eigen::VectorXd* values = nullptr;  ///< per vertex, coloured by `scale`
  const ColourScale* scale = nullptr;
  bool mesh = false;  ///< draws the edges of the triangles
};

/// What is visible of bodies from one side. Their triangles are drawn once, and may then be
/// coloured in several ways.
class Drawing {
 public:
  /// Points, triangles, mesh and whether a body is transparent count here; the colours do not.
  Drawing(const std::vector<DrawnSurface>& surfaces, const Camera& camera, int width, int height);

  /// Per pixel, row by row, the body nearest to the eye, its place in `surfaces`; -1: none.
  std::vector<int> bodies() const;

  /// `surfaces`: those of the constructor in the colours and opacities to show; what was
  /// transparent stays so.
  Picture coloured(const std::vector<DrawnSurface>& surfaces) const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

/// A drawing in its own colours. Smooth shading by a light beside the viewer, 2 x 2 samples per
/// pixel, transparent background. A thin line marks depth jumps and the borders of solid bodies, so
/// that a closed slit is visible.
Picture render(const std::vector<DrawnSurface>& surfaces, const Camera& camera, int width,
               int height);

/// A legend at the right edge: the scale's colours, ticks and title; below it the sentence `found`
/// on the values of the picture.
void draw_colour_bar(Picture& picture, const ColourScale& scale, const std::string& found = {});

/// The picture as the bytes of a PNG file.
std::string png_bytes(const Picture& picture);

}  // namespace vasorod
