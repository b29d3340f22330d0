// The bodies and the fields of a result as pictures and the view draw them.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "data/mmhg.h"
#include "data/sentence.h"
#include "report/report_pictures.h"

namespace vasorod {

namespace {

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

// Reaches of the scales: the strain at which validity warns, since the laws of the wall part there;
// ten millimetres of mercury, about the pressure in the veins of a Glenn shunt.
constexpr double reach_of_strain = 0.2, reach_of_pressure_mmhg = 10;

// The extremes of a field in words.
std::string found_in(const std::vector<const Eigen::VectorXd*>& fields, const ColourScale& scale,
                     const std::string& stress_unit) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Eigen::VectorXd* field : fields)
    for (const double value : *field)
      if (std::isfinite(value)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
  if (!(low <= high)) return {};
  const auto text = [](double value) { return number_text(value, 3); };
  if (scale.map == ColourMap::sequential)
    return "largest: " + text(high * scale.shown_per) + ", " + text(high) + " " + stress_unit;
  return "here: " + text(low) + " to " + text(high);
}

bool any_values(const std::vector<const Eigen::VectorXd*>& fields) {
  return std::any_of(fields.begin(), fields.end(), [](const auto* f) { return f->size() > 0; });
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
  const double mmhg = mmhg_per(result.stress_unit);
  std::vector<DrawnField> drawn;
  const auto add = [&](const char* file, const char* array, const ColourScale& scale,
                       double at_rest, const Eigen::VectorXd VesselResult::*values) {
    if (any_values(fields_of(values)))
      drawn.push_back({file, array, scale, at_rest,
                       found_in(fields_of(values), scale, result.stress_unit), values});
  };
  add("twist_shear", "TwistShear",
      scale_for(ColourMap::diverging, "twist shear", shear, 0, reach_of_strain), 0,
      &VesselResult::twist_shear);
  add("axial_stretch", "AxialStretch",
      scale_for(ColourMap::diverging, "axial stretch", stretch, 1, reach_of_strain), 1,
      &VesselResult::axial_stretch);
  ColourScale pressures = scale_for(ColourMap::sequential, "contact pressure, mmHg", pressure, 0,
                                    reach_of_pressure_mmhg / mmhg);
  pressures.shown_per = mmhg;
  add("contact_pressure", "ContactPressure", pressures, 0, &VesselResult::contact_pressure);
  if (!is_solution(result.status))
    for (DrawnField& field : drawn) {
      field.scale.map = ColourMap::grey;
      field.scale.title += ", no solution";
      field.found.clear();
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

std::string space_of(const Result& result) {
  for (const VesselResult& vessel : result.vessels)
    if (!vessel.space.empty()) return vessel.space;
  return {};
}

std::vector<std::string> labels_of(const std::vector<DrawnBody>& bodies) {
  std::vector<std::string> labels;
  for (const DrawnBody& body : bodies)
    labels.push_back(body.vessel || body.name.ends_with(" stump") ? body.name : "");
  return labels;
}

}  // namespace vasorod
