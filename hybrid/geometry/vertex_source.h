// Sources of the vertices of an edited surface: arrays and labels follow them.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace vasorod {

/// One vertex as a weighted mean of vertices of the input surface: p = sum_k weight[k] *
/// p_input[vertex[k]], weights summing to 1. An unchanged vertex has one entry, a vertex made on an
/// edge two, one inside a triangle three; several edits may add more. Sorted by vertex.
struct VertexSource {
  std::vector<int> vertex;
  std::vector<double> weight;

  static VertexSource original(int index) { return {{index}, {1.0}}; }
  bool is_original() const { return vertex.size() == 1; }
  int dominant() const;  ///< input vertex with the largest weight; among equals, the lowest index
};

/// One entry per vertex of the edited surface.
using VertexSources = std::vector<VertexSource>;

/// sum of weight * source: the source of a vertex that is a weighted mean of vertices with these
/// sources.
VertexSource blend(const std::vector<const VertexSource*>& sources,
                   const std::vector<double>& weights);

/// Sources of two successive edits: those of the last edit, in the input of the first.
VertexSources compose(const VertexSources& last, const VertexSources& first);

/// Values at the edited surface's vertices from values at the input's vertices (one row each).
Eigen::MatrixXd interpolate(const VertexSources& sources,
                            const Eigen::Ref<const Eigen::MatrixXd>& values);

/// Labels cannot be averaged: each vertex gets the label of its dominant source.
std::vector<int> carry_labels(const VertexSources& sources, const std::vector<int>& labels);

}  // namespace vasorod
