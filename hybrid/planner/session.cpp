#include "planner/session.h"

#include <algorithm>

#include <vasorod/error.h>
#include <vasorod/predict.h>
#include <vasorod/version.h>

#include "data/sentence.h"
#include "data/whole_file.h"
#include "planner/mesh_message.h"
#include "planner/picks.h"
#include "planner/place.h"
#include "planner/save.h"
#include "planner/scene_answer.h"
#include "planner/sections.h"
#include "predict/fidelity.h"
#include "report/report_pictures.h"
#include "result/read_folder.h"

namespace vasorod::planner {
namespace {

constexpr int longest_wait_ms = 10000;

std::string read_fidelity(const Body& body) {
  const std::string fidelity = body.text("fidelity");
  const std::vector<std::string> names = fidelities_with_surgery();
  if (std::find(names.begin(), names.end(), fidelity) == names.end())
    body.refuse("fidelity", listed(names));
  return fidelity;
}

}  // namespace

Session::Session(const std::vector<std::filesystem::path>& named,
                 const std::filesystem::path& working)
    : sources_(find_sources(named, working)), jobs_(shelf_) {
  folder_ = folder_of(sources_, working);
}

Json Session::about() {
  const std::lock_guard<std::mutex> lock(mutex_);
  add_new(folder_, sources_);
  if (current_ && current_->scene) add_new(current_->scene->scene.file.parent_path(), sources_);
  Json answer{{"program", "vasorod-plan " + version()},
              {"folder", folder_.string()},
              {"current", current_ ? Json(current_->id) : Json()},
              {"sources", Json::array()},
              {"fidelities", Json::array()}};
  for (const Source& source : sources_)
    answer["sources"].push_back({{"id", source.id},
                                 {"kind", source.kind == Source::Kind::scene ? "scene" : "result"},
                                 {"name", source.name},
                                 {"path", source.path.string()},
                                 {"group", source.group}});
  for (const Fidelity& fidelity : fidelities())
    if (fidelity.surgery)
      answer["fidelities"].push_back({{"name", fidelity.name}, {"sentence", fidelity.sentence}});
  return answer;
}

std::shared_ptr<const Session::Opened> Session::open(const std::string& id) {
  Source source;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = std::find_if(sources_.begin(), sources_.end(),
                                    [&](const Source& one) { return one.id == id; });
    if (found == sources_.end())
      throw Refusal(404, "found no source " + in_quotes(id) + ", expected one of the session");
    source = *found;
  }
  auto opened = std::make_shared<Opened>();
  opened->id = source.id;
  if (source.kind == Source::Kind::scene) {
    opened->scene = open_scene(source.id, source.path);
    opened->name = opened->scene->scene.name;
  } else {
    Result result = read_result_folder(source.path);
    opened->name = result.scene;
    opened->result = std::make_shared<StoredResult>(
        shelf_.next_id(), std::move(result), std::nullopt, whole_file(source.path / "result.json"));
    shelf_.put(opened->result);
  }
  jobs_.drop_all();
  const std::lock_guard<std::mutex> lock(mutex_);
  current_ = opened;
  return opened;
}

std::shared_ptr<const Session::Opened> Session::current() {
  const auto now = [&] {
    const std::lock_guard<std::mutex> lock(mutex_);
    return current_;
  };
  if (auto opened = now()) return opened;
  const std::lock_guard<std::mutex> lock(opening_);
  if (auto opened = now()) return opened;
  std::string first;
  {
    const std::lock_guard<std::mutex> of_sources(mutex_);
    if (sources_.empty())
      throw Refusal(404, one_line(folder_.string()) +
                             ": found no scene and no result, expected one on the command line");
    first = sources_.front().id;
  }
  return open(first);
}

std::shared_ptr<const OpenedScene> Session::current_scene() {
  const auto opened = current();
  if (!opened->scene) throw Refusal(400, "found a result, expected an opened scene");
  return opened->scene;
}

std::shared_ptr<const StoredResult> Session::stored(const std::string& id) const {
  {
    // The opened result stays, however many others came since.
    const std::lock_guard<std::mutex> lock(mutex_);
    if (current_ && current_->result && current_->result->id == id) return current_->result;
  }
  return shelf_.find(id);
}

Json Session::scene_of(const Opened& opened) const {
  return opened.scene ? scene_answer(*opened.scene)
                      : result_answer(opened.id, opened.name, *opened.result);
}

Json Session::scene() {
  return scene_of(*current());
}

Json Session::post(const std::string& what, const Body& body) {
  if (what == "open") {
    body.check_keys({"id"});
    const std::string id = body.text("id");
    const std::lock_guard<std::mutex> lock(opening_);
    return scene_of(*open(id));
  }
  if (what == "pick") return pick(body);
  if (what == "place") return place(body);
  if (what == "solve") return solve(body);
  if (what == "section") return section(body);
  if (what == "save") return save(body);
  if (what == "keep") return keep(body);
  if (what == "hold") {
    body.check_keys({"result", "hold"});
    const bool hold = body.flag("hold", true);
    shelf_.hold(body.text("result"), hold);
    return {{"held", hold}};
  }
  if (what == "cancel") {
    body.check_keys({"job"});
    return jobs_.cancel(body.text("job"));
  }
  throw Refusal(404, "found the request api/" + shortened(what) +
                         ", expected open, pick, place, solve, cancel, section, save, keep "
                         "or hold");
}

Json Session::job(const std::string& id, int wait_ms) {
  return jobs_.status(id, std::chrono::milliseconds(std::clamp(wait_ms, 0, longest_wait_ms)));
}

Json Session::result(const std::string& id) const {
  return json_of(*stored(id));
}

std::string Session::mesh(const std::string& vessel) {
  const auto opened = current();
  return opened->scene ? mesh_at_rest(*opened->scene, vessel)
                       : mesh_in_result(*opened->result, vessel);
}

std::string Session::result_mesh(const std::string& id, const std::string& body) const {
  return mesh_in_result(*stored(id), body);
}

Json Session::pick(const Body& body) {
  body.check_keys({"origin", "direction", "vessels", "result"});
  const Ray ray = read_ray(body);
  const std::vector<std::string> vessels = body.words("vessels");
  if (const auto id = body.optional_text("result"))
    return pick_in_result(*stored(*id), ray, vessels);
  return pick_at_rest(*current_scene(), ray, vessels);
}

Json Session::place(const Body& body) {
  body.check_keys({"plan"});
  const Plan plan = read_plan(body.object("plan"));
  return placed_plan(*current_scene(), plan);
}

Json Session::solve(const Body& body) {
  body.check_keys({"plan", "fidelity"});
  std::optional<Plan> plan;
  if (body.has("plan")) plan = read_plan(body.object("plan"));
  return {{"job", jobs_.begin(current_scene(), plan, read_fidelity(body))}};
}

Json Session::section(const Body& body) {
  body.check_keys({"result", "point", "normal"});
  const SectionPlane plane = read_plane(body);
  if (const auto id = body.optional_text("result")) return section_in_result(*stored(*id), plane);
  return section_at_rest(*current_scene(), plane);
}

Json Session::save(const Body& body) {
  body.check_keys({"name", "plan", "fidelity", "overwrite"});
  const Plan plan = read_plan(body.object("plan"));
  const auto opened = current_scene();
  return save_scene(*opened, plan, read_fidelity(body), body.text("name"),
                    body.flag("overwrite", false));
}

Json Session::keep(const Body& body) {
  body.check_keys({"result", "name"});
  return keep_result(*stored(body.text("result")), folder_, body.text("name"));
}

}  // namespace vasorod::planner
