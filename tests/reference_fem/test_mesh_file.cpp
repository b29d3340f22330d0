// gmsh meshes: equal results to the built-in mesh of the same cells, and one sentence for each file
// that deal.II would misread or that is not the scene's tube. One test makes its files with
// meshes/tube.py.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>
#include <sstream>

#include <vasorod/error.h>

#include "geometry/rigid_motion.h"
#include "program/run_program.h"
#include "reference_fem/mesh_file.h"
#include "reference_fem/shell.h"
#include "reference_fem/solid.h"
#include "reference_fem/stepper.h"
#include "reference_fem/tube_ends.h"

namespace vasorod::fem {
namespace {

/// A hexahedral (quadrilateral) mesh of the straight tube in gmsh's format 2.2. The order and the
/// local axes of the cells vary.
struct Written {
  int around = 6, along = 3, layers = 2;  ///< no layers: the mid-wall
  double length = 30, radius = 10, thickness = 2;
  std::string header = "2.2 0 8";
  std::string cell_type;   ///< replaces the correct one
  int start_tag = 1;       ///< of the faces at the start
  double shift = 0;        ///< of one vertex, along the axis
  bool leave_out = false;  ///< the last cell

  std::string text() const {
    const bool solid = layers > 0;
    const int levels = solid ? layers + 1 : 1;
    const auto node = [&](int i, int j, int k) {
      return 1 + i % around + around * (j + (along + 1) * k);
    };
    std::ostringstream out;
    out.precision(17);
    out << "$MeshFormat\n"
        << header << "\n$EndMeshFormat\n$Nodes\n"
        << around * (along + 1) * levels << "\n";
    for (int k = 0; k < levels; ++k)
      for (int j = 0; j <= along; ++j)
        for (int i = 0; i < around; ++i) {
          const double a = 2 * std::numbers::pi * i / around,
                       r = solid ? radius + thickness * (static_cast<double>(k) / layers - 0.5)
                                 : radius;
          const double z = length * j / along + (i == 1 && j == 1 ? shift : 0);
          out << node(i, j, k) << " " << r * std::cos(a) << " " << r * std::sin(a) << " " << z
              << "\n";
        }
    std::vector<std::string> cells;
    const auto line = [&](const std::string& type, int tag, const std::vector<int>& nodes) {
      std::ostringstream s;
      s << type << " 2 " << tag << " 1";
      for (const int n : nodes) s << " " << n;
      cells.push_back(s.str());
    };
    for (int i = 0; i < around && start_tag > 0; ++i) {
      for (int k = 0; k < layers; ++k)
        line("3", start_tag,
             {node(i, 0, k), node(i + 1, 0, k), node(i + 1, 0, k + 1), node(i, 0, k + 1)});
      if (!solid) line("1", start_tag, {node(i, 0, 0), node(i + 1, 0, 0)});
    }
    for (int j = along - 1; j >= 0; --j)
      for (int i = 0; i < around; ++i)
        for (int k = 0; k < std::max(layers, 1); ++k) {
          if (leave_out && i == 0 && j == 0 && k == 0) continue;
          const int n[2][4] = {
              {node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)},
              {node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
               node(i, j + 1, k + 1)}};
          std::vector<int> nodes;
          const int turn = (i + j) % 4;  // gmsh's order may start at any corner
          for (int side = 0; side < (solid ? 2 : 1); ++side)
            for (int c = 0; c < 4; ++c) nodes.push_back(n[side][(c + turn) % 4]);
          line(cell_type.empty() ? (solid ? "5" : "3") : cell_type, 10, nodes);
        }
    out << "$EndNodes\n$Elements\n" << cells.size() << "\n";
    for (std::size_t c = 0; c < cells.size(); ++c) out << c + 1 << " " << cells[c] << "\n";
    out << "$EndElements\n";
    return out.str();
  }
};

class File {
 public:
  explicit File(const std::string& text)
      : path_(std::filesystem::temp_directory_path() /
              (std::string("vasorod_") +
               ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".msh")) {
    std::ofstream(path_) << text;
  }
  ~File() { std::filesystem::remove(path_); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

const TubeShape straight{30, 10, 2, 10, 2, 0, {}};

/// Bent by 8 degrees between a held and a moved rigid end: energy, force and moment.
struct Answer {
  double energy = 0;
  Vec6 force = Vec6::Zero();
};

template <class Part>
Answer bent(const Part& model, const TubeShape& tube) {
  Supports supports;
  for (const int side : {0, 1}) supports.sections.push_back(end_section(model, tube, side, false));
  for (Section& section : supports.sections) section.fixed.fill(true);
  supports.sections[1].rotation = tube.section(1).rotation * Vec3(0, 8 * std::numbers::pi / 180, 0);
  const System system(model, supports);
  State state;
  System::Assembly assembly;
  const StepperSummary summary = follow_path(system, state, assembly);
  EXPECT_EQ(summary.status, PathStatus::complete);
  return {summary.energy, assembly.section_force[1]};
}

const MaterialLaw law(LawKind::biot, Moduli::isotropic(1, 0.3));

Answer bent_solid(Mesh mesh, const TubeShape& tube) {
  return bent(Solid(std::move(mesh), law, [&](const Vec3& p) { return tube.axes(p); }), tube);
}
Answer bent_shell(Mesh mesh, const TubeShape& tube) {
  return bent(Shell(std::move(mesh), law, tube_body(tube), 3), tube);
}

void expect_same(const Answer& a, const Answer& b) {
  EXPECT_NEAR(a.energy / b.energy, 1, 1e-9);
  EXPECT_LT((a.force - b.force).norm(), 1e-8 * b.force.norm());
}

TEST(MeshFile, HexahedraInAnyOrderGiveTheBuiltInMeshsNumbers) {
  const File file(Written{}.text());
  const Mesh mesh = read_solid({file.path(), 1, 0}, straight, 2);
  EXPECT_EQ(count_cells(mesh).around, 6);
  EXPECT_EQ(count_cells(mesh).along, 3);
  expect_same(
      bent_solid(mesh, straight),
      bent_solid(make_solid({{6, 3, 2}, true, 2}, [](const Vec3& p) { return straight.point(p); }),
                 straight));
}

TEST(MeshFile, QuadrilateralsGiveTheBuiltInMeshsNumbers) {
  Written flat;
  flat.layers = 0;
  const File file(flat.text());
  expect_same(bent_shell(read_surface({file.path(), 1, 0}, straight, 3), straight),
              bent_shell(make_surface({{6, 3, 1}, true, 3},
                                      [](const Vec3& p) {
                                        return straight.point({p[0], p[1], 0.5});
                                      }),
                         straight));
}

TEST(MeshFile, HalvedCellsLieOnTheTubeAndUnitsArePassedOn) {
  Written metres;
  metres.length = 0.030;
  metres.radius = 0.010;
  metres.thickness = 0.002;
  metres.around = 4;
  metres.along = 2;
  metres.layers = 1;
  const File file(metres.text());
  const Mesh mesh = read_solid({file.path(), 1e-3, 1}, straight, 2);
  EXPECT_EQ(mesh.cell_count(), 8 * 4 * 2);
  expect_same(
      bent_solid(mesh, straight),
      bent_solid(make_solid({{8, 4, 2}, true, 2}, [](const Vec3& p) { return straight.point(p); }),
                 straight));
}

// A file of meshes/tube.py: bent by 60 degrees, tapered in radius and thickness; both gmsh formats.
TEST(MeshFile, CurvedTaperedTubeOfGmsh) {
  const testing::ScratchFolder scratch;
  const std::string hexahedra = (scratch / "hex.msh").string(),
                    flat = (scratch / "quad.msh").string(),
                    shape =
                        " --length 30 --radius 5 --end-radius 4 --bend-deg 60 --around 8 --along 6";
  for (const std::string& arguments : {hexahedra + shape + " --thickness 1 --end-thickness 0.7",
                                       flat + shape + " --cells quad --msh2"}) {
    const testing::ProgramRun made = testing::run_program(VASOROD_TUBE_GENERATOR " " + arguments);
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }
  TubeShape tube{30, 5, 1, 4, 0.7, std::numbers::pi / 3, {}};
  tube.placement.rotation = exp_rotation(Vec3(0.3, -1, 0.4));  // the scene places the tube
  tube.placement.position = Vec3(5, -3, 7);
  const Block block{{8, 6, 1}, true, 3};
  expect_same(bent_solid(read_solid({hexahedra, 1, 0}, tube, 3), tube),
              bent_solid(make_solid(block, [&](const Vec3& p) { return tube.point(p); }), tube));
  expect_same(bent_shell(read_surface({flat, 1, 0}, tube, 3), tube),
              bent_shell(make_surface(block,
                                      [&](const Vec3& p) {
                                        return tube.point({p[0], p[1], 0.5});
                                      }),
                         tube));
}

TEST(MeshFile, ParametersOfATubeAreTheChartsInverse) {
  for (const double bend : {0.0, 1.2, -1.2, 4.0}) {
    TubeShape tube{60, 5, 1, 4, 0.7, bend, {}};
    tube.placement.rotation = exp_rotation(Vec3(0.3, -1, 0.4));
    for (const Vec3& p :
         {Vec3(0.1, 0, 0.2), Vec3(0.6, 1, 1), Vec3(0.95, 0.4, 0), Vec3(0.3, 0.8, 0.7)})
      EXPECT_LT((tube.parameters(tube.point(p)) - p).norm(), 1e-13) << bend;
  }
}

void refused(const std::string& text, const std::string& part, int dim = 3,
             const TubeShape& tube = straight) {
  const File file(text);
  try {
    if (dim == 3)
      read_solid({file.path(), 1, 0}, tube, 2);
    else
      read_surface({file.path(), 1, 0}, tube, 2);
    ADD_FAILURE() << "accepted: " << part;
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find(part), std::string::npos) << what;
    EXPECT_EQ(what.find(file.path()), 0u) << what;
    EXPECT_NE(what.find("; expected "), std::string::npos) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }
}

TEST(MeshFile, RefusesWhatTheReaderWouldMisread) {
  Written w;
  w.header = "2.2 1 8";
  refused(w.text(), "found a binary file");
  w.header = "4 0 8";
  refused(w.text(), "found format 4");
  w = {};
  w.cell_type = "17";
  refused(w.text(), "36 second-order hexahedra (20 nodes)");
  w.cell_type = "4";
  refused(w.text(), "36 tetrahedra");
  refused("solid.stl\n", "found no $MeshFormat");
  w = {};
  w.layers = 0;
  refused(w.text(), "found no hexahedra");
  refused(
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 1\n1 0 0 0 1 1 1 2 10 11 "
      "0\n$EndEntities\n"
      "$Elements\n1 1 1 1\n3 1 5 1\n1 1 2 3 4 5 6 7 8\n$EndElements\n",
      "found 2 physical groups on entity 1");
  EXPECT_THROW(read_solid({"/nowhere/wall.msh", 1, 0}, straight, 2), FileError);
}

TEST(MeshFile, RefusesWhatIsNotTheScenesTube) {
  Written w;
  w.start_tag = 2;
  refused(w.text(), "found the physical tag 2 on a face at the fraction 0.0");
  w = {};
  w.radius = 11;
  refused(w.text(), "found the vertex (12, ");
  w.layers = 0;
  refused(w.text(), ", 1 off the mid-wall", 2);
  w = {};
  w.leave_out = true;
  refused(w.text(), "found cells on 91.6667 % of the tube's start");
  w = {};
  w.along = 2;
  w.shift = 20;
  refused(w.text(), "found the vertex");
  w.along = 3;
  w.shift = 12;
  refused(w.text(), "turned inside out");
  w = {};
  w.length = 20;
  refused(w.text(), "found cells on 0 % of the tube's end");
}

}  // namespace
}  // namespace vasorod::fem
