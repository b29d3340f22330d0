// The Hessian of the wall: blocks of nine nodes per triangle (three vertices, the nodes across each
// edge, the xi of the edges) added into a fixed pattern.
#include <Eigen/Geometry>
#include <algorithm>

#include "numerics/block_pattern.h"
#include "wall/membrane_strain.h"
#include "wall/wall_energy.h"

namespace vasorod {

namespace {

// Pairs (i, j), i >= j, of a triangle's nine nodes, row by row.
constexpr int pair(int i, int j) {
  return i * (i + 1) / 2 + j;
}

using Row9 = Eigen::Matrix<double, 1, 9>;
using Mat69 = Eigen::Matrix<double, 6, 9>;

// Derivative of C with respect to the triangle's vertices.
Eigen::Matrix<double, 3, 9> metric_by_vertices(const TriangleRest& rest,
                                               const Eigen::Matrix<double, 3, 2>& f) {
  Eigen::Matrix<double, 3, 9> d;
  for (int i = 0; i < 3; ++i) {
    const Vec2 slope = rest.gradients.col(i);
    d.block<1, 3>(0, 3 * i) = 2 * slope[0] * f.col(0).transpose();
    d.block<1, 3>(1, 3 * i) = 2 * slope[1] * f.col(1).transpose();
    d.block<1, 3>(2, 3 * i) = slope[0] * f.col(1).transpose() + slope[1] * f.col(0).transpose();
  }
  return d;
}

}  // namespace

void WallEnergy::set_pattern() {
  std::vector<int> sizes(static_cast<size_t>(vertices_), 3);
  std::vector<int> edge_node(edges_.size());
  const auto number = [&](bool glued) {
    for (size_t e = 0; e < edges_.size(); ++e)
      if (edges_[e].glued == glued) {
        edge_node[e] = static_cast<int>(sizes.size());
        sizes.push_back(glued ? 3 : 1);
      }
  };
  number(false);
  const auto first_lean = static_cast<int>(sizes.size());
  sizes.insert(sizes.end(), leans_.size(), 1);
  number(true);
  BlockPattern pattern(sizes);
  places_.resize(sides_.size());
  for (size_t t = 0; t < sides_.size(); ++t) {
    auto& node = places_[t].node;
    for (size_t k = 0; k < 3; ++k) {
      const auto e = static_cast<size_t>(sides_[t].edge[k]);
      node[k] = triangles_(static_cast<int>(t), static_cast<int>(k));
      node[3 + k] = edges_[e].glued ? edge_node[e] : sides_[t].neighbour[k];
      node[6 + k] = edges_[e].glued ? -1 : edge_node[e];
    }
    for (size_t i = 0; i < 9; ++i)
      for (size_t j = 0; j < i; ++j)
        if (node[i] >= 0 && node[j] >= 0) pattern.couple(node[i], node[j]);
  }
  couple_leans(first_lean, pattern);
  hessian_ = pattern.build();
  for (Places& p : places_)
    for (int i = 0; i < 9; ++i)
      for (int j = 0; j <= i; ++j) {
        const int a = p.node[static_cast<size_t>(i)], b = p.node[static_cast<size_t>(j)];
        if (a >= 0 && b >= 0)
          p.place[static_cast<size_t>(pair(i, j))] = pattern.place(std::max(a, b), std::min(a, b));
      }
  place_leans(pattern);
  node_stride_.resize(sizes.size());
  for (size_t i = 0; i < sizes.size(); ++i) node_stride_[i] = pattern.stride(static_cast<int>(i));
}

// Numbers the leans of each triangle and couples them with its nodes.
void WallEnergy::couple_leans(int first_lean, BlockPattern& pattern) {
  if (leans_.empty()) return;
  std::vector<int> node_of(static_cast<size_t>(vertices_), -1);
  for (size_t i = 0; i < leans_.size(); ++i)
    node_of[static_cast<size_t>(leans_[i].vertex)] = first_lean + static_cast<int>(i);
  lean_places_.resize(sides_.size());
  for (size_t t = 0; t < sides_.size(); ++t) {
    auto& lean = lean_places_[t].node;
    for (size_t i = 0; i < 3; ++i)
      lean[i] = node_of[static_cast<size_t>(triangles_(static_cast<int>(t), static_cast<int>(i)))];
    for (size_t i = 0; i < 3; ++i) {
      if (lean[i] < 0) continue;
      for (const int other : places_[t].node)
        if (other >= 0) pattern.couple(lean[i], other);
      for (size_t j = 0; j < i; ++j)
        if (lean[j] >= 0) pattern.couple(lean[i], lean[j]);
    }
  }
}

void WallEnergy::place_leans(const BlockPattern& pattern) {
  for (size_t t = 0; t < lean_places_.size(); ++t) {
    const auto& lean = lean_places_[t].node;
    const auto node_at = [&](size_t j) { return j < 9 ? places_[t].node[j] : lean[j - 9]; };
    for (size_t i = 0; i < 3; ++i)
      for (size_t j = 0; j < 12; ++j)
        if (const int other = node_at(j); lean[i] >= 0 && other >= 0)
          lean_places_[t].place[i][j] =
              pattern.place(std::max(lean[i], other), std::min(lean[i], other));
  }
}

namespace {

// Adds blocks into the lower triangle.
struct Adder {
  double* values;
  const std::vector<int>& stride;

  template <int Rows, int Columns>
  void add(int row_node, int column_node, int place,
           const Eigen::Matrix<double, Rows, Columns>& block) {
    if (row_node > column_node) {
      add_below(column_node, place, block);
    } else if (row_node < column_node) {
      add_below(row_node, place, block.transpose().eval());
    } else {
      // The same node occurs twice: its diagonal block, of which only the lower half is stored.
      if constexpr (Rows == Columns)
        add_diagonal(row_node, place, (block + block.transpose()).eval());
    }
  }

  template <typename Block>
  void add_diagonal(int node, int place, const Block& block) {
    double* column = values + place;
    for (int c = 0; c < block.cols(); ++c) {
      for (int r = c; r < block.rows(); ++r) column[r] += block(r, c);
      column += stride[static_cast<size_t>(node)] - c;
    }
  }

 private:
  template <typename Block>
  void add_below(int column_node, int place, const Block& block) {
    double* column = values + place;
    for (int c = 0; c < block.cols(); ++c) {
      for (int r = 0; r < block.rows(); ++r) column[r] += block(r, c);
      column += stride[static_cast<size_t>(column_node)] - c;
    }
  }
};

}  // namespace

// Derivatives of (C, theta or b) with respect to the triangle's own vertices, and of theta_k or b_k
// with respect to the node across edge k.
struct WallEnergy::TriangleDerivatives {
  Mat69 own = Mat69::Zero();
  std::array<Vec3, 3> across;
};

WallEnergy::TriangleDerivatives WallEnergy::derivatives(const Eigen::VectorXd& q, const Geometry& g,
                                                        int triangle, const Deformation& f) const {
  const auto v = triangles_.row(triangle);
  const Sides& sides = sides_[static_cast<size_t>(triangle)];
  TriangleDerivatives d;
  d.own.topRows<3>() = metric_by_vertices(triangle_rest_[static_cast<size_t>(triangle)], f);
  for (int k = 0; k < 3; ++k) {
    const int edge = sides.edge[static_cast<size_t>(k)];
    const WallEdge& wall_edge = edges_[static_cast<size_t>(edge)];
    Vec3& outer = d.across[static_cast<size_t>(k)];
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    if (wall_edge.glued) {
      const Vec3 m = q.segment<3>(wall_edge.unknown);
      d.own.block<1, 3>(3 + k, 3 * i) = d.own.block<1, 3>(3 + k, 3 * j) = m.transpose();
      d.own.block<1, 3>(3 + k, 3 * k) = -2 * m.transpose();
      outer = point(q, v[i]) + point(q, v[j]) - 2 * point(q, v[k]);
    } else if (!wall_edge.rim) {
      const int which = sides.sign[k] > 0 ? 0 : 1;
      const int tail = which == 0 ? i : j, head = which == 0 ? j : i;
      const HingeSide mine = side(q, g, edge, which), other = side(q, g, edge, 1 - which);
      d.own.block<1, 3>(3 + k, 3 * tail) = (mine.gradient(0) + other.gradient(0)).transpose();
      d.own.block<1, 3>(3 + k, 3 * head) = (mine.gradient(1) + other.gradient(1)).transpose();
      d.own.block<1, 3>(3 + k, 3 * k) = mine.gradient(2).transpose();
      outer = other.gradient(2);
    } else {
      outer.setZero();
    }
  }
  return d;
}

std::vector<Vec6> WallEnergy::strain_change(const Eigen::VectorXd& q,
                                            const Eigen::VectorXd& change) const {
  const Geometry g = geometry(q, whole_);
  std::vector<Vec6> all;
  for (int t = 0; t < triangles_.rows(); ++t) {
    const Deformation f = deformation(q, t);
    const TriangleEnergy e = triangle_energy(law_, triangle_rest_[static_cast<size_t>(t)],
                                             state(q, g, t, f), SecondDerivatives::all);
    const TriangleDerivatives d = derivatives(q, g, t, f);
    Vec9 own;
    for (int k = 0; k < 3; ++k) own.segment<3>(3 * k) = point(change, triangles_(t, k));
    Vec9 scalars;
    scalars.head<6>() = d.own * own;
    const Sides& sides = sides_[static_cast<size_t>(t)];
    for (int k = 0; k < 3; ++k) {
      const auto at = static_cast<size_t>(k);
      const WallEdge& edge = edges_[static_cast<size_t>(sides.edge[at])];
      const int outer = edge.glued ? edge.unknown : 3 * sides.neighbour[at];
      if (outer >= 0) scalars[3 + k] += d.across[at].dot(change.segment<3>(outer));
      scalars[6 + k] = edge.glued ? 0 : sides.sign[k] * change[edge.unknown];
    }
    all.push_back(e.strain_slopes * scalars);
    const auto& leaning = triangle_rest_[static_cast<size_t>(t)].leaning;
    if (!leaning) continue;
    for (int k = 0; k < 3; ++k)
      if (const int at = lean_unknown_[static_cast<size_t>(triangles_(t, k))]; at >= 0)
        all.back() += change[at] * leaning->strains.col(k);
  }
  return all;
}

const Eigen::SparseMatrix<double>& WallEnergy::hessian(const Eigen::VectorXd& q,
                                                       SecondDerivatives second) {
  return hessian(q, whole_, second);
}

const Eigen::SparseMatrix<double>& WallEnergy::hessian(const Eigen::VectorXd& q,
                                                       const WallPart& part,
                                                       SecondDerivatives second) {
  const Geometry g = geometry(q, part);
  double* values = hessian_.valuePtr();
  std::fill(values, values + hessian_.nonZeros(), 0.0);
  std::vector<double> by_angle(edges_.size(), 0);
  for (const int t : part.triangles) {
    const Deformation f = deformation(q, t);
    const TriangleEnergy e =
        triangle_energy(law_, triangle_rest_[static_cast<size_t>(t)], state(q, g, t, f), second);
    const Sides& sides = sides_[static_cast<size_t>(t)];
    for (int k = 0; k < 3; ++k)
      if (const auto edge = static_cast<size_t>(sides.edge[static_cast<size_t>(k)]);
          !edges_[edge].rim)
        by_angle[edge] += e.gradient[3 + k];
    const TriangleDerivatives d = derivatives(q, g, t, f);
    add_triangle(static_cast<size_t>(t), e, d, second, values);
    if (triangle_rest_[static_cast<size_t>(t)].leaning)
      add_leans(static_cast<size_t>(t), e, d, values);
  }
  if (second == SecondDerivatives::all) add_hinges(q, g, part, by_angle, values);
  add_partners(q, part, values);
  return hessian_;
}

// Adds the energy of one triangle, from derivatives in its nine scalars to derivatives in the
// unknowns.
void WallEnergy::add_triangle(size_t t, const TriangleEnergy& e, const TriangleDerivatives& d,
                              SecondDerivatives second, double* values) const {
  Adder adder{values, node_stride_};
  const TriangleRest& rest = triangle_rest_[t];
  const Sides& sides = sides_[t];
  const auto& node = places_[t].node;
  const auto& place = places_[t].place;
  const Mat69 half = e.hessian.topLeftCorner<6, 6>() * d.own;
  Mat9 block = d.own.transpose() * half;
  Eigen::Matrix2d tension;
  tension << 2 * e.gradient[0], e.gradient[2], e.gradient[2], 2 * e.gradient[1];
  const bool all = second == SecondDerivatives::all;
  if (!all) tension = in_tension(tension);
  const Mat3 scalar = rest.gradients.transpose() * tension * rest.gradients;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) block.block<3, 3>(3 * i, 3 * j).diagonal().array() += scalar(i, j);
    const auto si = static_cast<size_t>(i);
    adder.add_diagonal(node[si], place[static_cast<size_t>(pair(i, i))],
                       block.block<3, 3>(3 * i, 3 * i));
    for (int j = 0; j < i; ++j)
      adder.add<3, 3>(node[si], node[static_cast<size_t>(j)],
                      place[static_cast<size_t>(pair(i, j))], block.block<3, 3>(3 * i, 3 * j));
  }
  for (int k = 0; k < 3; ++k) {
    const int outer = node[static_cast<size_t>(3 + k)], xi = node[static_cast<size_t>(6 + k)];
    const WallEdge& edge = edges_[static_cast<size_t>(sides.edge[static_cast<size_t>(k)])];
    if (outer >= 0) {
      const Vec3& a = d.across[static_cast<size_t>(k)];
      const Row9 row = half.row(3 + k);
      for (int j = 0; j < 3; ++j) {
        Mat3 b = a * row.segment<3>(3 * j);
        // b_k is bilinear in the normal of the rim and the vertices.
        if (edge.glued && all) b.diagonal().array() += e.gradient[3 + k] * (j == k ? -2 : 1);
        adder.add<3, 3>(outer, node[static_cast<size_t>(j)],
                        place[static_cast<size_t>(pair(3 + k, j))], b);
      }
      for (int l = 0; l <= k; ++l) {
        const int other = node[static_cast<size_t>(3 + l)];
        if (other < 0) continue;
        const Mat3 b = e.hessian(3 + k, 3 + l) * a * d.across[static_cast<size_t>(l)].transpose();
        const int at = place[static_cast<size_t>(pair(3 + k, 3 + l))];
        if (l == k)
          adder.add_diagonal(outer, at, b);
        else
          adder.add<3, 3>(outer, other, at, b);
      }
    }
    if (xi < 0) continue;
    const double sign = sides.sign[k];
    const Row9 row = sign * e.hessian.block<1, 6>(6 + k, 0) * d.own;
    for (int j = 0; j < 3; ++j)
      adder.add<1, 3>(xi, node[static_cast<size_t>(j)], place[static_cast<size_t>(pair(6 + k, j))],
                      row.segment<3>(3 * j));
    for (int l = 0; l < 3; ++l) {
      const int other = node[static_cast<size_t>(3 + l)];
      if (other < 0) continue;
      adder.add<1, 3>(
          xi, other, place[static_cast<size_t>(pair(6 + k, 3 + l))],
          sign * e.hessian(6 + k, 3 + l) * d.across[static_cast<size_t>(l)].transpose());
    }
    for (int l = 0; l <= k; ++l) {
      if (node[static_cast<size_t>(6 + l)] < 0) continue;
      values[place[static_cast<size_t>(pair(6 + k, 6 + l))]] +=
          sign * sides.sign[l] * e.hessian(6 + k, 6 + l);
    }
  }
}

// Adds what the leans of a triangle have to do with its scalars and with each other.
void WallEnergy::add_leans(size_t t, const TriangleEnergy& e, const TriangleDerivatives& d,
                           double* values) const {
  Adder adder{values, node_stride_};
  const auto& node = places_[t].node;
  const LeanPlaces& leans = lean_places_[t];
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<size_t>(i);
    const int lean = leans.node[at];
    if (lean < 0) continue;
    const auto& place = leans.place[at];
    const Vec9 slope = e.lean_slopes.col(i);
    const Row9 own = slope.head<6>().transpose() * d.own;
    for (int k = 0; k < 3; ++k) {
      const auto n = static_cast<size_t>(k);
      adder.add<1, 3>(lean, node[n], place[n], own.segment<3>(3 * k));
      if (node[3 + n] >= 0)
        adder.add<1, 3>(lean, node[3 + n], place[3 + n], slope[3 + k] * d.across[n].transpose());
      if (node[6 + n] >= 0) values[place[6 + n]] += sides_[t].sign[k] * slope[6 + k];
      if (k <= i && leans.node[n] >= 0) values[place[9 + n]] += e.lean_hessian(i, k);
    }
  }
}

// Adds the second derivatives of the angles themselves. Each side's contribution stays within its
// own triangle.
void WallEnergy::add_hinges(const Eigen::VectorXd& q, const Geometry& g, const WallPart& part,
                            const std::vector<double>& by_angle,
                            // NOLINTNEXTLINE(readability-non-const-parameter) the adder writes
                            double* values) const {
  Adder adder{values, node_stride_};
  for (const int triangle : part.triangles)
    for (int k = 0; k < 3; ++k) {
      const auto t = static_cast<size_t>(triangle);
      const int edge = sides_[t].edge[static_cast<size_t>(k)];
      if (edges_[static_cast<size_t>(edge)].rim) continue;
      const int which = sides_[t].sign[k] > 0 ? 0 : 1;
      const HingeSide hinge = side(q, g, edge, which);
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const std::array<int, 3> local{which == 0 ? i : j, which == 0 ? j : i, k};
      const double factor = by_angle[static_cast<size_t>(edge)];
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
          const int a = local[static_cast<size_t>(r)], b = local[static_cast<size_t>(c)];
          if (a < b) continue;
          const Mat3 block = factor * hinge.hessian(r, c);
          const int at = places_[t].place[static_cast<size_t>(pair(a, b))];
          if (a == b)
            adder.add_diagonal(triangles_(triangle, a), at, block);
          else
            adder.add<3, 3>(triangles_(triangle, a), triangles_(triangle, b), at, block);
        }
    }
}

// Adds the products of the shears of partners.
// NOLINTNEXTLINE(readability-non-const-parameter) the adder writes to the values
void WallEnergy::add_partners(const Eigen::VectorXd& q, const WallPart& part,
                              double* values) const {
  Adder adder{values, node_stride_};
  const auto by_vertices = [&](size_t t) -> Row9 {
    const Deformation f = deformation(q, static_cast<int>(t));
    return membrane_strain(law_, metric_of(f)).derivative.row(2) *
           metric_by_vertices(triangle_rest_[t], f);
  };
  for (const int triangle : part.triangles) {
    const auto t = static_cast<size_t>(triangle);
    if (!(triangle_rest_[t].relief > 0)) continue;
    const auto other = static_cast<size_t>(partner_[t]);
    if (t > other) continue;
    const Row9 mine = by_vertices(t), its = by_vertices(other);
    const Places& at = places_[t];
    for (int j = 0; j < 3; ++j) {
      // Each vertex of the partner is either a vertex of the triangle or lies across one of its
      // edges.
      const int node = triangles_(static_cast<int>(other), j);
      const auto local =
          static_cast<int>(std::find(at.node.begin(), at.node.end(), node) - at.node.begin());
      for (int i = 0; i < 3; ++i) {
        const Mat3 block =
            triangle_rest_[t].relief * mine.segment<3>(3 * i).transpose() * its.segment<3>(3 * j);
        adder.add<3, 3>(at.node[static_cast<size_t>(i)], node,
                        at.place[static_cast<size_t>(pair(std::max(i, local), std::min(i, local)))],
                        block);
      }
    }
  }
}

}  // namespace vasorod
