// The model of one vessel of a join, and the stress of its wall.
#pragma once

#include <memory>
#include <vector>

#include "reference_fem/join_mesh.h"
#include "reference_fem/system.h"
#include "reference_fem/vessel_model.h"

namespace vasorod::fem {

/// One wall's model and the sections of its ends.
struct WallModel {
  std::unique_ptr<VesselModel> model;
  std::vector<Section> sections;
};
WallModel wall_model(const JoinWall& wall, const Mesh& mesh);

/// Keeps a node's displacement, and a shell's director, in the planes with normal x and y. Not
/// `displacement`: the director only.
void hold_in_planes(const std::array<bool, 2>& planes, int first_dof, int components,
                    bool displacement, Supports& supports);

/// The displacement behind the prestress of each vessel.
struct SeenDisplacements {
  SeenShare vein, artery;
};

/// Gives the models of a join the stress that both vessels had when they were seen, neither cut nor
/// incised. Their displacement is solved on `make_seen_mesh`, and taken over by the join's nodes
/// where both have the same cells. Around an elliptic hole only that of its rim is, interpolated;
/// the rest is solved again on the join's cells. So the edges alone are out of balance.
SeenDisplacements prestress_join(const JoinProblem& problem, const JoinCells& cells,
                                 const JoinMesh& mesh, VesselModel& vein, VesselModel& artery,
                                 const Processes& processes);

}  // namespace vasorod::fem
