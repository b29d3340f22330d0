#include "report/report_pictures.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cmath>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "geometry/triangle_surface.h"
#include "report/annotations.h"
#include "report/camera.h"
#include "report/picture.h"

namespace vasorod {

namespace {

constexpr int stage_width = 640, stage_height = 480, field_width = 760, field_height = 540;
constexpr float glass = 0.35F, faint_glass = 0.22F;
constexpr const char* no_solution = ", no solution";  // behind the captions of such a state
constexpr double legend = 0.2;                        // of the width of a coloured picture

std::string slug(const std::string& title) {
  std::string name;
  for (const char c : title) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return name;
}

// After an operation, the kept end of the vena cava (the head's side) is up. Otherwise the longest
// axis is horizontal.
Vec3 up_of(const Result& result, const std::vector<Seen>& scene) {
  if (result.glenn)
    for (const VesselResult& vessel : result.vessels)
      if (vessel.name == result.glenn->svc && vessel.current.rows() > 0) {
        const Vec3 join = 0.5 * (result.glenn->incision.ends[0] + result.glenn->incision.ends[1]);
        const Vec3 up = vessel.current.colwise().mean().transpose() - join;
        if (up.norm() > 0) return up.normalized();
      }
  return level_up(scene);
}

// The points of the seam on the second vessel: those of its borders that lie on one of the first.
std::vector<Spot> seam_spots(const Result& result, const std::vector<DrawnBody>& bodies) {
  const auto joined = joined_vessels(result);
  if (!joined) return {};
  std::array<const DrawnBody*, 2> pair{};
  for (const DrawnBody& body : bodies)
    for (std::size_t k = 0; k < 2; ++k)
      if (body.vessel && body.vessel->rest.rows() > 0 && body.name == joined->names[k])
        pair[k] = &body;
  if (!pair[0] || !pair[1]) return {};
  const auto loops = boundary_loops(pair[0]->triangles),
             others = boundary_loops(pair[1]->triangles);
  const Points normals = vertex_normals({pair[1]->current, pair[1]->triangles});
  std::vector<Spot> spots;
  for (const std::vector<int>& other : others)
    for (std::size_t k = 0; k < other.size(); ++k) {
      const Vec3 at = pair[1]->current.row(other[k]),
                 next = pair[1]->current.row(other[(k + 1) % other.size()]);
      const double edge = (next - at).norm();
      const auto meets = [&](int vertex) {
        return (pair[0]->current.row(vertex).transpose() - at).norm() < edge;
      };
      if (std::any_of(loops.begin(), loops.end(), [&](const std::vector<int>& loop) {
            return std::any_of(loop.begin(), loop.end(), meets);
          }))
        spots.push_back({at, normals.row(other[k]), edge});
    }
  return spots;
}

// The stages of an operation are seen from above, because the incision lies on the recipient's
// upper side.
View stage_view(const Result& result, const View& common) {
  if (!result.glenn) return common;
  constexpr double lift = 0.8;  // of the level part
  const Vec3 level = common.towards_eye - common.towards_eye.dot(common.up) * common.up;
  if (common.towards_eye.dot(common.up) > lift * level.norm()) return common;
  return {(level.normalized() + lift * common.up).normalized(), common.up};
}

// The side from which most of the contact pressure on solid bodies is visible; transparent bodies
// hide nothing. `common` where nothing presses.
View view_of_pressure(const std::vector<DrawnBody>& bodies, const View& common) {
  std::vector<Seen> scene;
  std::vector<Spot> spots;
  for (const DrawnBody& body : bodies) {
    if (body.glass) continue;
    scene.push_back({&body.current, body.wanted});
    if (!body.vessel || body.vessel->contact_pressure.size() != body.current.rows()) continue;
    const Eigen::VectorXd& pressure = body.vessel->contact_pressure;
    if (!(pressure.maxCoeff() > 0)) continue;
    const Points normals = vertex_normals({body.current, body.triangles});
    for (Eigen::Index i = 0; i < pressure.size(); ++i)
      if (pressure[i] > 0) spots.push_back({body.current.row(i), normals.row(i), pressure[i]});
  }
  if (spots.empty()) return common;
  return {facing_direction(scene, spots, common.up), common.up};
}

// The body that gives a stage's surface its colour: the one whose name begins the surface's name
// (svc for svc_stump).
const DrawnBody* body_of(const std::vector<DrawnBody>& bodies, const std::string& name) {
  const DrawnBody* best = nullptr;
  for (const DrawnBody& body : bodies)
    if (name.rfind(body.name, 0) == 0 && (!best || body.name.size() > best->name.size()))
      best = &body;
  return best;
}

bool is_stump(const DrawnBody& body) {
  return body.vessel == nullptr;
}

// The recorded stages. Transparent bodies are added where a stage lacks them, and stumps from the
// cut on. Without recorded stages: rest and result. A fitted vessel has one stage, with its axis.
std::vector<Stage> stages_of(const Result& result, const std::vector<DrawnBody>& bodies) {
  if (!result.stages.empty() && !result.fit) {
    std::vector<Stage> stages = result.stages;
    for (Stage& stage : stages)
      for (const DrawnBody& body : bodies)
        if ((is_stump(body) ? stage.title != "rest" : body.glass) &&
            std::find(stage.names.begin(), stage.names.end(), body.name) == stage.names.end()) {
          stage.surfaces.push_back({body.rest, body.triangles});
          stage.names.resize(stage.surfaces.size() - 1);
          stage.names.push_back(body.name);
        }
    return stages;
  }
  std::vector<Stage> stages{{"rest", {}, {}}};
  if (!result.fit) stages.push_back({"result", {}, {}});
  for (const DrawnBody& body : bodies)
    for (Stage& stage : stages) {
      stage.surfaces.push_back({stage.title == "rest" ? body.rest : body.current, body.triangles});
      stage.names.push_back(body.name);
    }
  return stages;
}

// What every picture of a result has beside its bodies.
struct Lettering {
  std::string unit, space;  // of length; of the patient's coordinates
};

Picture stage_picture(const Stage& stage, const std::vector<DrawnBody>& bodies,
                      const Camera& camera, const Lettering& lettering, int width) {
  std::vector<DrawnSurface> drawn;
  for (std::size_t i = 0; i < stage.surfaces.size(); ++i) {
    DrawnSurface& surface = drawn.emplace_back();
    surface.points = &stage.surfaces[i].points;
    surface.triangles = &stage.surfaces[i].triangles;
    if (const DrawnBody* body = body_of(bodies, i < stage.names.size() ? stage.names[i] : "")) {
      surface.colour = body->colour;
      surface.opacity = body->glass ? glass : 1;
    }
  }
  const Drawing drawing(drawn, camera, width, width * stage_height / stage_width);
  Picture picture = drawing.coloured(drawn);
  std::vector<std::string> names = stage.names;
  names.resize(stage.surfaces.size());
  for (std::string& name : names)
    if (name.ends_with(" axis")) name.clear();
  FreeRoom room(picture);
  draw_scale_bar(picture, room, camera, lettering.unit);
  draw_orientation(picture, room, camera, lettering.space);
  draw_labels(picture, room, drawing.bodies(), names);
  return picture;
}

std::vector<DrawnSurface> in_colours_of(const DrawnField& field,
                                        const std::vector<DrawnBody>& bodies) {
  std::vector<DrawnSurface> drawn;
  for (const DrawnBody& body : bodies) {
    DrawnSurface& surface = drawn.emplace_back();
    surface.points = &body.current;
    surface.triangles = &body.triangles;
    surface.values = body.values(field);
    surface.scale = &field.scale;
    surface.opacity = !body.glass ? 1 : surface.values ? glass : faint_glass;
  }
  return drawn;
}

// The result from one side, drawn when the first field asks for it and shared by all that look from
// there.
class FieldDrawing {
 public:
  FieldDrawing(const std::vector<DrawnBody>& bodies, const Camera& camera, Lettering lettering,
               int width)
      : bodies_(bodies), camera_(camera), lettering_(std::move(lettering)), width_(width) {}

  Picture picture(const DrawnField& field) {
    const std::vector<DrawnSurface> surfaces = in_colours_of(field, bodies_);
    std::call_once(once_, [&] {
      drawing_.emplace(surfaces, camera_, width_, width_ * field_height / field_width);
      seen_ = drawing_->bodies();
    });
    Picture picture = drawing_->coloured(surfaces);
    draw_colour_bar(picture, field.scale, field.found);
    FreeRoom room(picture);
    draw_scale_bar(picture, room, camera_, lettering_.unit);
    draw_orientation(picture, room, camera_, lettering_.space);
    draw_labels(picture, room, seen_, labels_of(bodies_));
    add_inset(field, surfaces, picture, room);
    return picture;
  }

 private:
  void add_inset(const DrawnField& field, const std::vector<DrawnSurface>& surfaces,
                 Picture& picture, FreeRoom& room) const {
    if (field.scale.map == ColourMap::grey) return;
    std::vector<PatchSource> sources;
    for (const DrawnSurface& surface : surfaces)
      if (surface.values && surface.opacity >= 1)
        sources.push_back({surface.points, surface.values});
    const auto patch = small_patch(sources, field.scale, field.at_rest, camera_);
    if (!patch) return;
    const int side = picture.height / 3;
    draw_inset(picture, room, render(surfaces, close_up(*patch, camera_), side, side), *patch,
               camera_);
  }

  const std::vector<DrawnBody>& bodies_;
  Camera camera_;
  Lettering lettering_;
  int width_;
  std::once_flag once_;
  std::optional<Drawing> drawing_;
  std::vector<int> seen_;
};

struct Task {
  NamedPicture* picture;
  std::function<Picture()> draw;
};

void draw_all(std::vector<Task>& tasks, int threads, const std::function<bool()>& stop) {
  std::atomic<std::size_t> next{0};
  std::mutex encoding;  // VTK's object factories are not made for several threads
  std::mutex asking;
  const auto stopped = [&] {
    const std::lock_guard<std::mutex> lock(asking);
    return stop && stop();
  };
  const auto work = [&] {
    for (std::size_t k = next++; k < tasks.size() && !stopped(); k = next++) {
      const Picture picture = tasks[k].draw();
      const std::lock_guard<std::mutex> lock(encoding);
      tasks[k].picture->png = png_bytes(picture);
      tasks[k].picture->width = picture.width;
      tasks[k].picture->height = picture.height;
    }
  };
  std::vector<std::thread> others;
  for (int k = 1; k < std::min(threads, static_cast<int>(tasks.size())); ++k)
    others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
}

}  // namespace

namespace {

Camera camera_from(const View& view, const std::vector<DrawnBody>& bodies, double aspect,
                   double clear_right) {
  std::vector<Seen> scene;
  scene.reserve(bodies.size());
  for (const DrawnBody& body : bodies) {
    scene.push_back({&body.current, body.wanted});
    scene.push_back({&body.rest, body.wanted});
  }
  return fit_camera(scene, view.towards_eye, view.up, aspect, clear_right);
}

}  // namespace

View report_view(const Result& result, const std::vector<DrawnBody>& bodies) {
  std::vector<Seen> scene;
  scene.reserve(bodies.size());
  for (const DrawnBody& body : bodies) scene.push_back({&body.current, body.wanted});
  const Vec3 up = up_of(result, scene);
  return {clearest_direction(scene, seam_spots(result, bodies), up), up};
}

Camera report_camera(const Result& result, const std::vector<DrawnBody>& bodies, double aspect) {
  return camera_from(report_view(result, bodies), bodies, aspect, 0);
}

std::vector<NamedPicture> report_pictures(const Result& result, int threads,
                                          const std::function<bool()>& stop, int width) {
  const std::vector<DrawnBody> bodies = drawn_bodies(result);
  const std::vector<Stage> stages = stages_of(result, bodies);
  const std::vector<DrawnField> fields = drawn_fields(result);
  const View view = report_view(result, bodies), pressed = view_of_pressure(bodies, view);
  const bool turned = pressed.towards_eye != view.towards_eye;
  const auto field_camera = [&](const View& from) {
    return camera_from(from, bodies, double(field_width) / field_height, legend);
  };
  const Lettering lettering{result.length_unit, space_of(result)};
  const int stage_pixels = width > 0 ? width : stage_width,
            field_pixels = width > 0 ? width : field_width;
  FieldDrawing common_drawing(bodies, field_camera(view), lettering, field_pixels),
      pressure_drawing(bodies, field_camera(pressed), lettering, field_pixels);
  const auto of_pressure = [](const DrawnField& field) {
    return field.values == &VesselResult::contact_pressure;
  };
  // All stages in one frame, from the side where the result is seen best.
  std::vector<Seen> everything;
  for (const Stage& stage : stages)
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i) {
      const DrawnBody* body = body_of(bodies, i < stage.names.size() ? stage.names[i] : "");
      everything.push_back({&stage.surfaces[i].points, !body || body->wanted});
    }
  const View above = stage_view(result, view);
  const Camera stage_camera =
      fit_camera(everything, above.towards_eye, above.up, double(stage_width) / stage_height);

  std::vector<NamedPicture> pictures;
  for (const Stage& stage : stages) {
    const bool unsolved = stage.title == "result" && !is_solution(result.status);
    const std::string caption = stage.title + (unsolved ? no_solution : "");
    pictures.push_back({"picture_" + slug(stage.title) + ".png", caption, false, {}, 0, 0});
  }
  for (const DrawnField& field : fields) {
    const std::string caption =
        field.scale.title + (turned && of_pressure(field) ? ", from where most of it is seen" : "");
    pictures.push_back({"picture_" + field.file + ".png", caption, true, {}, 0, 0});
  }
  std::vector<Task> tasks;
  for (std::size_t k = 0; k < stages.size(); ++k)
    tasks.push_back({&pictures[k], [&, k] {
                       return stage_picture(stages[k], bodies, stage_camera, lettering,
                                            stage_pixels);
                     }});
  for (std::size_t k = 0; k < fields.size(); ++k)
    tasks.push_back({&pictures[stages.size() + k], [&, k] {
                       const bool own = turned && of_pressure(fields[k]);
                       return (own ? pressure_drawing : common_drawing).picture(fields[k]);
                     }});
  draw_all(tasks, threads, stop);
  return pictures;
}

}  // namespace vasorod
