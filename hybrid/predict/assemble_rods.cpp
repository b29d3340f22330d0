#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "data/index.h"
#include "geometry/rigid_motion.h"
#include "predict/rod_scene.h"

namespace vasorod {
namespace {

Pose start_frame(const RodSpec& rod) {
  Pose pose;
  pose.position = rod.position;
  const Vec3 d3 = rod.tangent.normalized(),
             d1 = (rod.normal - d3 * d3.dot(rod.normal)).normalized();
  pose.rotation << d1, d3.cross(d1), d3;
  return pose;
}

/// Fractions along one piece where elements begin and end. `inside`: further fractions that must be
/// nodes.
std::vector<double> stations(const RodPiece& piece, const std::vector<double>& inside, int refine) {
  std::vector<double> coarse;
  for (int i = 0; i <= piece.elements; ++i)
    coarse.push_back(static_cast<double>(i) / piece.elements);
  for (const double f : inside) {
    const auto near = [&](double x) { return std::abs(x - f) < 1e-9; };
    if (std::none_of(coarse.begin(), coarse.end(), near)) coarse.push_back(f);
  }
  std::sort(coarse.begin(), coarse.end());
  std::vector<double> fine{0};
  for (std::size_t i = 0; i + 1 < coarse.size(); ++i)
    for (int j = 1; j <= refine; ++j)
      fine.push_back(coarse[i] + (coarse[i + 1] - coarse[i]) * j / refine);
  return fine;
}

class Assembler {
 public:
  Assembler(const Scene& scene, int refine)
      : scene_(scene), refine_(refine), place_(scene.vessels.size()) {}

  std::vector<RodAssembly> run() {
    for (std::size_t v = 0; v < scene_.vessels.size(); ++v)
      if (scene_.vessels[v].rod) add(v);
    for (const EndCondition& end : scene_.ends) add(end);
    return std::move(assemblies_);
  }

 private:
  struct Place {
    int assembly = -1, branch = -1;
    bool visiting = false;
    std::vector<double> abscissa;  // of the branch's nodes
  };

  std::size_t named(const std::string& name) const {
    for (std::size_t v = 0; v < scene_.vessels.size(); ++v)
      if (scene_.vessels[v].name == name) return v;
    throw InputError(scene_.file.string() + ": vessel '" + name + "' is not in the scene");
  }

  void add(std::size_t v) {
    Place& place = place_[v];
    if (place.branch >= 0) return;
    const VesselSpec& vessel = scene_.vessels[v];
    const std::string where = scene_.file.string() + ": vessel '" + vessel.name + "'";
    if (place.visiting)
      throw InputError(where + ": rods are each other's parents, expected a tree with one root");
    place.visiting = true;
    const RodSpec& rod = *vessel.rod;
    RodBranch branch;
    branch.name = vessel.name;
    Pose start = start_frame(rod), pose = start;
    if (rod.parent) {
      const std::size_t p = named(*rod.parent);
      if (!scene_.vessels[p].rod)
        throw InputError(where + ": parent '" + *rod.parent + "' is not a bare rod");
      add(p);
      place.assembly = place_[p].assembly;
      branch.parent = place_[p].branch;
      const RodTree& tree = assemblies_[index(place.assembly)].tree;
      branch.nodes.push_back(tree.branches[index(branch.parent)].nodes.back());
      pose = tree.rest[index(branch.nodes.front())] * start;
    } else {
      place.assembly = static_cast<int>(assemblies_.size());
      assemblies_.emplace_back();
      assemblies_.back().tree.rest.push_back(pose);
      branch.nodes.push_back(0);
      start = Pose{};
    }
    RodAssembly& assembly = assemblies_[index(place.assembly)];
    add_elements(vessel, branch, start, pose, place.abscissa, assembly.tree);
    place.branch = static_cast<int>(assembly.tree.branches.size());
    assembly.tree.branches.push_back(std::move(branch));
    assembly.vessels.push_back(vessel.name);
    place.visiting = false;
  }

  void add_elements(const VesselSpec& vessel, RodBranch& branch, const Pose& start, Pose pose,
                    std::vector<double>& abscissa, RodTree& tree) const {
    double total = 0, before = 0;
    for (const RodPiece& piece : vessel.rod->pieces) total += piece.length;
    abscissa.push_back(0);
    for (const RodPiece& piece : vessel.rod->pieces) {
      std::vector<double> inside;
      for (const EndCondition& end : scene_.ends)
        if (end.vessel == vessel.name && end.end.kind == EndSelector::Kind::at) {
          const double f = (end.end.at * total - before) / piece.length;
          if (f > 1e-9 && f < 1 - 1e-9) inside.push_back(f);
        }
      const std::vector<double> at = stations(piece, inside, refine_);
      for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        RodElement e;
        e.first = branch.nodes.back();
        e.second = tree.node_count();
        e.length = piece.length * (at[i + 1] - at[i]);
        e.rest_strain << 0, 0, 1, piece.curvature;
        e.natural_strain = piece.natural.value_or(e.rest_strain);
        const double middle = 0.5 * (at[i] + at[i + 1]);
        e.stiffness = piece.end_stiffness
                          ? Mat6((1 - middle) * piece.stiffness + middle * *piece.end_stiffness)
                          : piece.stiffness;
        if (branch.elements.empty()) e.start = start;
        pose = pose * exp_motion(e.length * e.rest_strain);
        tree.rest.push_back({nearest_rotation(pose.rotation), pose.position});
        branch.elements.push_back(static_cast<int>(tree.elements.size()));
        branch.nodes.push_back(e.second);
        abscissa.push_back(before + piece.length * at[i + 1]);
        tree.elements.push_back(e);
      }
      before += piece.length;
    }
  }

  int node_of(const EndCondition& end, const Place& place) const {
    const RodTree& tree = assemblies_[index(place.assembly)].tree;
    const std::vector<int>& nodes = tree.branches[index(place.branch)].nodes;
    switch (end.end.kind) {
      case EndSelector::Kind::start:
        return nodes.front();
      case EndSelector::Kind::end:
        return nodes.back();
      case EndSelector::Kind::near: {
        const auto distance = [&](int node) {
          return (tree.rest[index(node)].position - end.end.near).norm();
        };
        return distance(nodes.front()) <= distance(nodes.back()) ? nodes.front() : nodes.back();
      }
      case EndSelector::Kind::at:
        break;
    }
    const double s = end.end.at * place.abscissa.back();
    std::size_t best = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (std::abs(place.abscissa[i] - s) < std::abs(place.abscissa[best] - s)) best = i;
    return nodes[best];
  }

  void add(const EndCondition& end) {
    const Place& place = place_[named(end.vessel)];
    if (place.branch < 0) return;  // not a bare rod
    RodAssembly& assembly = assemblies_[index(place.assembly)];
    const int node = node_of(end, place);
    auto found = std::find_if(assembly.ends.begin(), assembly.ends.end(),
                              [&](const RodAssembly::End& e) { return e.node == node; });
    if (found == assembly.ends.end()) {
      assembly.ends.push_back({end.vessel, to_string(end.end), node, -1});
      found = assembly.ends.end() - 1;
    }
    RodSupport support = clamp(node);
    if (!end.hold && !end.rotate_deg && !end.move) support.fixed = end.fix;
    support.motion.rotate = end.rotate_deg.value_or(Vec3::Zero()) * (M_PI / 180);
    support.motion.move = end.move.value_or(Vec3::Zero());
    if (std::any_of(support.fixed.begin(), support.fixed.end(), [](bool f) { return f; })) {
      if (found->support >= 0)
        throw InputError(scene_.file.string() + ":" + std::to_string(end.line) + ": " +
                         to_string(end.end) + " of '" + end.vessel +
                         "' is supported a second time, expected one support per place");
      found->support = static_cast<int>(assembly.conditions.supports.size());
      assembly.conditions.supports.push_back(support);
    }
    if (end.force || end.moment)
      assembly.conditions.loads.push_back({node, end.force.value_or(Vec3::Zero()),
                                           end.moment.value_or(Vec3::Zero()), end.moment_in_body});
  }

  const Scene& scene_;
  int refine_;
  std::vector<Place> place_;
  std::vector<RodAssembly> assemblies_;
};

}  // namespace

std::vector<RodAssembly> assemble_rods(const Scene& scene, int refine) {
  return Assembler(scene, refine).run();
}

}  // namespace vasorod
