// MetaImage headers (itk.org/Wiki/MetaIO/Documentation): KEY = VALUE up to ElementDataFile. ITK,
// whose format it is, has its coordinates in LPS.
#include <map>

#include "data/sentence.h"
#include "mask/mask.h"

namespace vasorod {
namespace {

std::string type_of(const std::string& name) {
  static const std::map<std::string, std::string> types{
      {"MET_CHAR", "i1"},  {"MET_UCHAR", "u1"}, {"MET_SHORT", "i2"},     {"MET_USHORT", "u2"},
      {"MET_INT", "i4"},   {"MET_UINT", "u4"},  {"MET_LONG_LONG", "i8"}, {"MET_ULONG_LONG", "u8"},
      {"MET_FLOAT", "f4"}, {"MET_DOUBLE", "f8"}};
  const auto found = types.find(name);
  return found == types.end() ? "" : found->second;
}

}  // namespace

MaskHead read_metaimage_head(const std::filesystem::path& file, const std::string& head) {
  std::map<std::string, std::string> field;
  std::size_t at = 0;
  while (!field.contains("ElementDataFile")) {
    const std::size_t end = head.find('\n', at);
    if (end == std::string::npos)
      refuse_mask(file, "a header without ElementDataFile", "a MetaImage mask");
    const std::string line = head.substr(at, end - at);
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos)
      field[trimmed(line.substr(0, equals))] = trimmed(line.substr(equals + 1));
    at = end + 1;
  }
  const auto first_of = [&](std::initializer_list<const char*> names) {
    for (const char* name : names)
      if (field.contains(name)) return field[name];
    return std::string();
  };
  const auto yes = [&](const std::string& value) { return value == "True" || value == "true"; };
  MaskHead out;
  if (field["NDims"] != "3")
    refuse_mask(file, "an image of dimension " + in_quotes(field["NDims"]),
                "a mask of three dimensions");
  if (field.contains("ElementNumberOfChannels") && field["ElementNumberOfChannels"] != "1")
    refuse_mask(file, "ElementNumberOfChannels " + in_quotes(field["ElementNumberOfChannels"]),
                "one label per voxel");
  out.size = header_size(file, "DimSize", field["DimSize"]);
  if (field.contains("HeaderSize") && field["HeaderSize"] != "0")
    refuse_mask(file, "HeaderSize " + in_quotes(field["HeaderSize"]),
                "voxels that begin where the header or the data file does");
  out.type = type_of(field["ElementType"]);
  if (out.type.empty())
    refuse_mask(file, "voxels of type " + in_quotes(field["ElementType"]), "whole numbers");
  if (const std::string steps = first_of({"ElementSpacing", "ElementSize"}); !steps.empty())
    out.step = header_vector(file, "ElementSpacing", steps).asDiagonal();
  // The cosines of each image axis, one after the other.
  if (const std::string axes = first_of({"TransformMatrix", "Rotation", "Orientation"});
      !axes.empty())
    out.step = header_columns(file, "TransformMatrix", axes) * out.step;
  if (const std::string place = first_of({"Offset", "Position", "Origin"}); !place.empty())
    out.origin = header_vector(file, "Offset", place);
  out.space = "LPS";
  if (field.contains("BinaryData") && !yes(field["BinaryData"]))
    out.packing = MaskHead::Packing::text;
  else if (yes(field["CompressedData"]))
    out.packing = MaskHead::Packing::zlib;
  out.swapped = yes(first_of({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}));
  const std::string data = field["ElementDataFile"];
  if (data == "LIST" || data.find('%') != std::string::npos)
    refuse_mask(file, "voxels in several files", "one file of voxels");
  out.data = data == "LOCAL" ? file : file.parent_path() / data;
  out.at = data == "LOCAL" ? at : 0;
  return out;
}

}  // namespace vasorod
