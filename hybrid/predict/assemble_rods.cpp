#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/scene_place.h"
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

// Fractions of a piece closer than this are one.
constexpr double same_fraction = 1e-9;

/// Fractions along one piece where elements begin and end. `inside`: further fractions that must be
/// nodes, ascending.
std::vector<double> stations(const RodPiece& piece, const std::vector<double>& inside, int refine) {
  std::vector<double> coarse;
  coarse.reserve(static_cast<std::size_t>(piece.elements) + 1 + inside.size());
  for (int i = 0; i <= piece.elements; ++i)
    coarse.push_back(static_cast<double>(i) / piece.elements);
  const auto regular = static_cast<std::ptrdiff_t>(coarse.size());
  for (const double f : inside) {
    const double nearest = std::round(f * piece.elements) / piece.elements;
    if (std::abs(nearest - f) >= same_fraction &&
        (static_cast<std::ptrdiff_t>(coarse.size()) == regular ||
         f - coarse.back() >= same_fraction))
      coarse.push_back(f);
  }
  std::inplace_merge(coarse.begin(), coarse.begin() + regular, coarse.end());
  std::vector<double> fine{0};
  fine.reserve((coarse.size() - 1) * static_cast<std::size_t>(refine) + 1);
  for (std::size_t i = 0; i + 1 < coarse.size(); ++i)
    for (int j = 1; j <= refine; ++j)
      fine.push_back(coarse[i] + (coarse[i + 1] - coarse[i]) * j / refine);
  return fine;
}

class Assembler {
 public:
  Assembler(const Scene& scene, int refine)
      : scene_(scene), refine_(refine), place_(scene.vessels.size()) {
    for (std::size_t v = 0; v < scene.vessels.size(); ++v)
      index_of_.emplace(scene.vessels[v].name, v);
    for (const EndCondition& end : scene.ends)
      if (end.end.kind == EndSelector::Kind::at) nodes_at_[end.vessel].push_back(end.end.at);
    for (auto& [vessel, fractions] : nodes_at_) std::sort(fractions.begin(), fractions.end());
  }

  std::vector<RodAssembly> run() {
    for (std::size_t v = 0; v < scene_.vessels.size(); ++v)
      if (scene_.vessels[v].rod) add_with_parents(v);
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
    if (const auto known = index_of_.find(name); known != index_of_.end()) return known->second;
    throw InputError(place_in(scene_) + ": vessel '" + name + "' is not in the scene");
  }

  // Adds a rod after its parents. A loop and not a recursion: chains may be thousands of rods long.
  void add_with_parents(std::size_t v) {
    std::vector<std::size_t> chain;
    while (place_[v].branch < 0) {
      const VesselSpec& vessel = scene_.vessels[v];
      const std::string where = place_in(scene_) + ": vessel '" + vessel.name + "'";
      if (place_[v].visiting)
        throw InputError(where + ": rods are each other's parents, expected a tree with one root");
      place_[v].visiting = true;
      chain.push_back(v);
      if (!vessel.rod->parent) break;
      v = named(*vessel.rod->parent);
      if (!scene_.vessels[v].rod)
        throw InputError(where + ": parent '" + *vessel.rod->parent + "' is not a bare rod");
    }
    for (std::size_t i = chain.size(); i-- > 0;) add(chain[i]);
  }

  // Adds a rod whose parent is there.
  void add(std::size_t v) {
    Place& place = place_[v];
    const VesselSpec& vessel = scene_.vessels[v];
    const RodSpec& rod = *vessel.rod;
    RodBranch branch;
    branch.name = vessel.name;
    Pose start = start_frame(rod), pose = start;
    if (rod.parent) {
      const std::size_t p = named(*rod.parent);
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
    const auto known = nodes_at_.find(vessel.name);
    const std::vector<double> wanted =
        known != nodes_at_.end() ? known->second : std::vector<double>{};
    for (const RodPiece& piece : vessel.rod->pieces) {
      std::vector<double> inside;
      for (const double at : wanted) {
        const double f = (at * total - before) / piece.length;
        if (f > same_fraction && f < 1 - same_fraction) inside.push_back(f);
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
      case EndSelector::Kind::face:  // the reader refuses it on a bare rod
        break;
    }
    const double s = end.end.at * place.abscissa.back();
    const auto after = std::lower_bound(place.abscissa.begin(), place.abscissa.end(), s);
    const auto i = static_cast<std::size_t>(after - place.abscissa.begin());
    if (i == 0) return nodes.front();
    if (i == nodes.size()) return nodes.back();
    return nodes[s - place.abscissa[i - 1] <= place.abscissa[i] - s ? i - 1 : i];
  }

  void add(const EndCondition& end) {
    const Place& place = place_[named(end.vessel)];
    if (place.branch < 0) return;  // not a bare rod
    RodAssembly& assembly = assemblies_[index(place.assembly)];
    const int node = node_of(end, place);
    const auto [known, is_new] =
        end_of_node_.try_emplace({place.assembly, node}, assembly.ends.size());
    if (is_new) assembly.ends.push_back({end.vessel, to_string(end.end), node, -1});
    RodAssembly::End* found = &assembly.ends[known->second];
    RodSupport support = clamp(node);
    if (!end.hold && !end.rotate_deg && !end.move) support.fixed = end.fix;
    support.motion.rotate = end.rotate_deg.value_or(Vec3::Zero()) * (M_PI / 180);
    support.motion.move = end.move.value_or(Vec3::Zero());
    if (std::any_of(support.fixed.begin(), support.fixed.end(), [](bool f) { return f; })) {
      if (found->support >= 0)
        throw InputError(place_in(scene_, end.line) + ": " + to_string(end.end) + " of '" +
                         end.vessel +
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
  std::unordered_map<std::string, std::size_t> index_of_;          // of the vessels, by name
  std::unordered_map<std::string, std::vector<double>> nodes_at_;  // fractions, ascending
  std::map<std::pair<int, int>, std::size_t> end_of_node_;         // by assembly and node
  std::vector<RodAssembly> assemblies_;
};

}  // namespace

std::vector<RodAssembly> assemble_rods(const Scene& scene, int refine) {
  return Assembler(scene, refine).run();
}

}  // namespace vasorod
