// Surfaces as bytes for the page: arrays behind a short header of JSON.
#pragma once

#include <string>

#include "planner/opened_scene.h"
#include "planner/stored_result.h"

namespace vasorod::planner {

/// The arrays of one surface, little-endian: the length of the header in bytes (uint32, a multiple
/// of 4), the header {arrays: [{name, type, components, count, offset}]} as JSON padded with
/// spaces, the arrays; offsets in bytes from the end of the header.
class MeshMessage {
 public:
  /// float32, one row per point.
  void add(const std::string& name, const Points& rows);
  /// float32, one number per point, each multiplied by `factor`.
  void add(const std::string& name, const Eigen::VectorXd& values, double factor);
  /// uint32.
  void add(const std::string& name, const Triangles& triangles);
  std::string bytes() const;

 private:
  void begin(const std::string& name, const char* type, int components, Eigen::Index count);

  Json arrays_ = Json::array();
  std::string data_;
};

/// A vessel at rest: points, triangles. Throws Refusal (404).
std::string mesh_at_rest(const OpenedScene& opened, const std::string& vessel);
/// A vessel of a result: points, triangles, rest and its fields as they are shown; of a vessel
/// without a surface (fidelity rod) a tube around its rod. `VESSEL_stump`: points and triangles of
/// the part cut off. Throws Refusal (404).
std::string mesh_in_result(const StoredResult& stored, const std::string& body);

}  // namespace vasorod::planner
