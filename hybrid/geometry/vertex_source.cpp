#include "geometry/vertex_source.h"

#include <cmath>
#include <map>

namespace vasorod {

int VertexSource::dominant() const {
  size_t best = 0;
  for (size_t k = 1; k < vertex.size(); ++k)
    if (weight[k] > weight[best]) best = k;
  return vertex[best];
}

VertexSource blend(const std::vector<const VertexSource*>& sources,
                   const std::vector<double>& weights) {
  std::map<int, double> sum;
  for (size_t i = 0; i < sources.size(); ++i)
    for (size_t k = 0; k < sources[i]->vertex.size(); ++k)
      sum[sources[i]->vertex[k]] += weights[i] * sources[i]->weight[k];
  VertexSource result;
  for (const auto& [vertex, weight] : sum) {
    if (weight == 0) continue;
    result.vertex.push_back(vertex);
    result.weight.push_back(weight);
  }
  return result;
}

VertexSources compose(const VertexSources& last, const VertexSources& first) {
  VertexSources result;
  result.reserve(last.size());
  for (const VertexSource& source : last) {
    std::vector<const VertexSource*> parts;
    for (const int v : source.vertex) parts.push_back(&first[static_cast<size_t>(v)]);
    result.push_back(blend(parts, source.weight));
  }
  return result;
}

Eigen::MatrixXd interpolate(const VertexSources& sources,
                            const Eigen::Ref<const Eigen::MatrixXd>& values) {
  Eigen::MatrixXd result =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(sources.size()), values.cols());
  for (size_t i = 0; i < sources.size(); ++i)
    for (size_t k = 0; k < sources[i].vertex.size(); ++k)
      result.row(static_cast<Eigen::Index>(i)) +=
          sources[i].weight[k] * values.row(sources[i].vertex[k]);
  return result;
}

std::vector<int> carry_labels(const VertexSources& sources, const std::vector<int>& labels) {
  std::vector<int> result;
  result.reserve(sources.size());
  for (const VertexSource& source : sources)
    result.push_back(labels[static_cast<size_t>(source.dominant())]);
  return result;
}

}  // namespace vasorod
