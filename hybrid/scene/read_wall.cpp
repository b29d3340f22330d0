#include "data/sentence.h"
#include "scene/read_parts.h"

namespace vasorod {

namespace {

void check_admissible(const Field& wall, const Material& material) {
  if (const auto fault = fault_of(material)) wall.refuse(fault->found, fault->expected);
}

}  // namespace

Wall read_wall(const Field& field) {
  field.check_keys({"thickness", "young", "poisson", "shear", "transverse"});
  Wall wall;
  wall.thickness = field.at("thickness", "the wall's thickness").length();
  Material& material = wall.material;
  const double young = field.at("young", "Young's modulus").stiffness();
  std::optional<double> shear;
  if (const auto given = field.find("shear")) shear = given->stiffness();
  if (const auto transverse = field.find("transverse")) {
    transverse->check_keys({"young", "poisson", "coupling"});
    if (const auto poisson = field.find("poisson"))
      poisson->refuse("it beside transverse", "nu_TT as transverse.poisson only");
    if (!shear) field.at("shear", "G_axial beside transverse");
    const auto across = transverse->find("young");
    material.young_axial = young;
    material.young_transverse = across ? across->stiffness() : young;
    material.shear_axial = *shear;
    material.poisson_tt = transverse->at("poisson", "nu_TT").number();
    if (const auto coupling = transverse->find("coupling"))
      material.poisson_lt = coupling->number();
    check_admissible(*transverse, material);
    return wall;
  }
  const Field poisson = field.at("poisson", "Poisson's ratio");
  const double nu = poisson.number();
  if (!(nu > -1 && nu <= 0.5))
    poisson.refuse(number_text(nu, 6), "a number above -1 and at most 0.5");
  material = Material::isotropic(young, nu);
  if (shear) {  // independent E and G: transversely isotropic with nu_LT = 0
    material.shear_axial = *shear;
    material.poisson_lt = 0;
    check_admissible(field, material);
  }
  return wall;
}

}  // namespace vasorod
