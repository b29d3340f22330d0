#include <gtest/gtest.h>

#include "geometry/loops.h"
#include "geometry/triangle_surface.h"
#include "surgery/edited_vessel.h"
#include "vessel/shapes.h"

namespace vasorod {
namespace {

// A straight tube, fitted, with arrays of its own.
PreparedVessel prepared() {
  PreparedVessel vessel;
  vessel.vessel = fit_vessel("svc", shapes::Tube().surface());
  const Points& points = vessel.vessel.surface.points;
  const auto triangles = vessel.vessel.surface.triangles.rows();
  NamedArray height, label, face;
  height.name = "height";
  height.values = points.col(2);
  label.name = "label";
  label.integer = true;
  label.values = Eigen::MatrixXd(points.rows(), 1);
  for (Eigen::Index i = 0; i < points.rows(); ++i) label.values(i, 0) = static_cast<double>(i);
  face.name = "face";
  face.values = Eigen::MatrixXd(triangles, 1);
  for (Eigen::Index t = 0; t < triangles; ++t) face.values(t, 0) = static_cast<double>(t);
  vessel.loaded.point_arrays = {height, label};
  vessel.loaded.cell_arrays = {face};
  return vessel;
}

VertexSource original(int vertex) {
  VertexSource source;
  source.vertex = {vertex};
  source.weight = {1};
  return source;
}

// The tube without its last rows, and with one triangle cut in three about its middle.
struct Edit {
  TriangleSurface surface;
  VertexSources sources;
  std::vector<int> triangles;  // the input triangle of each
};
Edit shortened(const TriangleSurface& tube, int kept_rows, int around = 48) {
  Edit edit;
  const int points = kept_rows * around;
  const int cut = 100;  // the triangle that becomes three
  edit.surface.points.resize(points + 1, 3);
  edit.surface.points.topRows(points) = tube.points.topRows(points);
  for (int i = 0; i < points; ++i) edit.sources.push_back(original(i));
  VertexSource middle;
  Vec3 centre = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    middle.vertex.push_back(tube.triangles(cut, k));
    middle.weight.push_back(k == 0 ? 0.5 : 0.25);
    centre += middle.weight.back() * tube.points.row(tube.triangles(cut, k)).transpose();
  }
  edit.sources.push_back(middle);
  edit.surface.points.row(points) = centre;
  std::vector<std::array<int, 3>> kept;
  for (int t = 0; t < tube.triangles.rows(); ++t) {
    if (tube.triangles.row(t).maxCoeff() >= points) continue;
    for (int k = 0; k < (t == cut ? 3 : 1); ++k) {
      std::array<int, 3> corners{tube.triangles(t, 0), tube.triangles(t, 1), tube.triangles(t, 2)};
      if (t == cut) corners[static_cast<size_t>(k)] = points;
      kept.push_back(corners);
      edit.triangles.push_back(t);
    }
  }
  edit.surface.triangles.resize(static_cast<Eigen::Index>(kept.size()), 3);
  for (size_t t = 0; t < kept.size(); ++t)
    edit.surface.triangles.row(static_cast<Eigen::Index>(t)) << kept[t][0], kept[t][1], kept[t][2];
  return edit;
}

TEST(EditedVessel, TrianglesKnowWhereTheyComeFrom) {
  const TriangleSurface tube = shapes::Tube().surface();
  const Edit edit = shortened(tube, 60);
  EXPECT_EQ(triangle_sources(edit.surface.triangles, edit.sources, tube.triangles), edit.triangles);
}

TEST(EditedVessel, ArraysEndsAndLabelsFollow) {
  PreparedVessel vessel = prepared();
  const std::vector<VesselEnd> ends = vessel.vessel.ends;
  vessel.prestress_displacement = 2 * vessel.vessel.surface.points;
  const Edit edit = shortened(vessel.vessel.surface, 60);
  const std::vector<int> now = follow_edit(vessel, edit.surface, edit.sources);
  EXPECT_EQ(now, (std::vector<int>{0, -1})) << "the far end is gone";
  ASSERT_EQ(vessel.vessel.ends.size(), 1u);
  EXPECT_EQ(vessel.vessel.ends[0].node, ends[0].node);
  std::vector<int> before = ends[0].loop, after = vessel.vessel.ends[0].loop;
  std::sort(before.begin(), before.end());
  std::sort(after.begin(), after.end());
  EXPECT_EQ(before, after);
  // The height of a point is its z, wherever it came from.
  const NamedArray &height = vessel.loaded.point_arrays[0], &label = vessel.loaded.point_arrays[1];
  ASSERT_EQ(height.values.rows(), edit.surface.points.rows());
  EXPECT_LT((height.values - edit.surface.points.col(2)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((vessel.prestress_displacement - 2 * edit.surface.points).cwiseAbs().maxCoeff(), 1e-12);
  // A label is one of those there were: that of the heaviest corner.
  const auto last = label.values.rows() - 1;
  EXPECT_EQ(label.values(last, 0), edit.sources.back().vertex[0]);
  for (Eigen::Index i = 0; i < last; ++i) EXPECT_EQ(label.values(i, 0), static_cast<double>(i));
  const NamedArray& face = vessel.loaded.cell_arrays[0];
  ASSERT_EQ(face.values.rows(), edit.surface.triangles.rows());
  for (size_t t = 0; t < edit.triangles.size(); ++t)
    EXPECT_EQ(face.values(static_cast<Eigen::Index>(t), 0), edit.triangles[t]);
  EXPECT_EQ(vessel.vessel.branch_of.size(), static_cast<size_t>(edit.surface.points.rows()));
  EXPECT_EQ(vessel.vessel.surface.triangles, edit.surface.triangles);
}

TEST(EditedVessel, BoundAgainTheRodCarriesEveryPointToItsPlace) {
  PreparedVessel vessel = prepared();
  const Edit edit = shortened(vessel.vessel.surface, 60);
  follow_edit(vessel, edit.surface, edit.sources);
  bind_again(vessel);
  const Points carried =
      carried_points(vessel.vessel.rod, vessel.vessel.rod.rest, vessel.vessel.binding);
  EXPECT_LT((carried - edit.surface.points).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace vasorod
