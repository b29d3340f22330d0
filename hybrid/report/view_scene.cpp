#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "report/base64.h"
#include "report/camera.h"
#include "report/report_parts.h"
#include "report/report_pictures.h"

namespace vasorod {

namespace {

using Json = nlohmann::ordered_json;

template <class Number>
std::string base64_of(const std::vector<Number>& values) {
  return base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Number)});
}

// A part of the whole, 0 to 1.
std::uint16_t sixteen_bits(double part) {
  return static_cast<std::uint16_t>(std::clamp(part * 65535 + 0.5, 0.0, 65535.0));
}

// 16 bits per coordinate: a step is 1 / 65535 of the scene, far below a pixel.
std::string positions(const Points& points, const Vec3& low, double size) {
  std::vector<std::uint16_t> steps;
  steps.reserve(static_cast<std::size_t>(points.size()));
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double part = (points(i, k) - low[k]) / size;
      steps.push_back(sixteen_bits(std::isfinite(part) ? part : 0));
    }
  return base64_of(steps);
}

std::string levels(const Eigen::VectorXd& values, const ColourScale& scale) {
  std::vector<std::uint16_t> steps;
  steps.reserve(static_cast<std::size_t>(values.size()));
  for (const double value : values) {
    const double part = std::isfinite(value) ? (value - scale.low) / (scale.high - scale.low) : 0;
    steps.push_back(sixteen_bits(part));
  }
  return base64_of(steps);
}

Json row(const Eigen::Ref<const Eigen::RowVector3d>& value) {
  return {value.x(), value.y(), value.z()};
}

}  // namespace

std::string view_scene(const Result& result) {
  const std::vector<DrawnBody> bodies = drawn_bodies(result);
  constexpr double aspect = 16.0 / 9;
  const Camera camera = report_camera(result, bodies, aspect);
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  double reach = 0;
  for (const DrawnBody& body : bodies)
    for (const Points* points : {&body.rest, &body.current})
      for (Eigen::Index i = 0; i < points->rows(); ++i) {
        const Vec3 at = points->row(i).transpose();
        if (!at.allFinite()) continue;
        low = low.cwiseMin(at);
        high = high.cwiseMax(at);
        reach = std::max(reach, (at - camera.centre).norm());
      }
  if (!low.allFinite()) {
    low.setZero();
    high.setOnes();
  }
  const double size = std::max((high - low).maxCoeff(), std::numeric_limits<double>::min());
  Json scene = {
      {"low", row(low.transpose())}, {"size", size},     {"centre", row(camera.centre.transpose())},
      {"reach", 1.05 * reach},       {"aspect", aspect}, {"distance", camera.distance},
      {"half", camera.half_height}};
  scene["axes"] =
      Json::array({row(camera.axes.row(0)), row(camera.axes.row(1)), row(camera.axes.row(2))});
  scene["still"] = result.fit.has_value();
  const std::vector<DrawnField> fields = drawn_fields(result);
  scene["fields"] = Json::array();
  for (const DrawnField& field : fields) {
    Json ticks = Json::array();
    for (const double value : field.scale.ticks())
      ticks.push_back(Json::array({value, field.scale.text_at(value)}));
    const auto colours = colours_of(field.scale.map);
    scene["fields"].push_back(
        {{"title", field.scale.title},
         {"low", field.scale.low},
         {"high", field.scale.high},
         {"colours", std::vector<std::uint32_t>(colours.begin(), colours.end())},
         {"ticks", ticks}});
  }
  scene["vessels"] = Json::array();
  for (const DrawnBody& body : bodies) {
    const std::vector<std::uint32_t> triangles(body.triangles.data(),
                                               body.triangles.data() + body.triangles.size());
    Json added = {{"name", body.name},
                  {"glass", body.glass},
                  {"colour", {body.colour[0], body.colour[1], body.colour[2]}},
                  {"rest", positions(body.rest, low, size)},
                  {"current", positions(body.current, low, size)},
                  {"triangles", base64_of(triangles)}};
    added["fields"] = Json::array();
    for (const DrawnField& field : fields) {
      const Eigen::VectorXd* values = body.values(field);
      added["fields"].push_back(values ? Json(levels(*values, field.scale)) : Json(nullptr));
    }
    scene["vessels"].push_back(added);
  }
  std::string text = scene.dump(-1, ' ', true, Json::error_handler_t::replace);
  for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at))
    text.replace(at, 2, "<\\/");
  return text;
}

}  // namespace vasorod
