#include <algorithm>
#include <chrono>
#include <optional>
#include <set>

#include <vasorod/error.h>
#include <vasorod/result_folder.h>

#include "data/part_names.h"
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
      files.emplace_back(centerline_name(vessel.name) + ".vtp",
                         centerline_vtp(*vessel.centerline, stamp));
    if (vessel.stump)
      files.emplace_back(stump_name(vessel.name) + ".vtp", surface_vtp(*vessel.stump, stamp));
  }
  files.emplace_back("scene.pvd", scene_pvd(result));
  std::set<std::string> names;
  for (const auto& [name, content] : files)
    if (!names.insert(name).second)
      throw InputError("two vessels would both be written to " + name +
                       ", expected names that keep them apart");
  return files;
}

// Whether there is no time left for pictures.
class Haste {
 public:
  explicit Haste(const WriteOptions& options) : options_(options) {}
  bool operator()() {
    if (!options_.stop || !options_.stop()) return false;
    const auto now = std::chrono::steady_clock::now();
    if (!since_) since_ = now;
    return std::chrono::duration<double>(now - *since_).count() >= options_.patience;
  }

 private:
  const WriteOptions& options_;
  std::optional<std::chrono::steady_clock::time_point> since_;
};

bool is_left_out(const NamedPicture& picture) {
  return picture.png.empty();
}

}  // namespace

void write_result_folder(Result& result, const std::filesystem::path& folder,
                         const WriteOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  FolderReplacement replacement(folder);
  for (const auto& [name, content] : geometry_files(result)) replacement.write(name, content);
  std::vector<NamedPicture> pictures;
  if (options.report)
    pictures =
        report_pictures(result, result.environment.threads, Haste(options), options.picture_width);
  if (std::any_of(pictures.begin(), pictures.end(), is_left_out)) {
    std::erase_if(pictures, is_left_out);
    result.model.left_out["pictures"] = "stopped by the time limit or a signal";
  }
  for (const NamedPicture& picture : pictures) replacement.write(picture.file, picture.png);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.seconds["write"] = seconds;
  result.seconds["total"] += seconds;
  if (options.report)  // it shows the seconds, so its own are not in them
    replacement.write("report.html", report_html(result, pictures));
  replacement.write("result.json", to_json(result));
  replacement.commit();
}

}  // namespace vasorod
