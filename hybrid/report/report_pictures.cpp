#include "report/report_pictures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cctype>
#include <cmath>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "geometry/triangle_surface.h"
#include "report/camera.h"
#include "report/picture.h"

namespace vasorod {

namespace {

constexpr int stage_width = 640, stage_height = 480, field_width = 760, field_height = 540;
constexpr float glass = 0.35F, faint_glass = 0.22F;
constexpr const char* no_solution = ", no solution";  // behind the captions of such a state

std::string slug(const std::string& title) {
  std::string name;
  for (const char c : title) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return name;
}

// The centerline with at most `most_drawn` nodes: more cannot be told apart in a picture, and a rod
// may have a million.
CenterlineResult thinned(const CenterlineResult& line) {
  constexpr std::size_t most_drawn = 2000;
  const std::size_t nodes = line.abscissa.size();
  if (line.lines.size() != 1 || line.lines[0].size() != nodes || nodes <= most_drawn) return line;
  CenterlineResult thin;
  const std::size_t step = (nodes + most_drawn - 1) / most_drawn;
  std::vector<Eigen::Index> kept;
  for (std::size_t i = 0; i < nodes; i += step) kept.push_back(line.lines[0][i]);
  if (kept.back() != line.lines[0].back()) kept.push_back(line.lines[0].back());
  thin.rest = line.rest(kept, Eigen::all);
  thin.current = line.current(kept, Eigen::all);
  thin.lines.emplace_back();
  for (const Eigen::Index k : kept) {
    const auto i = static_cast<std::size_t>(k);
    thin.lines[0].push_back(static_cast<int>(thin.abscissa.size()));
    thin.abscissa.push_back(line.abscissa[i]);
    thin.directors.push_back(line.directors[i]);
    if (!line.radius.empty()) thin.radius.push_back(line.radius[i]);
  }
  return thin;
}

// A tube around the centerline, twelve points around each node. The radius of a bare rod is a
// hundredth of its length.
DrawnBody tube_about(const CenterlineResult& whole) {
  const CenterlineResult line = thinned(whole);
  constexpr int around = 12;
  const auto nodes = line.current.rows();
  DrawnBody shape;
  shape.rest.resize(around * nodes, 3);
  shape.current.resize(around * nodes, 3);
  const double thin = line.abscissa.empty()
                          ? 1
                          : 0.01 * *std::max_element(line.abscissa.begin(), line.abscissa.end());
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double radius = line.radius.empty() ? thin : line.radius[k];
    // The frames at rest are not stored; a section across the rest line is enough for a picture.
    const Eigen::Index before = std::max<Eigen::Index>(i - 1, 0),
                       after = std::min(i + 1, nodes - 1);
    const Vec3 along = line.rest.row(after) - line.rest.row(before);
    const Mat3 turn =
        Eigen::Quaterniond::FromTwoVectors(line.directors[k].col(2), along).toRotationMatrix();
    for (int j = 0; j < around; ++j) {
      const double angle = 2 * M_PI * j / around;
      const Vec3 spoke = radius * (std::cos(angle) * line.directors[k].col(0) +
                                   std::sin(angle) * line.directors[k].col(1));
      shape.current.row(around * i + j) = line.current.row(i) + spoke.transpose();
      shape.rest.row(around * i + j) = line.rest.row(i) + (turn * spoke).transpose();
    }
  }
  std::vector<Eigen::RowVector3i> triangles;
  for (const std::vector<int>& run : line.lines)
    for (std::size_t i = 0; i + 1 < run.size(); ++i)
      for (int j = 0; j < around; ++j) {
        const int a = around * run[i], b = around * run[i + 1], next = (j + 1) % around;
        triangles.emplace_back(a + j, a + next, b + j);
        triangles.emplace_back(a + next, b + next, b + j);
      }
  shape.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (Eigen::Index t = 0; t < shape.triangles.rows(); ++t)
    shape.triangles.row(t) = triangles[static_cast<std::size_t>(t)];
  return shape;
}

// The axis of a fitted vessel, as a thin dark tube inside its transparent wall.
DrawnBody axis_of(const VesselResult& vessel, const FitReport& fit) {
  CenterlineResult line = *vessel.centerline;
  line.radius.assign(line.radius.size(), 0.08 * fit.whole.mean_radius);
  DrawnBody body = tube_about(line);
  body.name = vessel.name + " axis";
  body.colour = {0.16F, 0.20F, 0.30F};
  return body;
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

// The stages of an operation are seen from above, because the incision lies on the recipient's
// upper side.
View stage_view(const Result& result, const View& common) {
  if (!result.glenn) return common;
  constexpr double lift = 0.8;  // of the level part
  const Vec3 level = common.towards_eye - common.towards_eye.dot(common.up) * common.up;
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

Picture stage_picture(const Stage& stage, const std::vector<DrawnBody>& bodies,
                      const Camera& camera) {
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
  return render(drawn, camera, stage_width, stage_height);
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
  FieldDrawing(const std::vector<DrawnBody>& bodies, const Camera& camera)
      : bodies_(bodies), camera_(camera) {}

  Picture picture(const DrawnField& field) {
    const std::vector<DrawnSurface> surfaces = in_colours_of(field, bodies_);
    std::call_once(once_, [&] { drawing_.emplace(surfaces, camera_, field_width, field_height); });
    Picture picture = drawing_->coloured(surfaces);
    draw_colour_bar(picture, field.scale);
    return picture;
  }

 private:
  const std::vector<DrawnBody>& bodies_;
  Camera camera_;
  std::once_flag once_;
  std::optional<Drawing> drawing_;
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

std::vector<DrawnField> drawn_fields(const Result& result) {
  if (result.fit) return {};
  const auto fields_of = [&](const Eigen::VectorXd VesselResult::*values) {
    std::vector<const Eigen::VectorXd*> fields;
    for (const VesselResult& vessel : result.vessels) fields.push_back(&(vessel.*values));
    return fields;
  };
  const auto shear = fields_of(&VesselResult::twist_shear),
             stretch = fields_of(&VesselResult::axial_stretch),
             pressure = fields_of(&VesselResult::contact_pressure);
  std::vector<DrawnField> drawn{
      {"twist_shear", scale_for(ColourMap::diverging, "twist shear", shear), 0,
       &VesselResult::twist_shear},
      {"axial_stretch", scale_for(ColourMap::diverging, "axial stretch", stretch, 1), 1,
       &VesselResult::axial_stretch},
      {"contact_pressure",
       scale_for(ColourMap::sequential, "contact pressure, " + result.stress_unit, pressure), 0,
       &VesselResult::contact_pressure}};
  if (!is_solution(result.status))
    for (DrawnField& field : drawn) {
      field.scale.map = ColourMap::grey;
      field.scale.title += no_solution;
    }
  return drawn;
}

const Eigen::VectorXd* DrawnBody::values(const DrawnField& field) const {
  if (!vessel) return nullptr;
  const Eigen::VectorXd& own = vessel->*field.values;
  return own.size() > 0 && own.size() == current.rows() ? &own : nullptr;
}

std::vector<DrawnBody> drawn_bodies(const Result& result) {
  static const std::vector<Colour> veins{{0.42F, 0.60F, 0.85F},
                                         {0.62F, 0.57F, 0.83F},
                                         {0.42F, 0.70F, 0.66F},
                                         {0.86F, 0.70F, 0.42F},
                                         {0.60F, 0.72F, 0.46F}};
  static const std::vector<Colour> arteries{
      {0.85F, 0.45F, 0.42F}, {0.78F, 0.56F, 0.50F}, {0.80F, 0.50F, 0.58F}};
  // An operation is about the two vessels it joins, other scenes about whatever may move.
  const auto joined = joined_vessels(result);
  const auto wanted = [&](const VesselResult& vessel) {
    return joined ? vessel.name == joined->names[0] || vessel.name == joined->names[1]
                  : !vessel.obstacle;
  };
  const bool any_wanted = std::any_of(result.vessels.begin(), result.vessels.end(), wanted);
  std::vector<DrawnBody> bodies;
  std::size_t beside = 0, others = 0;
  for (const VesselResult& vessel : result.vessels) {
    DrawnBody body;
    if (vessel.rest.rows() > 0) {
      body.rest = vessel.rest;
      body.current = vessel.current;
      body.triangles = vessel.triangles;
    } else if (vessel.centerline) {
      body = tube_about(*vessel.centerline);
    }
    body.name = vessel.name;
    body.vessel = &vessel;
    body.wanted = wanted(vessel) || !any_wanted;
    body.glass = !body.wanted || result.fit;
    if (!wanted(vessel))
      body.colour = arteries[beside++ % arteries.size()];
    else if (joined)
      body.colour = veins[vessel.name == joined->names[0] ? 0 : 1];
    else
      body.colour = veins[others++ % veins.size()];
    bodies.push_back(body);
    if (result.fit && vessel.centerline) bodies.push_back(axis_of(vessel, *result.fit));
    if (!vessel.stump) continue;
    DrawnBody& stump = bodies.emplace_back();
    stump.name = vessel.name + " stump";
    stump.rest = stump.current = vessel.stump->points;
    stump.triangles = vessel.stump->triangles;
    stump.colour = body.colour;
    stump.wanted = false;
    stump.glass = result.end_to_end.has_value();  // the other vessel lies where it was
  }
  return bodies;
}

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
  return {clearest_direction(scene, up), up};
}

Camera report_camera(const Result& result, const std::vector<DrawnBody>& bodies, double aspect) {
  return camera_from(report_view(result, bodies), bodies, aspect, 0);
}

std::vector<NamedPicture> report_pictures(const Result& result, int threads,
                                          const std::function<bool()>& stop) {
  const std::vector<DrawnBody> bodies = drawn_bodies(result);
  const std::vector<Stage> stages = stages_of(result, bodies);
  const std::vector<DrawnField> fields = drawn_fields(result);
  const View view = report_view(result, bodies), pressed = view_of_pressure(bodies, view);
  const bool turned = pressed.towards_eye != view.towards_eye;
  const auto field_camera = [&](const View& from) {
    return camera_from(from, bodies, double(field_width) / field_height, 0.2);
  };
  FieldDrawing common_drawing(bodies, field_camera(view)),
      pressure_drawing(bodies, field_camera(pressed));
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
    tasks.push_back(
        {&pictures[k], [&, k] { return stage_picture(stages[k], bodies, stage_camera); }});
  for (std::size_t k = 0; k < fields.size(); ++k)
    tasks.push_back({&pictures[stages.size() + k], [&, k] {
                       const bool own = turned && of_pressure(fields[k]);
                       return (own ? pressure_drawing : common_drawing).picture(fields[k]);
                     }});
  draw_all(tasks, threads, stop);
  return pictures;
}

}  // namespace vasorod
