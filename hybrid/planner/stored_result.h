// A result that the page can look at.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/result.h>

#include "geometry/ray_hits.h"
#include "planner/plan.h"

namespace vasorod::planner {

/// A field of the surfaces as the page shows it.
struct ShownField {
  std::string name;   ///< as in VTP files: TwistShear, AxialStretch, ContactPressure
  std::string title;  ///< for readers, without the unit
  std::string unit;   ///< mmHg; empty: a ratio
  std::string map;    ///< diverging, sequential, or grey where the state is no solution
  double neutral = 0, low = 0, high = 0;  ///< in the shown unit, as in report.html
  double shown_per = 1;                   ///< shown numbers per unit of the values
  const Eigen::VectorXd VesselResult::*values = nullptr;
};

class StoredResult {
 public:
  /// `json`: the text of result.json.
  StoredResult(std::string result_id, Result&& solved, std::optional<Plan> solved_plan,
               std::string json_text);

  /// Index of a vessel; throws Refusal (404).
  std::size_t vessel(const std::string& name) const;
  /// The deformed walls, in the vessels' order, where there is a surface; built when they are first
  /// asked for.
  const std::vector<std::optional<RayHits>>& walls() const;

  const std::string id;
  const Result result;
  const std::optional<Plan> plan;
  const std::string json;
  const std::vector<ShownField> fields;
  /// Per vessel, length: from the given surface inwards to the lumen; empty: not known.
  std::vector<std::optional<double>> to_lumen;

 private:
  mutable std::once_flag built_;
  mutable std::vector<std::optional<RayHits>> walls_;
};

/// The answer of GET api/result/ID.
Json json_of(const StoredResult& stored);

}  // namespace vasorod::planner
