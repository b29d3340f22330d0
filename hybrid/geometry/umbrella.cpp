#include "geometry/umbrella.h"

namespace vasorod {

Umbrella::Umbrella(const std::vector<Edge>& edges, int vertex_count) {
  const auto index = [](int i) { return static_cast<size_t>(i); };
  first_.assign(index(vertex_count) + 1, 0);
  for (const Edge& e : edges) {
    ++first_[index(e.a) + 1];
    ++first_[index(e.b) + 1];
  }
  for (size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  neighbour_.resize(2 * edges.size());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (const Edge& e : edges) {
    neighbour_[index(next[index(e.a)]++)] = e.b;
    neighbour_[index(next[index(e.b)]++)] = e.a;
  }
}

Points Umbrella::apply(const Eigen::Ref<const Points>& points) const {
  Points l = Points::Zero(points.rows(), 3);
  const double* p = points.data();
  const Eigen::Index stride = points.outerStride();
  for (int i = 0; i < vertex_count(); ++i) {
    const int begin = first_[static_cast<size_t>(i)], end = first_[static_cast<size_t>(i) + 1];
    if (begin == end) continue;
    double sum[3] = {0, 0, 0};
    for (int k = begin; k < end; ++k) {
      const double* q = p + stride * neighbour_[static_cast<size_t>(k)];
      for (int c = 0; c < 3; ++c) sum[c] += q[c];
    }
    const double weight = 1.0 / (end - begin);
    for (int c = 0; c < 3; ++c) l(i, c) = weight * sum[c] - p[stride * i + c];
  }
  return l;
}

void Umbrella::add_transpose(const Eigen::Ref<const Points>& field, double factor,
                             Eigen::Ref<Points> out) const {
  const double* f = field.data();
  double* o = out.data();
  const Eigen::Index field_stride = field.outerStride(), stride = out.outerStride();
  for (int i = 0; i < vertex_count(); ++i) {
    const int begin = first_[static_cast<size_t>(i)], end = first_[static_cast<size_t>(i) + 1];
    if (begin == end) continue;
    const double weight = factor / (end - begin);
    double share[3];
    for (int c = 0; c < 3; ++c) {
      share[c] = weight * f[field_stride * i + c];
      o[stride * i + c] -= factor * f[field_stride * i + c];
    }
    for (int k = begin; k < end; ++k) {
      double* q = o + stride * neighbour_[static_cast<size_t>(k)];
      for (int c = 0; c < 3; ++c) q[c] += share[c];
    }
  }
}

double Umbrella::add_misfit(const Eigen::Ref<const Points>& points,
                            const Eigen::Ref<const Points>& target, double factor,
                            Eigen::Ref<Points> out) const {
  const double *p = points.data(), *t = target.data();
  double* o = out.data();
  const Eigen::Index point_stride = points.outerStride(), target_stride = target.outerStride(),
                     stride = out.outerStride();
  double squares[3] = {0, 0, 0};
  for (int i = 0; i < vertex_count(); ++i) {
    const int begin = first_[static_cast<size_t>(i)], end = first_[static_cast<size_t>(i) + 1];
    double misfit[3];
    for (int c = 0; c < 3; ++c) misfit[c] = -t[target_stride * i + c];
    if (begin < end) {
      double sum[3] = {0, 0, 0};
      for (int k = begin; k < end; ++k) {
        const double* q = p + point_stride * neighbour_[static_cast<size_t>(k)];
        for (int c = 0; c < 3; ++c) sum[c] += q[c];
      }
      const double weight = 1.0 / (end - begin);
      double share[3];
      for (int c = 0; c < 3; ++c) {
        misfit[c] += weight * sum[c] - p[point_stride * i + c];
        share[c] = factor * weight * misfit[c];
        o[stride * i + c] -= factor * misfit[c];
      }
      for (int k = begin; k < end; ++k) {
        double* q = o + stride * neighbour_[static_cast<size_t>(k)];
        for (int c = 0; c < 3; ++c) q[c] += share[c];
      }
    }
    for (int c = 0; c < 3; ++c) squares[c] += misfit[c] * misfit[c];
  }
  return squares[0] + squares[1] + squares[2];
}

Eigen::SparseMatrix<double> Umbrella::matrix() const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(neighbour_.size() + first_.size());
  for (int i = 0; i < vertex_count(); ++i) {
    const int begin = first_[static_cast<size_t>(i)], end = first_[static_cast<size_t>(i) + 1];
    if (begin == end) continue;
    entries.emplace_back(i, i, -1.0);
    for (int k = begin; k < end; ++k)
      entries.emplace_back(i, neighbour_[static_cast<size_t>(k)], 1.0 / (end - begin));
  }
  Eigen::SparseMatrix<double> l(vertex_count(), vertex_count());
  l.setFromTriplets(entries.begin(), entries.end());
  return l;
}

}  // namespace vasorod
