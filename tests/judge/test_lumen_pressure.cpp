#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "judge/lumen_pressure.h"

namespace vasorod {
namespace {

const Units millimetres{"mm", "MPa", 1e-3, 1e6};

PreparedVessel infant_vein(LumenPressure pressure) {
  PreparedVessel vessel;
  vessel.spec.name = "svc";
  vessel.spec.wall = Wall{0.4, Material::isotropic(0.5, 0.45)};
  vessel.spec.pressure = pressure;
  vessel.vessel.mean_radius = 3.3;
  return vessel;
}

// D = 3.34e-3 N mm, 3 D / R^3 = 2.1 mmHg.
TEST(LumenPressure, TheCollapsePressureOfAnInfantsVein) {
  const double critical = collapse_pressure(Material::isotropic(0.5, 0.45), 0.4, 3.3);
  EXPECT_NEAR(critical / 133.322e-6, 2.1, 0.02);
  EXPECT_NEAR(critical, 3 * 3.344e-3 / (3.3 * 3.3 * 3.3), 1e-7);
}

TEST(LumenPressure, OneBeyondTheWallIsRefusedWithTheUnit) {
  Scene scene;
  scene.name = "glenn";
  scene.units = millimetres;
  require_bearable(infant_vein({15 * 133.322e-6, 20 * 133.322e-6}), scene);
  try {
    require_bearable(infant_vein({0, 1300 * 133.322387415e-6}), scene);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("vessel svc: pressure.after: found 1300 mmHg (0.1733 MPa)"),
              std::string::npos)
        << said;
    // p (R - t/2) / E t
    EXPECT_NE(said.find("stretch the wall by 269 %"), std::string::npos) << said;
    EXPECT_NE(said.find("units.pressure"), std::string::npos) << said;
  }
  try {
    require_bearable(infant_vein({0, -1300 * 133.322387415e-6}), scene);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("found -1300 mmHg (-0.1733 MPa), which would shorten the wall by 269 %, "
                        "expected at least -"),
              std::string::npos)
        << said;
  }
}

TEST(LumenPressure, AVesselUnderItsCollapsePressureIsNamed) {
  Validity validity;
  warn_of_collapse(infant_vein({0, 10 * 133.322e-6}), millimetres, validity);
  warn_of_collapse(infant_vein({0, -1.8 * 133.322e-6}), millimetres, validity);
  EXPECT_TRUE(validity.in_range);
  EXPECT_TRUE(validity.warnings.empty());
  warn_of_collapse(infant_vein({0, -2 * 133.322e-6}), millimetres, validity);
  EXPECT_FALSE(validity.in_range);
  ASSERT_EQ(validity.warnings.size(), 1U);
  EXPECT_NE(validity.warnings[0].find("a pressure of -2 mmHg"), std::string::npos)
      << validity.warnings[0];
}

TEST(LumenPressure, TheNoteStatesBothPressures) {
  EXPECT_EQ(lumen_note(infant_vein({5 * 133.322387415e-6, 0.0016}).spec, millimetres),
            "pressure in the lumen of svc: 5 mmHg (0.0006666 MPa) as scanned, 12 mmHg (0.0016 MPa) "
            "after");
}

}  // namespace
}  // namespace vasorod
