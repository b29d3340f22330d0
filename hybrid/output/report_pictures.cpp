#include "output/report_pictures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cctype>
#include <cmath>
#include <functional>
#include <mutex>
#include <thread>

#include "output/camera.h"
#include "output/picture.h"

namespace vasorod {

namespace {

constexpr int stage_width = 640, stage_height = 480, field_width = 760, field_height = 540;
constexpr float glass = 0.35F, faint_glass = 0.22F;

std::string slug(const std::string& title) {
  std::string name;
  for (const char c : title) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name;
}

// A tube about the centerline, twelve points around each node; a bare rod has a hundredth of its length as
// radius.
DrawnShape tube_about(const CenterlineResult& line) {
  constexpr int around = 12;
  const auto nodes = line.current.rows();
  DrawnShape shape;
  shape.rest.resize(around * nodes, 3);
  shape.current.resize(around * nodes, 3);
  const double thin =
      line.abscissa.empty() ? 1 : 0.01 * *std::max_element(line.abscissa.begin(), line.abscissa.end());
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double radius = line.radius.empty() ? thin : line.radius[k];
    // The rest frame is not kept: a section across the rest line is enough for a picture.
    const Eigen::Index before = std::max<Eigen::Index>(i - 1, 0), after = std::min(i + 1, nodes - 1);
    const Vec3 along = line.rest.row(after) - line.rest.row(before);
    const Mat3 turn = Eigen::Quaterniond::FromTwoVectors(line.directors[k].col(2), along).toRotationMatrix();
    for (int j = 0; j < around; ++j) {
      const double angle = 2 * M_PI * j / around;
      const Vec3 spoke =
          radius * (std::cos(angle) * line.directors[k].col(0) + std::sin(angle) * line.directors[k].col(1));
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

// After an operation the kept end of the vena cava, the head's side, is up; else the longest axis lies level.
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

// The colour of a stage's surface: that of the vessel whose name it has or begins with (svc_stump).
std::size_t vessel_of(const Result& result, const std::string& name) {
  std::size_t best = result.vessels.size(), length = 0;
  for (std::size_t i = 0; i < result.vessels.size(); ++i) {
    const std::string& own = result.vessels[i].name;
    if (name.rfind(own, 0) == 0 && own.size() > length) {
      best = i;
      length = own.size();
    }
  }
  return best;
}

struct Task {
  NamedPicture* picture;
  std::function<Picture()> draw;
};

void draw_all(std::vector<Task>& tasks, int threads) {
  std::atomic<std::size_t> next{0};
  std::mutex encoding;  // VTK's object factories are not made for several threads
  const auto work = [&] {
    for (std::size_t k = next++; k < tasks.size(); k = next++) {
      const Picture picture = tasks[k].draw();
      const std::lock_guard<std::mutex> lock(encoding);
      tasks[k].picture->png = png_bytes(picture);
      tasks[k].picture->width = picture.width;
      tasks[k].picture->height = picture.height;
    }
  };
  std::vector<std::thread> others;
  for (int k = 1; k < std::min(threads, static_cast<int>(tasks.size())); ++k) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
}

}  // namespace

std::vector<DrawnField> drawn_fields(const Result& result) {
  const auto fields_of = [&](const Eigen::VectorXd VesselResult::*values) {
    std::vector<const Eigen::VectorXd*> fields;
    for (const VesselResult& vessel : result.vessels) fields.push_back(&(vessel.*values));
    return fields;
  };
  const auto shear = fields_of(&VesselResult::twist_shear), stretch = fields_of(&VesselResult::axial_stretch),
             pressure = fields_of(&VesselResult::contact_pressure);
  return {
      {"twist_shear", scale_for(ColourMap::diverging, "twist shear", shear), 0, &VesselResult::twist_shear},
      {"axial_stretch", scale_for(ColourMap::diverging, "axial stretch", stretch, 1), 1,
       &VesselResult::axial_stretch},
      {"contact_pressure",
       scale_for(ColourMap::sequential, "contact pressure, " + result.stress_unit, pressure), 0,
       &VesselResult::contact_pressure}};
}

DrawnShape drawn_shape(const VesselResult& vessel) {
  if (vessel.rest.rows() > 0) return {vessel.rest, vessel.current, vessel.triangles};
  if (vessel.centerline) return tube_about(*vessel.centerline);
  return {};
}

std::vector<Colour> vessel_colours(const Result& result) {
  static const std::vector<Colour> veins{{0.42F, 0.60F, 0.85F},
                                         {0.62F, 0.57F, 0.83F},
                                         {0.42F, 0.70F, 0.66F},
                                         {0.86F, 0.70F, 0.42F},
                                         {0.60F, 0.72F, 0.46F}};
  static const std::vector<Colour> arteries{
      {0.85F, 0.45F, 0.42F}, {0.78F, 0.56F, 0.50F}, {0.80F, 0.50F, 0.58F}};
  std::vector<Colour> colours;
  std::size_t obstacles = 0, others = result.glenn ? 2 : 0;
  for (const VesselResult& vessel : result.vessels) {
    if (vessel.obstacle)
      colours.push_back(arteries[obstacles++ % arteries.size()]);
    else if (result.glenn && vessel.name == result.glenn->svc)
      colours.push_back(veins[0]);
    else if (result.glenn && vessel.name == result.glenn->rpa)
      colours.push_back(veins[1]);
    else
      colours.push_back(veins[others++ % veins.size()]);
  }
  return colours;
}

bool has_deformable(const Result& result) {
  return std::any_of(result.vessels.begin(), result.vessels.end(),
                     [](const VesselResult& vessel) { return !vessel.obstacle; });
}

Camera report_camera(const Result& result, const std::vector<DrawnShape>& shapes, double aspect,
                     double clear_right) {
  std::vector<Seen> scene;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const bool wanted = !result.vessels[i].obstacle || !has_deformable(result);
    scene.push_back({&shapes[i].current, wanted});
    if (wanted) scene.push_back({&shapes[i].rest, wanted});
  }
  const Vec3 up = up_of(result, scene);
  return fit_camera(scene, clearest_direction(scene, up), up, aspect, clear_right);
}

std::vector<NamedPicture> report_pictures(const Result& result, int threads) {
  std::vector<DrawnShape> shapes;
  for (const VesselResult& vessel : result.vessels) shapes.push_back(drawn_shape(vessel));
  const std::vector<Colour> colours = vessel_colours(result);
  const bool glassy = has_deformable(result);
  const Camera stage_camera = report_camera(result, shapes, double(stage_width) / stage_height);
  const Camera field_camera = report_camera(result, shapes, double(field_width) / field_height, 0.2);

  std::vector<Stage> stages = result.stages;
  if (stages.empty()) {
    stages = {{"rest", {}, {}}, {"result", {}, {}}};
    for (std::size_t i = 0; i < shapes.size(); ++i)
      for (Stage& stage : stages) {
        stage.surfaces.push_back(
            {stage.title == "rest" ? shapes[i].rest : shapes[i].current, shapes[i].triangles});
        stage.names.push_back(result.vessels[i].name);
      }
  }
  const std::vector<DrawnField> fields = drawn_fields(result);
  std::vector<NamedPicture> pictures;
  for (const Stage& stage : stages)
    pictures.push_back({"picture_" + slug(stage.title) + ".png", stage.title, false, {}, 0, 0});
  for (const DrawnField& field : fields)
    pictures.push_back({"picture_" + field.file + ".png", field.scale.title, true, {}, 0, 0});

  std::vector<Task> tasks;
  for (std::size_t k = 0; k < stages.size(); ++k)
    tasks.push_back({&pictures[k], [&, k] {
                       const Stage& stage = stages[k];
                       std::vector<DrawnSurface> drawn;
                       for (std::size_t i = 0; i < stage.surfaces.size(); ++i) {
                         const std::size_t vessel =
                             vessel_of(result, i < stage.names.size() ? stage.names[i] : "");
                         DrawnSurface& surface = drawn.emplace_back();
                         surface.points = &stage.surfaces[i].points;
                         surface.triangles = &stage.surfaces[i].triangles;
                         if (vessel == result.vessels.size()) continue;
                         surface.colour = colours[vessel];
                         surface.opacity = result.vessels[vessel].obstacle && glassy ? glass : 1;
                       }
                       return render(drawn, stage_camera, stage_width, stage_height);
                     }});
  for (std::size_t k = 0; k < fields.size(); ++k)
    tasks.push_back({&pictures[stages.size() + k], [&, k] {
                       const DrawnField& field = fields[k];
                       std::vector<DrawnSurface> drawn;
                       for (std::size_t i = 0; i < shapes.size(); ++i) {
                         const VesselResult& vessel = result.vessels[i];
                         const Eigen::VectorXd& values = vessel.*field.values;
                         DrawnSurface& surface = drawn.emplace_back();
                         surface.points = &shapes[i].current;
                         surface.triangles = &shapes[i].triangles;
                         surface.opacity = vessel.obstacle && glassy ? faint_glass : 1;
                         if (values.size() != shapes[i].current.rows()) continue;
                         surface.values = &values;
                         surface.scale = &field.scale;
                         if (vessel.obstacle && glassy) surface.opacity = glass;
                       }
                       Picture picture = render(drawn, field_camera, field_width, field_height);
                       draw_colour_bar(picture, field.scale);
                       return picture;
                     }});
  draw_all(tasks, threads);
  return pictures;
}

}  // namespace vasorod
