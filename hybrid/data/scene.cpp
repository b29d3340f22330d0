#include <vasorod/error.h>
#include <vasorod/scene.h>

#include "data/scene_place.h"
#include "data/sentence.h"

namespace vasorod {
namespace {

bool moves(const EndCondition& end) {
  return end.hold || end.rotate_deg || end.move;
}
bool loads(const EndCondition& end) {
  return end.force || end.moment;
}
bool fixes(const EndCondition& end) {
  return end.fix != std::array<bool, 6>{};
}

}  // namespace

std::string to_string(Role role) {
  return role == Role::obstacle ? "obstacle" : "deformable";
}

std::string to_string(SurfaceIs is) {
  return is == SurfaceIs::mid ? "mid" : is == SurfaceIs::outer ? "outer" : "inner";
}

std::string to_string(Uncertain::What what) {
  switch (what) {
    case Uncertain::What::young:
      return "young";
    case Uncertain::What::poisson:
      return "poisson";
    case Uncertain::What::thickness:
      return "thickness";
    case Uncertain::What::pressure:
      return "pressure";
    case Uncertain::What::cut:
      return "cut";
    case Uncertain::What::incision:
      return "incision";
  }
  return "";
}

std::string to_string(const EndSelector& selector) {
  switch (selector.kind) {
    case EndSelector::Kind::start:
      return "start";
    case EndSelector::Kind::end:
      return "end";
    case EndSelector::Kind::near:
      return "near" + place_text(selector.near);
    case EndSelector::Kind::face:
      return "face(" + std::to_string(selector.face) + ")";
    case EndSelector::Kind::at:
      break;
  }
  return "at(" + number_text(selector.at) + ")";
}

bool exclude_each_other(const EndCondition& a, const EndCondition& b) {
  return moves(a) || moves(b) || (loads(a) && loads(b)) || (fixes(a) && fixes(b));
}

std::string contradiction(const EndCondition& end) {
  if (end.hold && (end.rotate_deg || end.move))
    return "hold beside rotate_deg or move, expected one of the two, as a moved end is held on its "
           "path";
  if (moves(end) && fixes(end))
    return "fix beside hold, rotate_deg or move, expected one of the two";
  if (moves(end) && loads(end))
    return "a force or moment on an end that is held or moved, expected either a motion or a load";
  if (!moves(end) && !loads(end) && !fixes(end))
    return "an end without a condition, expected hold, rotate_deg, move, force, moment or fix";
  return {};
}

const VesselSpec& Scene::vessel(const std::string& vessel_name) const {
  for (const VesselSpec& candidate : vessels)
    if (candidate.name == vessel_name) return candidate;
  throw InputError(place_in(*this) + ": found no vessel " + in_quotes(vessel_name) +
                   ", expected one of the scene's");
}

std::optional<std::array<std::string, 2>> Scene::joined() const {
  if (glenn) return std::array{glenn->svc, glenn->rpa};
  if (end_to_end) return std::array{end_to_end->rims[0].vessel, end_to_end->rims[1].vessel};
  return std::nullopt;
}

std::vector<const PickSpec*> Scene::picks() const {
  std::vector<const PickSpec*> picks;
  if (glenn) picks = {&glenn->cut, &glenn->incision};
  if (end_to_end)
    for (const RimSpec& rim : end_to_end->rims)
      if (rim.cut) picks.push_back(&*rim.cut);
  return picks;
}

}  // namespace vasorod
