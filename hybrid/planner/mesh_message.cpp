#include "planner/mesh_message.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "data/index.h"
#include "data/part_names.h"
#include "report/report_pictures.h"

namespace vasorod::planner {
namespace {

static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");

template <class Number>
void append(std::string& bytes, Number number) {
  std::array<char, sizeof(Number)> raw{};
  std::memcpy(raw.data(), &number, sizeof(Number));
  bytes.append(raw.data(), raw.size());
}

}  // namespace

void MeshMessage::begin(const std::string& name, const char* type, int components,
                        Eigen::Index count) {
  arrays_.push_back({{"name", name},
                     {"type", type},
                     {"components", components},
                     {"count", count},
                     {"offset", data_.size()}});
  data_.reserve(data_.size() + index(count) * static_cast<std::size_t>(components) * 4);
}

void MeshMessage::add(const std::string& name, const Points& rows) {
  begin(name, "float32", 3, rows.rows());
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    for (int k = 0; k < 3; ++k) append(data_, static_cast<float>(rows(i, k)));
}

void MeshMessage::add(const std::string& name, const Eigen::VectorXd& values, double factor) {
  begin(name, "float32", 1, values.size());
  for (const double value : values) append(data_, static_cast<float>(value * factor));
}

void MeshMessage::add(const std::string& name, const Triangles& triangles) {
  begin(name, "uint32", 3, triangles.rows());
  for (Eigen::Index i = 0; i < triangles.rows(); ++i)
    for (int k = 0; k < 3; ++k) append(data_, static_cast<std::uint32_t>(triangles(i, k)));
}

std::string MeshMessage::bytes() const {
  std::string header =
      Json{{"arrays", arrays_}}.dump(-1, ' ', false, Json::error_handler_t::replace);
  header.append((4 - header.size() % 4) % 4, ' ');
  std::string bytes;
  bytes.reserve(4 + header.size() + data_.size());
  append(bytes, static_cast<std::uint32_t>(header.size()));
  return bytes + header + data_;
}

std::string mesh_at_rest(const OpenedScene& opened, const std::string& vessel) {
  const TriangleSurface& surface = opened.fitted.vessels[opened.vessel(vessel)].vessel.surface;
  MeshMessage message;
  message.add("points", surface.points);
  message.add("triangles", surface.triangles);
  return message.bytes();
}

std::string mesh_in_result(const StoredResult& stored, const std::string& body) {
  MeshMessage message;
  for (const VesselResult& vessel : stored.result.vessels) {
    if (!vessel.stump || stump_name(vessel.name) != body) continue;
    message.add("points", vessel.stump->points);
    message.add("triangles", vessel.stump->triangles);
    return message.bytes();
  }
  const VesselResult& found = stored.result.vessels[stored.vessel(body)];
  if (found.current.rows() == 0) {
    for (const DrawnBody& drawn : drawn_bodies(stored.result)) {
      if (drawn.vessel != &found) continue;
      message.add("points", drawn.current);
      message.add("triangles", drawn.triangles);
      message.add("rest", drawn.rest);
    }
    return message.bytes();
  }
  message.add("points", found.current);
  message.add("triangles", found.triangles);
  message.add("rest", found.rest);
  for (const ShownField& field : stored.fields)
    if (const Eigen::VectorXd& values = found.*field.values; values.size() == found.current.rows())
      message.add(field.name, values, field.shown_per);
  return message.bytes();
}

}  // namespace vasorod::planner
