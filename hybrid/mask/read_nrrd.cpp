// NRRD headers (teem.sourceforge.net/nrrd/format.html): lines of text up to an empty one.
#include <map>
#include <sstream>

#include "data/sentence.h"
#include "mask/mask.h"

namespace vasorod {
namespace {

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

// In these spaces the vessel would be its own mirror image.
bool is_left_handed(const std::string& name) {
  return name == "left-anterior-superior" || name == "LAS" || name == "3D-left-handed";
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
  out.size = header_size(file, "sizes", field["sizes"]);
  for (const char* key : {"line skip", "lineskip", "byte skip", "byteskip"})
    if (field.contains(key) && field[key] != "0")
      refuse_mask(file, std::string(key) + " " + in_quotes(field[key]),
                  "voxels that begin where the header or the data file does");
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
    out.step = header_columns(file, "space directions", field["space directions"]);
  } else if (field.contains("spacings")) {
    out.step = header_vector(file, "spacings", field["spacings"]).asDiagonal();
  }
  if (field.contains("space origin"))
    out.origin = header_vector(file, "space origin", field["space origin"]);
  out.space = space_of(field["space"]);
  if (is_left_handed(field["space"]))
    refuse_mask(file, "the left-handed space " + in_quotes(field["space"]),
                "left-posterior-superior or right-anterior-superior");
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
