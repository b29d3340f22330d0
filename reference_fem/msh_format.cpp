#include "reference_fem/msh_format.h"

#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include <vasorod/error.h>

namespace vasorod::fem {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& found,
                         const std::string& expected) {
  throw InputError(path + ": found " + found + "; expected " + expected);
}

/// gmsh's element numbers, from its manual.
std::string element_name(int type) {
  static const std::map<int, std::string> names{{1, "lines"},
                                                {2, "triangles"},
                                                {3, "quadrilaterals"},
                                                {4, "tetrahedra"},
                                                {5, "hexahedra"},
                                                {6, "prisms"},
                                                {7, "pyramids"},
                                                {8, "second-order lines"},
                                                {9, "second-order triangles"},
                                                {10, "second-order quadrilaterals"},
                                                {11, "second-order tetrahedra"},
                                                {12, "second-order hexahedra"},
                                                {15, "points"},
                                                {16, "second-order quadrilaterals (8 nodes)"},
                                                {17, "second-order hexahedra (20 nodes)"}};
  const auto name = names.find(type);
  return name != names.end() ? name->second : "elements of gmsh's type " + std::to_string(type);
}

/// The lines of the section `name`.
std::vector<std::string> section(std::ifstream& file, const std::string& name) {
  file.clear();
  file.seekg(0);
  std::vector<std::string> lines;
  std::string line;
  bool within = false;
  while (std::getline(file, line)) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (within && line.rfind("$End" + name, 0) == 0) break;
    if (within) lines.push_back(line);
    if (line == "$" + name) within = true;
  }
  return lines;
}

std::map<int, long> elements_2(const std::vector<std::string>& lines) {
  std::map<int, long> count;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    int number = 0, type = 0;
    if (std::istringstream(lines[i]) >> number >> type) ++count[type];
  }
  return count;
}

std::map<int, long> elements_4(const std::vector<std::string>& lines) {
  std::map<int, long> count;
  for (std::size_t i = 1; i < lines.size();) {
    int dimension = 0, entity = 0, type = 0;
    long inside = 0;
    if (!(std::istringstream(lines[i]) >> dimension >> entity >> type >> inside)) break;
    count[type] += inside;
    i += static_cast<std::size_t>(inside) + 1;
  }
  return count;
}

/// $Entities of version 4.1: points, then curves, surfaces and volumes with their boxes and
/// physical groups.
void check_groups(const std::string& path, const std::vector<std::string>& lines) {
  std::array<long, 4> counts{};
  if (lines.empty()) return;
  std::istringstream first(lines[0]);
  for (long& n : counts) first >> n;
  std::size_t at = 1;
  for (std::size_t dimension = 0; dimension < 4; ++dimension)
    for (long k = 0; k < counts[dimension] && at < lines.size(); ++k, ++at) {
      std::istringstream line(lines[at]);
      long tag = 0, groups = 0;
      double skip = 0;
      line >> tag;
      for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) line >> skip;
      line >> groups;
      if (groups > 1)
        refuse(path, std::to_string(groups) + " physical groups on entity " + std::to_string(tag),
               "one at most");
    }
}

}  // namespace

void check_msh(const std::string& path, int dim) {
  std::ifstream file(path);
  if (!file) throw FileError(path + ": found no readable file; expected a gmsh mesh (.msh)");
  const auto header = section(file, "MeshFormat");
  const std::string formats = "gmsh's ASCII format 2.2 or 4.1";
  if (header.empty()) refuse(path, "no $MeshFormat", formats);
  std::string version;
  int binary = 0;
  std::istringstream(header[0]) >> version >> binary;
  if (binary != 0) refuse(path, "a binary file", formats);
  if (version != "2.2" && version != "4.1") refuse(path, "format " + version, formats);

  const auto lines = section(file, "Elements");
  const auto count = version == "2.2" ? elements_2(lines) : elements_4(lines);
  const int wanted = dim == 3 ? 5 : 3;
  for (const auto& [type, n] : count)
    if (type != 15 && type != 1 && type != wanted && !(dim == 3 && type == 3))
      refuse(path, std::to_string(n) + " " + element_name(type),
             element_name(wanted) +
                 " of first order only (curved walls come from the scene's tube, exactly)");
  if (!count.contains(wanted) || count.at(wanted) == 0)
    refuse(path, "no " + element_name(wanted),
           "some (where gmsh has physical groups it writes grouped elements only: group the " +
               std::string(dim == 3 ? "volume" : "surface") + " too)");
  if (version == "4.1") check_groups(path, section(file, "Entities"));
}

}  // namespace vasorod::fem
