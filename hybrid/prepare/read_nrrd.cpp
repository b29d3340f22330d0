// NRRD headers (teem.sourceforge.net/nrrd/format.html): lines of text up to an empty one.
#include <map>
#include <sstream>

#include "data/sentence.h"
#include "prepare/mask.h"

namespace vasorod {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::string type_of(const std::string& name) {
  static const std::map<std::string, std::string> types{{"signed char", "i1"},
                                                        {"int8", "i1"},
                                                        {"int8_t", "i1"},
                                                        {"uchar", "u1"},
                                                        {"unsigned char", "u1"},
                                                        {"uint8", "u1"},
                                                        {"uint8_t", "u1"},
                                                        {"short", "i2"},
                                                        {"short int", "i2"},
                                                        {"signed short", "i2"},
                                                        {"int16", "i2"},
                                                        {"int16_t", "i2"},
                                                        {"ushort", "u2"},
                                                        {"unsigned short", "u2"},
                                                        {"unsigned short int", "u2"},
                                                        {"uint16", "u2"},
                                                        {"uint16_t", "u2"},
                                                        {"int", "i4"},
                                                        {"signed int", "i4"},
                                                        {"int32", "i4"},
                                                        {"int32_t", "i4"},
                                                        {"uint", "u4"},
                                                        {"unsigned int", "u4"},
                                                        {"uint32", "u4"},
                                                        {"uint32_t", "u4"},
                                                        {"longlong", "i8"},
                                                        {"long long", "i8"},
                                                        {"int64", "i8"},
                                                        {"int64_t", "i8"},
                                                        {"ulonglong", "u8"},
                                                        {"unsigned long long", "u8"},
                                                        {"uint64", "u8"},
                                                        {"uint64_t", "u8"},
                                                        {"float", "f4"},
                                                        {"double", "f8"}};
  const auto found = types.find(name);
  return found == types.end() ? "" : found->second;
}

std::string space_of(const std::string& name) {
  if (name == "left-posterior-superior" || name == "LPS") return "LPS";
  if (name == "right-anterior-superior" || name == "RAS") return "RAS";
  return {};
}

}  // namespace

MaskHead read_nrrd_head(const std::filesystem::path& file, const std::string& head) {
  if (!head.starts_with("NRRD"))
    refuse_mask(file, "a file that does not begin with NRRD", "a NRRD mask");
  std::map<std::string, std::string> field;
  std::size_t at = head.find('\n');
  bool ended = false;
  while (at != std::string::npos && !ended) {
    const std::size_t next = head.find('\n', at + 1);
    if (next == std::string::npos) {
      at = head.size();
      break;
    }
    const std::string line = trimmed(head.substr(at + 1, next - at - 1));
    at = next;
    ended = line.empty();
    const std::size_t colon = line.find(':');
    if (line.starts_with("#") || colon == std::string::npos) continue;
    if (line.compare(colon, 2, ":=") == 0) continue;
    field[line.substr(0, colon)] = trimmed(line.substr(colon + 1));
  }
  MaskHead out;
  const std::string data = field.contains("data file") ? field["data file"] : field["datafile"];
  if (!ended && data.empty())
    refuse_mask(file, "a NRRD header without the empty line at its end", "a sound NRRD file");
  if (field["dimension"] != "3")
    refuse_mask(file, "an image of dimension " + in_quotes(field["dimension"]),
                "a mask of three dimensions");
  const auto sizes = header_numbers(file, "sizes", field["sizes"], 3);
  for (std::size_t k = 0; k < 3; ++k)
    out.size[k] = sizes[k] > 0 && sizes[k] < 1e9 ? static_cast<std::int64_t>(sizes[k]) : 0;
  out.type = type_of(field["type"]);
  if (out.type.empty())
    refuse_mask(file, "voxels of type " + in_quotes(field["type"]), "whole numbers");
  const std::string packing = field["encoding"];
  if (packing == "raw")
    out.packing = MaskHead::Packing::none;
  else if (packing == "gzip" || packing == "gz")
    out.packing = MaskHead::Packing::gzip;
  else if (packing == "ascii" || packing == "text" || packing == "txt")
    out.packing = MaskHead::Packing::text;
  else
    refuse_mask(file, "the encoding " + in_quotes(packing), "raw, gzip or ascii");
  out.swapped = field["endian"] == "big";
  if (field.contains("space directions")) {
    const auto steps = header_numbers(file, "space directions", field["space directions"], 9);
    for (int k = 0; k < 9; ++k) out.step(k % 3, k / 3) = steps[static_cast<std::size_t>(k)];
  } else if (field.contains("spacings")) {
    const auto steps = header_numbers(file, "spacings", field["spacings"], 3);
    out.step = Vec3(steps[0], steps[1], steps[2]).asDiagonal();
  }
  if (field.contains("space origin")) {
    const auto origin = header_numbers(file, "space origin", field["space origin"], 3);
    out.origin = {origin[0], origin[1], origin[2]};
  }
  out.space = space_of(field["space"]);
  const std::string units = field["space units"];
  if (units.find("\"mm\"") != std::string::npos)
    out.unit = "mm";
  else if (units.find("\"cm\"") != std::string::npos)
    out.unit = "cm";
  else if (units.find("\"m\"") != std::string::npos)
    out.unit = "m";
  out.data = data.empty() ? file : file.parent_path() / data;
  out.at = data.empty() ? at + 1 : 0;
  return out;
}

}  // namespace vasorod
