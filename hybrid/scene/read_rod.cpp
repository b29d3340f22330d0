#include <Eigen/Cholesky>
#include <cmath>

#include "scene/read_parts.h"

namespace vasorod {

namespace {

// Finer than any mesh of a vessel; far more would exhaust the memory.
constexpr int most_points = 2'000'000;
// Per rod, so that an int can count its unknowns.
constexpr int most_elements = 1'000'000;

Vec6 read_six(const Field& row) {
  const auto items = row.list("six numbers");
  if (items.size() != 6) row.refuse(row.found(), "six numbers");
  Vec6 values;
  for (size_t k = 0; k < 6; ++k)
    values[static_cast<int>(k)] = items[k].number_up_to(largest_stiffness);
  return values;
}

std::array<double, 2> read_two(const Field& field) {
  const auto items = field.list("two numbers above 0, for d1 and d2");
  if (items.size() != 2) field.refuse(field.found(), "two numbers above 0, for d1 and d2");
  return {items[0].stiffness(), items[1].stiffness()};
}

Mat6 read_matrix(const Field& field) {
  const auto rows = field.list("six rows of six numbers in v1 v2 v3 u1 u2 u3");
  if (rows.size() != 6) field.refuse(field.found(), "six rows of six numbers in v1 v2 v3 u1 u2 u3");
  Mat6 matrix;
  for (size_t i = 0; i < 6; ++i) matrix.row(static_cast<int>(i)) = read_six(rows[i]).transpose();
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < i; ++j)
      if (std::abs(matrix(i, j) - matrix(j, i)) >
          1e-12 * std::sqrt(std::abs(matrix(i, i) * matrix(j, j)))) {
        field.refuse(joined_text(matrix(i, j), " in row ", i + 1, ", column ", j + 1, " but ",
                                 matrix(j, i), " across the diagonal"),
                     "a symmetric matrix");
      }
  matrix = (0.5 * (matrix + matrix.transpose())).eval();
  // Scaled to a unit diagonal, so that the choice of units does not affect definiteness.
  const Vec6 diagonal = matrix.diagonal();
  const Mat6 scaled = (diagonal.array() >= smallest_stiffness).all()
                          ? Mat6(diagonal.cwiseSqrt().cwiseInverse().asDiagonal() * matrix *
                                 diagonal.cwiseSqrt().cwiseInverse().asDiagonal())
                          : matrix;
  if (!(diagonal.array() >= smallest_stiffness).all() ||
      Eigen::LLT<Mat6>(scaled).info() != Eigen::Success)
    field.refuse("a matrix that is not positive definite", "a positive definite one");
  return matrix;
}

Mat6 read_stiffness(const Field& field) {
  field.check_keys({"axial", "shear", "bending", "torsion", "matrix"});
  if (const auto matrix = field.find("matrix")) {
    for (const char* other : {"axial", "shear", "bending", "torsion"})
      if (const auto found = field.find(other))
        found->refuse("it beside matrix", "one or the other");
    return read_matrix(*matrix);
  }
  const double axial = field.at("axial", "the axial stiffness E A").stiffness();
  const auto shear = read_two(field.at("shear", "the shear stiffnesses along d1 and d2"));
  const auto bending = read_two(field.at("bending", "the bending stiffnesses about d1 and d2"));
  const double torsion = field.at("torsion", "the torsional stiffness G J").stiffness();
  Vec6 diagonal;
  diagonal << shear[0], shear[1], axial, bending[0], bending[1], torsion;
  return diagonal.asDiagonal();
}

RodPiece read_piece(const Field& field, const std::optional<Mat6>& common) {
  field.check_keys({"length", "curvature", "elements", "stiffness", "end_stiffness", "natural"});
  RodPiece piece;
  piece.length = field.at("length", "the piece's length").length();
  if (const auto curvature = field.find("curvature")) piece.curvature = curvature->vec3();
  piece.elements = field.at("elements", "the number of elements").integer_in(1, most_elements);
  if (const auto stiffness = field.find("stiffness")) {
    piece.stiffness = read_stiffness(*stiffness);
  } else if (common) {
    piece.stiffness = *common;
  } else {
    field.at("stiffness", "a stiffness here or one for all pieces of the rod");
  }
  if (const auto end = field.find("end_stiffness")) piece.end_stiffness = read_stiffness(*end);
  if (const auto natural = field.find("natural")) {
    natural->check_keys({"u", "v"});
    Vec6 strain;
    strain << 0, 0, 1, piece.curvature;
    if (const auto u = natural->find("u")) strain.tail<3>() = u->vec3();
    if (const auto v = natural->find("v")) {
      strain.head<3>() = v->vec3();
      if (!(strain[2] > 0)) v->refuse("v3 = " + number_text(strain[2]), "a stretch v3 above 0");
    }
    piece.natural = strain;
  }
  return piece;
}

}  // namespace

RodSpec read_rod(const Field& field) {
  field.check_keys({"parent", "position", "tangent", "normal", "pieces", "stiffness"});
  RodSpec rod;
  if (const auto parent = field.find("parent")) {
    rod.parent = parent->text("the name of another rod");
    // By default a branch continues straight on in the parent's frame: along d3, with the same d1.
    rod.tangent = Vec3::UnitZ();
    rod.normal = Vec3::UnitX();
  }
  if (const auto position = field.find("position")) rod.position = position->vec3();
  if (const auto tangent = field.find("tangent")) rod.tangent = tangent->vec3();
  if (const auto normal = field.find("normal")) rod.normal = normal->vec3();
  check_directions(field, rod.tangent, rod.normal);
  std::optional<Mat6> common;
  if (const auto stiffness = field.find("stiffness")) common = read_stiffness(*stiffness);
  const Field pieces = field.at("pieces", "a list of pieces");
  double elements = 0;
  for (const Field& piece : pieces.list("a list of pieces")) {
    rod.pieces.push_back(read_piece(piece, common));
    elements += rod.pieces.back().elements;
    if (elements > most_elements)
      piece.refuse(number_text(elements, 10) + " elements up to here",
                   "at most " + std::to_string(most_elements) + " in one rod");
  }
  if (rod.pieces.empty()) pieces.refuse("an empty list", "at least one piece");
  return rod;
}

TubeSpec read_tube(const Field& field) {
  field.check_keys({"length", "radius", "around", "along", "bend_deg", "end_radius",
                    "end_thickness", "position", "tangent", "normal"});
  TubeSpec tube;
  tube.length = field.at("length", "the tube's length").length();
  tube.radius = field.at("radius", "the tube's radius").length();
  if (const auto around = field.find("around")) tube.around = around->integer_in(6, 5000);
  if (const auto along = field.find("along")) tube.along = along->integer_in(1, 20000);
  if (const auto radius = field.find("end_radius")) tube.end_radius = radius->length();
  if (const auto thickness = field.find("end_thickness")) tube.end_thickness = thickness->length();
  if (const auto position = field.find("position")) tube.position = position->vec3();
  if (const auto tangent = field.find("tangent")) tube.tangent = tangent->vec3();
  if (const auto normal = field.find("normal")) tube.normal = normal->vec3();
  check_directions(field, tube.tangent, tube.normal);
  if (double(tube.around) * (tube.along + 1) > most_points)
    field.refuse(std::to_string(tube.around) + " points around and " + std::to_string(tube.along) +
                     " strips along",
                 "at most " + std::to_string(most_points) + " points");
  if (const auto bend = field.find("bend_deg")) {
    tube.bend_deg = bend->number_up_to(largest_length);
    const double widest = std::max(tube.radius, tube.end_radius.value_or(0));
    const double most = std::min(tube.length / widest * 180 / M_PI, 360.0);
    if (!(std::abs(tube.bend_deg) < most)) {
      bend->refuse(number_text(tube.bend_deg),
                   joined_text("an angle below ", most, " degrees, where the tube meets itself"));
    }
  }
  return tube;
}

}  // namespace vasorod
