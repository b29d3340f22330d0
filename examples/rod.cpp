// A cantilever under a dead moment at its end rolls up to a circular arc: the rod alone.
#include <cmath>
#include <cstdio>
#include <numbers>

#include <vasorod/predict.h>

int main() {
  constexpr double length = 100, bending_stiffness = 8.3e5, angle = std::numbers::pi / 2;
  vasorod::RodPiece piece;
  piece.length = length;
  piece.elements = 20;
  vasorod::Vec6 stiffness;  // of v1 v2 v3 u1 u2 u3
  stiffness << 5e6, 5e6, 1e7, bending_stiffness, bending_stiffness, 8.3e5;
  piece.stiffness = stiffness.asDiagonal();
  vasorod::VesselSpec beam;
  beam.name = "beam";
  beam.rod.emplace().pieces = {piece};  // along +x, d1 along +y

  vasorod::EndCondition held;
  held.vessel = "beam";
  held.hold = true;
  vasorod::EndCondition loaded;
  loaded.vessel = "beam";
  loaded.end.kind = vasorod::EndSelector::Kind::end;
  loaded.moment = vasorod::Vec3(0, 0, bending_stiffness * angle / length);

  vasorod::Scene scene;
  scene.name = "rolled beam";
  scene.vessels = {beam};
  scene.ends = {held, loaded};
  scene.fidelity = "rod";
  const vasorod::Result result = vasorod::predict(scene);

  const auto& line = result.vessels.front().centerline->current;
  const double radius = length / angle;
  const vasorod::Vec3 end = line.row(line.rows() - 1), expected(radius, radius, 0);
  std::printf("%s: the end is at (%.6f, %.6f, %.6f), the arc's closed form at (%.6f, %.6f, 0)\n",
              to_string(result.status).c_str(), end.x(), end.y(), end.z(), expected.x(),
              expected.y());
  return (end - expected).norm() < 1e-6 * length ? 0 : 1;
}
