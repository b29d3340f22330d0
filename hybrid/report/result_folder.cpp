#include <chrono>
#include <set>

#include <vasorod/error.h>
#include <vasorod/result_folder.h>

#include "report/report.h"
#include "result/folder_replacement.h"
#include "result/write_vtp.h"

namespace vasorod {

namespace {

using File = std::pair<std::string, std::string>;  // name, bytes

std::vector<File> geometry_files(const Result& result) {
  std::vector<File> files;
  for (const VesselResult& vessel : result.vessels) {
    const FileStamp stamp = stamp_of(result, vessel);
    if (vessel.rest.rows() > 0) files.emplace_back(vessel.name + ".vtp", vessel_vtp(vessel, stamp));
    if (vessel.centerline)
      files.emplace_back(vessel.name + "_centerline.vtp",
                         centerline_vtp(*vessel.centerline, stamp));
    if (vessel.stump)
      files.emplace_back(vessel.name + "_stump.vtp", surface_vtp(*vessel.stump, stamp));
  }
  files.emplace_back("scene.pvd", scene_pvd(result));
  std::set<std::string> names;
  for (const auto& [name, content] : files)
    if (!names.insert(name).second)
      throw InputError("two vessels would both be written to " + name +
                       ", expected names that keep them apart");
  return files;
}

}  // namespace

void write_result_folder(Result& result, const std::filesystem::path& folder) {
  const auto start = std::chrono::steady_clock::now();
  FolderReplacement replacement(folder);
  for (const auto& [name, content] : geometry_files(result)) replacement.write(name, content);
  const std::vector<NamedPicture> pictures = report_pictures(result, result.environment.threads);
  for (const NamedPicture& picture : pictures) replacement.write(picture.file, picture.png);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.seconds["write"] = seconds;
  result.seconds["total"] += seconds;
  replacement.write(
      "report.html",
      report_html(result, pictures));  // shows the seconds, so its own are not in them
  replacement.write("result.json", to_json(result));
  replacement.commit();
}

}  // namespace vasorod
