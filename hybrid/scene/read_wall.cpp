#include <sstream>

#include "scene/read_parts.h"

namespace vasorod {

namespace {

std::string written(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

// Above this a stress or a length is a slip of the keyboard, and squares of it leave the range of a double.
constexpr double largest = 1e30;

double modulus(const Field& field) {
  const double value = field.positive();
  if (value > largest) field.refuse(written(value), "a number below 1e30");
  return value;
}

// Positive definite compliance of a transversely isotropic solid, E_L along the axis, E_T across.
void check_admissible(const Field& wall, const Wall& w) {
  if (!(w.poisson > -1 && w.poisson < 1))
    wall.refuse("nu_TT = " + written(w.poisson), "-1 < nu_TT < 1, or the wall has no positive energy");
  const double left = 1 - w.poisson - 2 * w.coupling * w.coupling * *w.transverse_young / w.young;
  if (!(left > 0))
    wall.refuse("1 - nu_TT - 2 nu_LT^2 E_T/E_L = " + written(left),
                "1 - nu_TT - 2 nu_LT^2 E_T/E_L > 0, or the wall has no positive energy");
}

}  // namespace

Wall read_wall(const Field& field) {
  field.check_keys({"thickness", "young", "poisson", "shear", "transverse"});
  Wall wall;
  wall.thickness = modulus(field.at("thickness", "the wall's thickness"));
  wall.young = modulus(field.at("young", "Young's modulus"));
  if (const auto shear = field.find("shear")) wall.shear = modulus(*shear);
  if (const auto transverse = field.find("transverse")) {
    transverse->check_keys({"young", "poisson", "coupling"});
    if (const auto poisson = field.find("poisson"))
      poisson->refuse("it beside transverse", "nu_TT as transverse.poisson only");
    if (!wall.shear) field.at("shear", "G_axial beside transverse");
    const auto young = transverse->find("young");
    wall.transverse_young = young ? modulus(*young) : wall.young;
    wall.poisson = transverse->at("poisson", "nu_TT").number();
    if (const auto coupling = transverse->find("coupling")) wall.coupling = coupling->number();
    check_admissible(*transverse, wall);
    return wall;
  }
  const Field poisson = field.at("poisson", "Poisson's ratio");
  wall.poisson = poisson.number();
  if (!(wall.poisson > -1 && wall.poisson <= 0.5))
    poisson.refuse(written(wall.poisson), "a number above -1 and at most 0.5");
  if (wall.shear) {  // E and G free of each other: transversely isotropic with nu_LT = 0
    wall.transverse_young = wall.young;
    check_admissible(field, wall);
  }
  return wall;
}

}  // namespace vasorod
