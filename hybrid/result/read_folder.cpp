#include "result/read_folder.h"

#include <vasorod/error.h>

#include "data/part_names.h"
#include "result/read_json.h"
#include "result/read_vtp.h"

namespace vasorod {

namespace {

namespace fs = std::filesystem;

void require_rows(const fs::path& file, const std::string& what, Eigen::Index found,
                  Eigen::Index points) {
  if (found != 0 && found != points)
    throw InputError(file.string() + ": found " + std::to_string(found) + " rows of " + what +
                     " for " + std::to_string(points) + " points, expected one for each");
}

void add_surface(const fs::path& file, VesselResult& vessel) {
  ReadVessel read = read_vessel_vtp(file);
  const Eigen::Index points = read.rest.rows();
  require_rows(file, "AxialStretch", read.axial_stretch.size(), points);
  require_rows(file, "TwistShear", read.twist_shear.size(), points);
  require_rows(file, "ContactPressure", read.contact_pressure.size(), points);
  vessel.rest = std::move(read.rest);
  vessel.current = std::move(read.current);
  vessel.triangles = std::move(read.triangles);
  vessel.axial_stretch = std::move(read.axial_stretch);
  vessel.twist_shear = std::move(read.twist_shear);
  vessel.contact_pressure = std::move(read.contact_pressure);
  vessel.space = std::move(read.space);
}

void add_centerline(const fs::path& file, VesselResult& vessel) {
  ReadCenterline read = read_centerline_vtp(file);
  if (read.directors.empty())
    throw InputError(file.string() + ": has no Director1, 2 and 3, expected a centerline of ours");
  CenterlineResult& line = vessel.centerline.emplace();
  line.rest = std::move(read.rest);
  line.current = std::move(read.current);
  line.abscissa = std::move(read.abscissa);
  line.radius = std::move(read.radius);
  line.directors = std::move(read.directors);
  line.u = std::move(read.u);
  line.v = std::move(read.v);
  line.u0 = std::move(read.u0);
  line.v0 = std::move(read.v0);
  line.lumen_area = std::move(read.lumen_area);
  line.flattening = std::move(read.flattening);
  line.lines = std::move(read.lines);
}

}  // namespace

Result read_result_folder(const fs::path& folder) {
  Result result = read_json(folder / "result.json");
  for (VesselResult& vessel : result.vessels) {
    if (const fs::path file = folder / (vessel.name + ".vtp"); fs::exists(file))
      add_surface(file, vessel);
    if (const fs::path file = folder / (centerline_name(vessel.name) + ".vtp"); fs::exists(file))
      add_centerline(file, vessel);
    if (const fs::path file = folder / (stump_name(vessel.name) + ".vtp"); fs::exists(file))
      vessel.stump = read_stump_vtp(file);
  }
  return result;
}

}  // namespace vasorod
