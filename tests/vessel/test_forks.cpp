#include <filesystem>
#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "geometry/triangle_surface.h"
#include "infant_anatomy.h"
#include "real_anatomy.h"
#include "rod/rod_search.h"
#include "surface_file/read_surface.h"
#include "vessel/shapes.h"
#include "vessel/vessel.h"

namespace vasorod {
namespace {

TriangleSurface read(const std::filesystem::path& file, std::optional<double> edge = {}) {
  Scene scene;
  VesselSpec vessel;
  vessel.name = file.stem();
  vessel.surface = file;
  vessel.remesh = edge;
  return load_surface(vessel, scene).surface;
}

// Properties of every fitted vessel, whatever its shape.
void expect_sound(const Vessel& vessel) {
  const RodTree& tree = vessel.rod;
  EXPECT_EQ(tree.branches.size(),
            2 * vessel.ends.size() - 3);  // a tree whose forks have two branches each
  const Points carried = carried_points(tree, tree.rest, vessel.binding);
  EXPECT_LT((carried - vessel.surface.points).cwiseAbs().maxCoeff(), 1e-9 * vessel.mean_radius);
  for (const VesselEnd& end : vessel.ends) {
    const Pose& node = tree.rest[static_cast<size_t>(end.node)];
    const double radius = tree.radius[static_cast<size_t>(end.node)];
    EXPECT_LT((node.position - end.center).norm(), 0.1 * radius);
    EXPECT_GT(std::abs(node.director(3).dot(end.outward)), 0.7);
  }
  for (size_t b = 0; b < tree.branches.size(); ++b) {
    const RodBranch& branch = tree.branches[b];
    EXPECT_LT(branch.parent, static_cast<int>(b));
    if (branch.parent >= 0) {
      EXPECT_EQ(branch.nodes.front(),
                tree.branches[static_cast<size_t>(branch.parent)].nodes.back());
    }
    for (size_t k = 1; k < branch.elements.size(); ++k) {  // the first may bend at its fork
      const RodElement& e = tree.elements[static_cast<size_t>(branch.elements[k])];
      EXPECT_LT(e.rest_strain.segment<2>(3).norm() * tree.radius[static_cast<size_t>(e.second)],
                0.95);
    }
  }
  // Sections pass through their vertices, except beyond ends and at forks.
  int beside = 0;
  for (const RodCoordinates& at : vessel.binding)
    if (at.local.z() != 0) ++beside;
  EXPECT_LT(beside, 0.15 * static_cast<double>(vessel.binding.size()));
}

TEST(Forks, BundledAortaHasItsThreeArchVessels) {
  const Vessel vessel = fit_vessel("aorta", testing::infant("aorta"));
  ASSERT_EQ(vessel.ends.size(), 5U);
  expect_sound(vessel);
  // The generator's radii: 5 at the root, 3.6 at the far end, the arch vessels 2.1, 1.5 and 1.6.
  std::vector<double> radii;
  for (const VesselEnd& end : vessel.ends)
    radii.push_back(vessel.rod.radius[static_cast<size_t>(end.node)]);
  const std::vector<double> expected{5.0, 3.6, 2.1, 1.5, 1.6};
  for (size_t k = 0; k < 5; ++k) EXPECT_NEAR(radii[k], expected[k], 0.02 * expected[k]);
  // The arch continues into the descending aorta: four branches in a row, the wide ones.
  int continued = 0;
  for (const RodBranch& b : vessel.rod.branches)
    if (vessel.rod.radius[static_cast<size_t>(b.nodes.back())] > 3) ++continued;
  EXPECT_EQ(continued, 4);
}

TEST(Forks, BundledPulmonaryArteryForksOnce) {
  const Vessel vessel = fit_vessel("pulmonary_artery", testing::infant("pulmonary_artery"));
  ASSERT_EQ(vessel.ends.size(), 3U);
  expect_sound(vessel);
}

TEST(Forks, ABranchKeepsItsOwnSections) {
  const Vessel vessel = fit_vessel("aorta", testing::infant("aorta"));
  for (Eigen::Index i = 0; i < vessel.surface.points.rows(); ++i) {
    const RodCoordinates& at = vessel.binding[static_cast<size_t>(i)];
    const auto& elements =
        vessel.rod.branches[static_cast<size_t>(vessel.branch_of[static_cast<size_t>(i)])].elements;
    EXPECT_NE(std::find(elements.begin(), elements.end(), at.element), elements.end());
  }
}

// The fork of the pulmonary artery with 2 to 4 mm of its branches, followed from a branch.
TEST(Forks, AnAxisThatLeavesTheWallBesideAForkSaysSo) {
  const TriangleSurface whole = testing::infant("pulmonary_artery");
  std::vector<int> near;
  for (int t = 0; t < whole.triangles.rows(); ++t)
    if ((triangle_center(whole, t) - Vec3(10, 9.5, 1.8)).norm() < 8) near.push_back(t);
  TriangleSurface fork = part_with(whole, near);
  EXPECT_EQ(fit_vessel("fork", fork).ends.size(), 3U) << "from the trunk";
  const int last = static_cast<int>(fork.points.rows()) - 1;
  fork.points = fork.points.colwise().reverse().eval();
  fork.triangles = (last - fork.triangles.array()).eval();
  try {
    fit_vessel("fork", fork);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("outside the surface beside a fork"),
              std::string::npos)
        << error.what();
  }
}

TEST(Forks, MoveWithTheSurface) {
  const TriangleSurface surface = testing::infant("pulmonary_artery");
  const Pose motion = shapes::some_motion();
  const Vessel here = fit_vessel("pa", surface),
               there = fit_vessel("pa", shapes::moved(surface, motion));
  ASSERT_EQ(here.rod.node_count(), there.rod.node_count());
  for (size_t k = 0; k < here.rod.rest.size(); ++k) {
    const Pose expected = motion * here.rod.rest[k];
    ASSERT_LT((expected.position - there.rod.rest[k].position).norm(), 1e-9 * here.mean_radius);
    ASSERT_LT((expected.rotation - there.rod.rest[k].rotation).norm(), 1e-9);
  }
  EXPECT_EQ(here.branch_of, there.branch_of);
}

TEST(Forks, RealAnatomyIsFitted) {
  const std::filesystem::path adult = testing::real_anatomy();
  const Vessel svc = fit_vessel("svc", read(adult / "svc.vtp"));
  EXPECT_EQ(svc.ends.size(), 2U);
  expect_sound(svc);
  EXPECT_NEAR(2 * svc.mean_radius, 20, 1.3);  // its data sheet: diameter 18.8 to 21.3 mm
  expect_sound(fit_vessel("pulmonary_artery", read(adult / "pulmonary_artery.vtp")));
  const Vessel aorta = fit_vessel("aorta", read(adult / "aorta.vtp"));
  EXPECT_EQ(aorta.ends.size(), 5U);
  expect_sound(aorta);
}

}  // namespace
}  // namespace vasorod
