// Where the vertices of an edited surface come from, so that arrays and labels can follow them.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace vasorod {

/// One vertex as a weighted mean of vertices of the input surface: p = sum_k weight[k] *
/// p_input[vertex[k]], weights summing to 1. A vertex that surgery left alone has one entry; one
/// made on an edge two; one inside a triangle three; several steps in a row may add more. Sorted by
/// vertex.
struct VertexSource {
  std::vector<int> vertex;
  std::vector<double> weight;

  static VertexSource original(int index) { return {{index}, {1.0}}; }
  bool is_original() const { return vertex.size() == 1; }
  int dominant() const;  ///< the input vertex with the largest weight (the lowest index of equals)
};

/// One entry per vertex of the edited surface.
using VertexSources = std::vector<VertexSource>;

/// sum of weight * source: what a vertex comes from that is made of vertices with these sources.
VertexSource blend(const std::vector<const VertexSource*>& sources,
                   const std::vector<double>& weights);

/// What the vertices of the last of two edits come from in the input of the first.
VertexSources compose(const VertexSources& last, const VertexSources& first);

/// Values at the edited surface's vertices from values at the input's (rows are vertices).
Eigen::MatrixXd interpolate(const VertexSources& sources,
                            const Eigen::Ref<const Eigen::MatrixXd>& values);

/// Labels cannot be averaged: each vertex takes the label of its dominant source.
std::vector<int> carry_labels(const VertexSources& sources, const std::vector<int>& labels);

}  // namespace vasorod
