#include <algorithm>
#include <limits>

#include "data/sentence.h"
#include "data/whole_file.h"
#include "surface_file/join_pieces.h"
#include "surface_file/space.h"
#include "surface_file/surface_file.h"
#include "surface_file/vtp_arrays.h"

namespace vasorod {

namespace {

// Limits of a file: an int must be able to count points and cells; the components of an array.
constexpr std::size_t most_items = std::numeric_limits<int>::max(), most_components = 10000;

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file)
      : text_(whole_file(file)),
        head_(read_vtp_head(file.string(), text_)),
        arrays_(file.string(), text_, head_) {}

  std::vector<SurfaceFile> pieces() {
    const VtpTag* data = head_.root.child("PolyData");
    if (data == nullptr) arrays_.damaged(head_.root, "no PolyData in it");
    std::vector<SurfaceFile> pieces;
    for (const VtpTag& tag : data->children)
      if (tag.name == "Piece") pieces.push_back(read_piece(tag));
    if (pieces.empty()) arrays_.damaged(*data, "no Piece in it");
    pieces.front().space = read_space(*data);
    return pieces;
  }

  // The unit in "length mm, stress MPa", as result/write_vtp.cpp writes it.
  std::string units() {
    const VtpTag* data = head_.root.child("PolyData");
    const std::string text = data == nullptr ? std::string() : field_text(*data, "Units");
    for (const std::string unit : {"mm", "cm", "m"})
      if (text == "length " + unit || text.starts_with("length " + unit + ",")) return unit;
    return {};
  }

 private:
  std::size_t components(const VtpTag& array) const {
    const std::size_t value = arrays_.count(array, "NumberOfComponents", most_components, 1);
    if (value == 0) arrays_.damaged(array, "an array of no components");
    return value;
  }

  std::string field_text(const VtpTag& data, const std::string& name) {
    const VtpTag* fields = data.child("FieldData");
    if (fields == nullptr) return {};
    for (const VtpTag& tag : fields->children)
      if (tag.value("Name") == name && tag.value("type") == "String")
        return arrays_.first_text(tag);
    return {};
  }

  // What 3D Slicer says in the field data of the coordinates' space.
  std::string read_space(const VtpTag& data) { return known_space(field_text(data, "SPACE")); }

  const VtpTag* array_of(const VtpTag& section, const std::string& name) const {
    for (const VtpTag& tag : section.children)
      if (tag.name == "DataArray" && (name.empty() || tag.value("Name") == name)) return &tag;
    return nullptr;
  }

  std::vector<std::vector<int>> read_cells(const VtpTag& piece, const std::string& kind,
                                           std::size_t cells) {
    std::vector<std::vector<int>> all;
    if (cells == 0) return all;
    const VtpTag* section = piece.child(kind);
    const VtpTag* ids = section ? array_of(*section, "connectivity") : nullptr;
    const VtpTag* ends = section ? array_of(*section, "offsets") : nullptr;
    if (ids == nullptr || ends == nullptr)
      arrays_.damaged(piece, "no connectivity or offsets of its " + kind);
    const VtpNumber *id_type = arrays_.type_of(*ids), *end_type = arrays_.type_of(*ends);
    if (id_type == nullptr || !id_type->integer || end_type == nullptr || !end_type->integer)
      arrays_.damaged(*section, "cells of another type than whole numbers");
    const std::vector<double> offsets = arrays_.numbers(*ends, *end_type, cells);
    double before = 0;
    for (const double end : offsets) {
      if (!(end >= before && end <= static_cast<double>(most_items) * 8))
        arrays_.damaged(*ends, "offsets that do not fit");
      before = end;
    }
    const std::vector<double> points =
        arrays_.numbers(*ids, *id_type, static_cast<std::size_t>(before));
    all.reserve(cells);
    std::size_t begin = 0;
    for (const double end : offsets) {
      std::vector<int>& cell = all.emplace_back();
      for (; begin < static_cast<std::size_t>(end); ++begin)
        cell.push_back(points[begin] >= 0 && points[begin] < static_cast<double>(most_items)
                           ? static_cast<int>(points[begin])
                           : -1);
    }
    return all;
  }

  std::vector<NamedArray> read_arrays(const VtpTag* section, std::size_t rows) {
    std::vector<NamedArray> arrays;
    if (section == nullptr) return arrays;
    for (const VtpTag& tag : section->children) {
      const std::string name = tag.value("Name");
      const VtpNumber* type = tag.name == "DataArray" ? arrays_.type_of(tag) : nullptr;
      const bool known = std::any_of(arrays.begin(), arrays.end(),
                                     [&](const NamedArray& array) { return array.name == name; });
      if (type == nullptr || name.empty() || known) continue;  // strings are skipped
      const std::size_t columns = components(tag);
      const std::vector<double> values = arrays_.numbers(tag, *type, rows * columns);
      NamedArray& array = arrays.emplace_back();
      array.name = name;
      array.type = type->name;
      array.integer = type->integer;
      array.values.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
      std::copy(values.begin(), values.end(), array.values.data());
    }
    return arrays;
  }

  SurfaceFile read_piece(const VtpTag& piece) {
    const std::size_t points = arrays_.count(piece, "NumberOfPoints", most_items, std::nullopt);
    const auto cells = [&](const std::string& kind) {
      return arrays_.count(piece, "NumberOf" + kind, most_items, 0);
    };
    SurfaceFile out;
    out.points.resize(0, 3);
    if (points > 0) {
      const VtpTag* section = piece.child("Points");
      const VtpTag* at = section ? array_of(*section, "") : nullptr;
      if (at == nullptr) arrays_.damaged(piece, "no Points in it");
      const VtpNumber* type = arrays_.type_of(*at);
      if (type == nullptr || components(*at) != 3)
        arrays_.damaged(*at, "points of other than three coordinates");
      const std::vector<double> values = arrays_.numbers(*at, *type, 3 * points);
      out.points.resize(static_cast<Eigen::Index>(points), 3);
      std::copy(values.begin(), values.end(), out.points.data());
    }
    const std::size_t skipped = cells("Verts") + cells("Lines");
    const std::size_t all = skipped + cells("Polys") + cells("Strips");
    if (all > most_items) arrays_.damaged(piece, "more cells than can be numbered");
    read_cells(piece, "Verts", cells("Verts"));  // checked but not kept
    out.lines = read_cells(piece, "Lines", cells("Lines"));
    out.polygons = read_cells(piece, "Polys", cells("Polys"));
    out.strips = read_cells(piece, "Strips", cells("Strips"));
    out.skipped_cells = static_cast<int>(skipped);
    out.point_arrays = read_arrays(piece.child("PointData"), points);
    out.cell_arrays = read_arrays(piece.child("CellData"), all);
    return out;
  }

  std::string text_;
  VtpHead head_;
  VtpArrays arrays_;
};

}  // namespace

SurfaceFile read_vtp(const std::filesystem::path& file) {
  return joined_pieces(Reader(file).pieces());
}

std::string units_in_vtp(const std::filesystem::path& file) {
  return Reader(file).units();
}

}  // namespace vasorod
