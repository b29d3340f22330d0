#include "report/draw_result.h"

#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/sentence.h"
#include "geometry/triangle_surface.h"
#include "report/annotations.h"
#include "report/camera.h"
#include "report/picture.h"
#include "report/report_pictures.h"
#include "report/solids.h"
#include "report/stripes.h"

namespace vasorod {

namespace {

constexpr float glass = 0.35F, pane = 0.25F;  // opacities: beside the vessels; around a rod
constexpr double legend = 0.2;                // of the width

struct Body {
  TriangleSurface surface;
  Colour colour{};
};

double mean_radius(const CenterlineResult& line) {
  if (!line.radius.empty()) {
    double sum = 0;
    for (const double radius : line.radius) sum += radius;
    return sum / static_cast<double>(line.radius.size());
  }
  return line.abscissa.empty()
             ? 1
             : 0.05 * *std::max_element(line.abscissa.begin(), line.abscissa.end());
}

// The rod as a thin dark tube; on about a dozen of its nodes d1 red, d2 green and d3 blue. The
// directors at rest are not stored, so the rest shape has none.
void add_rod(const CenterlineResult& line, bool rest, std::vector<Body>& bodies) {
  const Points& nodes = rest ? line.rest : line.current;
  const double radius = mean_radius(line);
  Body rod{{}, {0.16F, 0.20F, 0.30F}};
  std::array<Body, 3> directors{Body{{}, {0.80F, 0.16F, 0.16F}}, Body{{}, {0.13F, 0.55F, 0.20F}},
                                Body{{}, {0.15F, 0.30F, 0.80F}}};
  for (const std::vector<int>& run : line.lines) {
    for (std::size_t k = 0; k + 1 < run.size(); ++k) {
      const Vec3 a = nodes.row(run[k]), b = nodes.row(run[k + 1]);
      if (a != b) append(rod.surface, stick(a, b, 0.02 * radius));
    }
    if (rest) continue;
    const std::size_t step = std::max<std::size_t>(1, run.size() / 12);
    for (std::size_t k = 0; k < run.size(); k += step)
      for (int d = 0; d < 3; ++d) {
        const Vec3 at = nodes.row(run[k]),
                   tip = at + 0.75 * radius * line.directors[index(run[k])].col(d);
        append(directors[index(d)].surface, stick(at, tip, 0.04 * radius));
      }
  }
  bodies.push_back(std::move(rod));
  if (!rest) bodies.insert(bodies.end(), directors.begin(), directors.end());
}

void keep_only(const std::vector<std::string>& names, std::vector<DrawnBody>& bodies) {
  if (names.empty()) return;
  std::vector<std::string> known;
  for (const DrawnBody& body : bodies) known.push_back(body.name);
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError("found no vessel " + in_quotes(name) + " to draw, expected " +
                       listed(known));
  std::erase_if(bodies, [&](const DrawnBody& body) {
    return std::find(names.begin(), names.end(), body.name) == names.end();
  });
}

// The field that colours the picture, with the colours' range; empty: none was asked for.
std::optional<DrawnField> field_of(const Result& result, const DrawOptions& options) {
  if (options.colour == "vessel") {
    if (options.range)
      throw InputError("found a range of colours without a field, expected one with the colour " +
                       listed({"twist_shear", "axial_stretch", "contact_pressure"}));
    return std::nullopt;
  }
  for (DrawnField& field : drawn_fields(result)) {
    if (field.file != options.colour) continue;
    if (options.range) {
      field.scale.low = (*options.range)[0];
      field.scale.high = (*options.range)[1];
      if (!(field.scale.low < field.scale.high))
        throw InputError("found the range of colours from " + number_text(field.scale.low) +
                         " to " + number_text(field.scale.high) + ", expected a lower end first");
    }
    return field;
  }
  const std::vector<std::string> known = drawable_colours();
  if (std::find(known.begin(), known.end(), options.colour) != known.end())
    throw InputError("found the colour " + in_quotes(options.colour) +
                     ", which was not modelled in this result, expected the colour vessel");
  throw InputError("found the colour " + in_quotes(options.colour) + ", expected " + listed(known));
}

Vec3 direction(const std::optional<Vec3>& given, const Vec3& usual, const std::string& name) {
  if (given && !(given->norm() > 0))
    throw InputError("found the direction " + place_text(*given) + " of " + name +
                     ", expected one that is not zero");
  return given ? given->normalized() : usual;
}

// The whole scene's sides and distances, so that pictures of its parts match.
Camera camera_of(const Result& result, const std::vector<DrawnBody>& bodies,
                 const DrawOptions& options, double clear_right) {
  const View usual = report_view(result, bodies);
  const Vec3 towards_eye = direction(options.from, usual.towards_eye, "the eye"),
             up = direction(options.up, usual.up, "what is up");
  std::vector<Seen> scene;
  for (const DrawnBody& body : bodies)
    scene.push_back({options.rest ? &body.rest : &body.current, body.wanted});
  Camera camera =
      fit_camera(scene, towards_eye, up, double(options.size[0]) / options.size[1], clear_right);
  if (options.centre) camera.centre = *options.centre;
  if (options.height) camera.half_height = 0.5 * *options.height;
  return camera;
}

}  // namespace

std::vector<std::string> drawable_colours() {
  return {"vessel", "twist_shear", "axial_stretch", "contact_pressure"};
}

std::string draw_result(const Result& result, const DrawOptions& options) {
  std::vector<DrawnBody> bodies = drawn_bodies(result);
  keep_only(options.only, bodies);
  if (std::none_of(bodies.begin(), bodies.end(), [](const auto& body) { return body.wanted; }))
    for (DrawnBody& body : bodies) body.wanted = true;
  const std::optional<DrawnField> field = field_of(result, options);
  if (field && options.stripes > 0)
    throw InputError("found stripes and the colour " + in_quotes(options.colour) +
                     ", expected the colour vessel with stripes");
  const Camera camera = camera_of(result, bodies, options, field ? legend : 0);

  std::vector<Body> more;
  for (const DrawnBody& body : bodies)
    if (options.rod && body.vessel && body.vessel->centerline)
      add_rod(*body.vessel->centerline, options.rest, more);
  constexpr double mark_size = 0.02;  // of the picture's height
  for (const Vec3& mark : options.marks)
    more.push_back({ball(mark, 2 * mark_size * camera.half_height), {0.85F, 0.10F, 0.10F}});

  // Blue on light grey.
  static const ColourScale painted{ColourMap::diverging, -1, 1, ""};
  std::vector<Eigen::VectorXd> paint(bodies.size());
  std::vector<DrawnSurface> drawn;
  for (const DrawnBody& body : bodies) {
    DrawnSurface& surface = drawn.emplace_back();
    surface.points = options.rest ? &body.rest : &body.current;
    surface.triangles = &body.triangles;
    surface.colour = body.colour;
    surface.mesh = options.mesh;
    surface.values = field ? body.values(*field) : nullptr;
    surface.scale = field ? &field->scale : nullptr;
    Eigen::VectorXd& own = paint[drawn.size() - 1];
    if (options.stripes > 0 && body.vessel) own = -stripes(*body.vessel, options.stripes);
    if (own.size() > 0) {
      surface.values = &own;
      surface.scale = &painted;
    }
    // A vessel drawn alone is what the picture is about, even one that stands beside others.
    const bool transparent = body.glass && options.only.size() != 1;
    surface.opacity = options.rod && body.vessel && body.vessel->centerline ? pane
                      : transparent                                         ? glass
                                                                            : 1;
  }
  for (const Body& body : more) {
    DrawnSurface& surface = drawn.emplace_back();
    surface.points = &body.surface.points;
    surface.triangles = &body.surface.triangles;
    surface.colour = body.colour;
  }
  const Drawing drawing(drawn, camera, options.size[0], options.size[1]);
  Picture picture = drawing.coloured(drawn);
  if (field) draw_colour_bar(picture, field->scale, field->found);
  if (options.lettering) {
    std::vector<std::string> names = labels_of(bodies);
    names.resize(drawn.size());
    FreeRoom room(picture);
    draw_scale_bar(picture, room, camera, result.length_unit);
    draw_orientation(picture, room, camera, space_of(result));
    draw_labels(picture, room, drawing.bodies(), names);
  }
  return png_bytes(picture);
}

}  // namespace vasorod
