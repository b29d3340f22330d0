#include <gtest/gtest.h>

#include "propose/proposed_wall.h"

namespace vasorod {
namespace {

TEST(ProposedWall, VesselsAreRecognisedByTheWordsOfTheirNames) {
  for (const char* name : {"svc", "SVC_outer", "superior_vena_cava", "vena-cava", "patient3_svc_2"})
    EXPECT_EQ(kind_of(name), VesselKind::superior_vena_cava) << name;
  for (const char* name :
       {"pa", "RPA", "pulmonary_artery", "right-pulmonary-artery", "rpa_remeshed"})
    EXPECT_EQ(kind_of(name), VesselKind::pulmonary_artery) << name;
  for (const char* name : {"aorta", "Aorta_1", "ao"}) EXPECT_EQ(kind_of(name), VesselKind::aorta);
  for (const char* name :
       {"heart", "pulmonary_vein", "ivc", "inferior_vena_cava", "spa", "vessel", "", "7"})
    EXPECT_EQ(kind_of(name), VesselKind::other) << name;
}

// ADAN-86: 1.18 mm and 0.80 MPa at a radius of 9.75 mm; the proposal has two digits.
TEST(ProposedWall, AnAdultsVenaCavaIsThatOfTheModelItCites) {
  const ProposedWall wall = propose_wall(VesselKind::superior_vena_cava, 9.75, 1);
  EXPECT_NEAR(wall.thickness, 1.18, 0.05);
  EXPECT_EQ(wall.young, 0.8);
  EXPECT_NE(wall.source.find("ADAN-86"), std::string::npos);
}

TEST(ProposedWall, AChildsWallsLieInTheRangesTheyState) {
  const ProposedWall vein = propose_wall(VesselKind::superior_vena_cava, 3.3, 1),
                     artery = propose_wall(VesselKind::pulmonary_artery, 3.5, 1);
  EXPECT_GT(vein.young, 0.3);
  EXPECT_LT(vein.young, 0.8);
  EXPECT_NE(vein.source.find("0.3 to 0.8 MPa"), std::string::npos);
  EXPECT_GT(artery.young, 0.3);
  EXPECT_LT(artery.young, 0.6);
  EXPECT_NE(artery.source.find("0.3 to 0.6 MPa"), std::string::npos);
}

TEST(ProposedWall, TheUnitOfTheRadiusIsThatOfTheThickness) {
  for (const auto kind : {VesselKind::superior_vena_cava, VesselKind::pulmonary_artery,
                          VesselKind::aorta, VesselKind::other}) {
    const ProposedWall mm = propose_wall(kind, 9.0, 1), cm = propose_wall(kind, 0.9, 10);
    EXPECT_NEAR(cm.thickness, 0.1 * mm.thickness, 1e-12);
    EXPECT_EQ(cm.young, mm.young);
  }
}

}  // namespace
}  // namespace vasorod
