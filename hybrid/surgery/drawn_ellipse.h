// An ellipse as it is drawn on the wall about a pick, before it is cut out.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/triangle_surface.h"
#include "surgery/incision_place.h"

namespace vasorod {

/// Smallest length and width of an ellipse, in mean edges: below, it falls between the vertices.
inline constexpr double smallest_ellipse = 2;

/// The wall unrolled about the pick (geometry/flat_chart.h) and the ellipse on it, its axis along
/// the rod.
class DrawnEllipse {
 public:
  /// `length` along the rod and `width` across it, on the wall. `surface` to `place` must outlive
  /// this. Throws InputError if the ellipse goes too far around the vessel.
  DrawnEllipse(const TriangleSurface& surface, const RodTree& rod, const Binding& binding,
               const IncisionPlace& place, double length, double width);

  /// Plane coordinates per vertex, x along the rod, the pick at 0; NaN off the unrolled patch.
  const Eigen::MatrixX2d& chart() const { return chart_; }
  /// About the distance from the ellipse per vertex, length unit: below 0 inside.
  const std::vector<double>& value() const { return value_; }
  /// The edges between inside and outside.
  std::vector<std::array<int, 2>> crossing_edges() const;
  /// "LENGTH long and WIDTH wide"; scaled down by `scale`: rounded down.
  std::string size_text(double scale = 1) const;
  /// Throws InputError where an open end or a fork lies in the ellipse or beside its rim.
  void require_room() const;

 private:
  Vec2 direction(int v) const { return binding_[static_cast<size_t>(v)].local.head<2>(); }
  Vec2 direction_at_pick() const;
  bool in_patch(int v) const;
  bool is_obstacle(int v) const;
  double size_at(int v) const;
  std::vector<int> patch(double along, double angle);
  void draw(double along, double angle);
  std::optional<int> obstacle() const;
  bool cut_off() const;

  const TriangleSurface& surface_;
  const RodTree& rod_;
  const Binding& binding_;
  const IncisionPlace& place_;
  std::vector<Edge> edges_;
  double half_length_, half_width_, edge_;
  std::vector<char> at_end_, at_fork_;  // per vertex
  std::vector<char> in_patch_;          // per triangle
  Eigen::MatrixX2d chart_;
  std::vector<double> value_;
};

}  // namespace vasorod
