#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>
#include <string_view>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "data/whole_file.h"
#include "surface_file/surface_file.h"

namespace vasorod {

namespace {

struct Type {
  std::string_view name, old_name;  // int32 was int in 1994
  size_t size;
  char kind;  // i, u or f
  std::string_view vtk;
};

constexpr std::array<Type, 8> types{{{"int8", "char", 1, 'i', "Int8"},
                                     {"uint8", "uchar", 1, 'u', "UInt8"},
                                     {"int16", "short", 2, 'i', "Int16"},
                                     {"uint16", "ushort", 2, 'u', "UInt16"},
                                     {"int32", "int", 4, 'i', "Int32"},
                                     {"uint32", "uint", 4, 'u', "UInt32"},
                                     {"float32", "float", 4, 'f', "Float32"},
                                     {"float64", "double", 8, 'f', "Float64"}}};

struct Property {
  std::string name;
  const Type* type = nullptr;
  const Type* count = nullptr;  // of a list
};

struct Element {
  std::string name;
  size_t items = 0;
  std::vector<Property> properties;
};

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file)
      : file_(file.string()), text_(whole_file(file)) {}

  SurfaceFile read() {
    read_header();
    SurfaceFile ply;
    bool vertices = false;
    for (const Element& element : elements_) {
      if (element.name == "vertex") {
        read_vertices(element, ply);
        vertices = true;
      } else if (element.name == "face") {
        read_faces(element, ply);
      } else {
        std::vector<double> list;
        for (size_t i = 0; i < element.items; ++i)
          for (const Property& property : element.properties) read_property(property, list);
      }
    }
    if (!vertices) damaged("no element vertex");
    return ply;
  }

 private:
  [[noreturn]] void damaged(const std::string& what) const {
    throw InputError(file_ + ": found a damaged or truncated PLY file (" + what +
                     "), expected a surface");
  }

  std::string header_line() {
    const size_t end = text_.find('\n', at_);
    if (end == std::string::npos) damaged("a header without end_header");
    std::string line = text_.substr(at_, end - at_);
    at_ = end + 1;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return line;
  }

  const Type& type_named(const std::string& name) const {
    for (const Type& type : types)
      if (name == type.name || name == type.old_name) return type;
    damaged("the unknown type " + in_quotes(name));
  }

  void read_header() {
    if (header_line() != "ply") damaged("no ply in its first line");
    bool has_format = false;
    for (std::string line = header_line(); line != "end_header"; line = header_line()) {
      std::istringstream words(line);
      std::string key;
      words >> key;
      if (key == "comment" || key == "obj_info" || key.empty()) continue;
      if (key == "format") {
        std::string format;
        words >> format;
        if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
          damaged("the unknown format " + in_quotes(format));
        ascii_ = format == "ascii";
        swap_ =
            !ascii_ && (format == "binary_big_endian") != (std::endian::native == std::endian::big);
        has_format = true;
      } else if (key == "element") {
        Element element;
        long long items = -1;
        words >> element.name >> items;
        if (items < 0 || items > static_cast<long long>(text_.size()))
          damaged("a count of items that does not fit");
        element.items = static_cast<size_t>(items);
        elements_.push_back(std::move(element));
      } else if (key == "property" && !elements_.empty()) {
        Property property;
        std::string type, count;
        words >> type;
        if (type == "list") {
          words >> count >> type;
          property.count = &type_named(count);
          if (property.count->kind == 'f') damaged("a list counted in fractions");
        }
        property.type = &type_named(type);
        words >> property.name;
        elements_.back().properties.push_back(std::move(property));
      } else {
        damaged("the header line " + in_quotes(line));
      }
    }
    if (!has_format) damaged("no format");
    for (const Element& element : elements_) {
      if (element.items == 0) continue;
      if (element.properties.empty()) damaged("an element without properties");
      // Every property of an item takes a byte or more, so no header can make us allocate much more
      // than the file's size.
      if (element.items > (text_.size() - at_) / element.properties.size())
        damaged("more items than fit into the file");
    }
  }

  template <class Number>
  double binary() {
    std::array<char, sizeof(Number)> bytes;
    std::memcpy(bytes.data(), text_.data() + at_, bytes.size());
    if (swap_) std::reverse(bytes.begin(), bytes.end());
    at_ += bytes.size();
    return static_cast<double>(std::bit_cast<Number>(bytes));
  }

  double read_number(const Type& type) {
    if (ascii_) {
      while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) <= ' ') ++at_;
      if (at_ < text_.size() && text_[at_] == '+') ++at_;
      double value = 0;
      const auto [stop, error] =
          std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
      if (error != std::errc())
        damaged(at_ == text_.size() ? "it ends too early" : "a word where a number belongs");
      at_ = static_cast<size_t>(stop - text_.data());
      return value;
    }
    if (text_.size() - at_ < type.size) damaged("it ends too early");
    if (type.kind == 'f') return type.size == 4 ? binary<float>() : binary<double>();
    if (type.kind == 'i')
      return type.size == 1   ? binary<int8_t>()
             : type.size == 2 ? binary<int16_t>()
                              : binary<int32_t>();
    return type.size == 1   ? binary<uint8_t>()
           : type.size == 2 ? binary<uint16_t>()
                            : binary<uint32_t>();
  }

  // Reads a number, or a list into `list`; returns the number or the length of the list.
  double read_property(const Property& property, std::vector<double>& list) {
    if (property.count == nullptr) return read_number(*property.type);
    const double count = read_number(*property.count);
    if (!(count >= 0 && count <= static_cast<double>(text_.size() - at_)))
      damaged("a list of impossible length");
    list.clear();
    for (double k = 0; k < count; ++k) list.push_back(read_number(*property.type));
    return count;
  }

  static NamedArray array_for(const Property& property, size_t items) {
    NamedArray array;
    array.name = property.name;
    array.type = property.type->vtk;
    array.integer = property.type->kind != 'f';
    array.values.resize(static_cast<Eigen::Index>(items), 1);
    return array;
  }

  void read_vertices(const Element& element, SurfaceFile& ply) {
    ply.points.setConstant(static_cast<Eigen::Index>(element.items), 3,
                           std::numeric_limits<double>::quiet_NaN());
    ply.point_arrays.clear();
    std::vector<int> column;  // 0 to 2: a coordinate; -1: a list; 3 and above: an array
    for (const Property& property : element.properties) {
      const std::string_view name = property.name;
      const bool coordinate =
          property.count == nullptr && (name == "x" || name == "y" || name == "z");
      column.push_back(coordinate ? name.front() - 'x' : property.count != nullptr ? -1 : 3);
      if (column.back() == 3) {
        column.back() += static_cast<int>(ply.point_arrays.size());
        ply.point_arrays.push_back(array_for(property, element.items));
      }
    }
    std::vector<double> list;
    for (Eigen::Index i = 0; i < ply.points.rows(); ++i)
      for (size_t k = 0; k < element.properties.size(); ++k) {
        const double value = read_property(element.properties[k], list);
        if (column[k] >= 3)
          ply.point_arrays[static_cast<size_t>(column[k] - 3)].values(i, 0) = value;
        else if (column[k] >= 0)
          ply.points(i, column[k]) = value;
      }
  }

  void read_faces(const Element& element, SurfaceFile& ply) {
    ply.polygons.clear();
    ply.cell_arrays.clear();
    for (const Property& property : element.properties)
      if (property.count == nullptr) ply.cell_arrays.push_back(array_for(property, element.items));
    std::vector<double> list;
    for (size_t i = 0; i < element.items; ++i) {
      size_t array = 0;
      std::vector<int> polygon;
      for (const Property& property : element.properties) {
        const double value = read_property(property, list);
        if (property.count == nullptr)
          ply.cell_arrays[array++].values(static_cast<Eigen::Index>(i), 0) = value;
        else if (property.name == "vertex_indices" || property.name == "vertex_index")
          for (const double id : list)
            polygon.push_back(id >= 0 && id < std::numeric_limits<int>::max() ? static_cast<int>(id)
                                                                              : -1);
      }
      ply.polygons.push_back(std::move(polygon));
    }
  }

  std::string file_, text_;
  size_t at_ = 0;
  bool ascii_ = false, swap_ = false;
  std::vector<Element> elements_;
};

}  // namespace

SurfaceFile read_ply(const std::filesystem::path& file) {
  return Reader(file).read();
}

}  // namespace vasorod
