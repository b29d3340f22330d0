#include "result/read_json.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include <vasorod/error.h>

#include "data/sentence.h"

namespace vasorod {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

double number(const Json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

Vec3 vector(const Json& value) {
  return {number(value.at(0)), number(value.at(1)), number(value.at(2))};
}

bool ours(const Json& value) {
  return value.is_object() && value.value("schema", Json()).is_number_integer() &&
         value.value("program", Json()).is_string() &&
         value.at("program").get_ref<const std::string&>().rfind("vasorod", 0) == 0;
}

// Names become files of the folder, which a name with a slash could leave.
bool is_file_name(const std::string& name) {
  return !name.empty() && name.size() <= 100 && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
}

Result result_of(const Json& value, const fs::path& folder) {
  Result result;
  result.scene = value.at("scene").get<std::string>();
  result.program = value.at("program").get<std::string>();
  result.fidelity = value.at("fidelity").get<std::string>();
  const auto status = value.at("status").get<std::string>();
  const auto known = status_named(status);
  if (!known)
    throw InputError("found the status " + in_quotes(status) +
                     ", expected one that this version knows");
  result.status = *known;
  if (const auto units = value.find("units"); units != value.end()) {
    result.length_unit = units->at("length").get<std::string>();
    result.stress_unit = units->at("stress").get<std::string>();
  }
  for (const Json& end : value.at("ends"))
    result.ends.push_back({end.at("vessel").get<std::string>(), end.at("end").get<std::string>(),
                           vector(end.at("force")), vector(end.at("moment")),
                           vector(end.at("center"))});
  for (const auto& [name, seconds] : value.at("seconds").items())
    result.seconds[name] = number(seconds);
  for (const auto& [name, sum] : value.at("environment").at("inputs").items())
    result.environment.inputs[name] = sum.get<std::string>();
  if (const auto glenn = value.find("glenn"); glenn != value.end()) {
    GlennReport& report = result.glenn.emplace();
    report.svc = glenn->at("svc").get<std::string>();
    report.rpa = glenn->at("rpa").get<std::string>();
    for (std::size_t k = 0; k < 2; ++k)
      report.incision.ends[k] = vector(glenn->at("incision").at("ends").at(k));
  }
  for (const Json& vessel : value.at("vessels")) {
    VesselResult& added = result.vessels.emplace_back();
    added.name = vessel.at("name").get<std::string>();
    if (!is_file_name(added.name))
      throw InputError("found the vessel " + in_quotes(added.name) +
                       ", expected a name of letters, digits, _ and -");
    added.obstacle = vessel.at("obstacle").get<bool>();
    for (const char* kind : {"surface", "centerline"})
      if (const auto name = vessel.find(kind);
          name != vessel.end() && !fs::exists(folder / name->get<std::string>()))
        throw InputError("found no " + shortened(name->get<std::string>()) +
                         " beside it, expected the files that it lists");
  }
  return result;
}

}  // namespace

Result read_json(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file.string() + ": cannot be opened, expected a result.json");
  const Json value = Json::parse(stream, nullptr, false);
  if (value.is_discarded())
    throw InputError(file.string() + ": is not JSON, expected a result.json");
  if (!ours(value))
    throw InputError(file.string() + ": has no schema and program of ours, expected a result.json");
  try {
    return result_of(value, file.parent_path());
  } catch (const Json::exception& error) {
    throw InputError(file.string() + ": found another layout (" + shortened(error.what(), 200) +
                     "), expected that of this version");
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  }
}

bool holds_our_result(const std::filesystem::path& folder) {
  std::ifstream stream(folder / "result.json");
  return stream && ours(Json::parse(stream, nullptr, false));
}

}  // namespace vasorod
