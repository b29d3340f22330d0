#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <sstream>
#include <vtkCallbackCommand.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkSmartPointer.h>
#include <vtkZLibDataCompressor.h>

#include "data/index.h"
#include "data/sentence.h"
#include "data/whole_file.h"
#include "surface_file/space.h"
#include "surface_file/surface_file.h"
#include "surface_file/vtp_xml.h"

namespace vasorod {

namespace {

template <class Number>
void to_doubles(const char* bytes, std::size_t count, bool swap, double* out) {
  for (std::size_t i = 0; i < count; ++i) {
    std::array<char, sizeof(Number)> one;
    std::memcpy(one.data(), bytes + i * sizeof(Number), sizeof(Number));
    if (swap) std::reverse(one.begin(), one.end());
    out[i] = static_cast<double>(std::bit_cast<Number>(one));
  }
}

struct Type {
  std::string_view name;
  std::size_t size;
  bool integer;
  void (*to_doubles)(const char*, std::size_t, bool, double*);
};

constexpr std::array<Type, 10> types{{{"Int8", 1, true, to_doubles<std::int8_t>},
                                      {"UInt8", 1, true, to_doubles<std::uint8_t>},
                                      {"Int16", 2, true, to_doubles<std::int16_t>},
                                      {"UInt16", 2, true, to_doubles<std::uint16_t>},
                                      {"Int32", 4, true, to_doubles<std::int32_t>},
                                      {"UInt32", 4, true, to_doubles<std::uint32_t>},
                                      {"Int64", 8, true, to_doubles<std::int64_t>},
                                      {"UInt64", 8, true, to_doubles<std::uint64_t>},
                                      {"Float32", 4, false, to_doubles<float>},
                                      {"Float64", 8, false, to_doubles<double>}}};

// Limits of a file: an int must be able to count points and cells; the components of an array.
constexpr std::size_t most_items = std::numeric_limits<int>::max(), most_components = 10000;

// Each block states its unpacked size. zlib reaches at most 1032 : 1, LZ4 less, LZMA more. A larger
// ratio means a damaged file, and would allocate memory that the file cannot fill.
constexpr std::size_t most_expansion = 1100, most_expansion_lzma = 20000;

std::array<unsigned char, 256> base64_values() {
  std::array<unsigned char, 256> values;
  values.fill(255);
  const std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < letters.size(); ++i)
    values[static_cast<unsigned char>(letters[i])] = static_cast<unsigned char>(i);
  return values;
}

// Decodes the first `bytes` bytes of `text`; empty if it is too short or not base64.
std::optional<std::string> from_base64(std::string_view text, std::size_t bytes) {
  static const auto values = base64_values();
  const std::size_t groups = (bytes + 2) / 3;
  if (text.size() / 4 < groups) return std::nullopt;
  std::string out;
  out.reserve(3 * groups);
  for (std::size_t g = 0; g < groups; ++g) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const char c = text[4 * g + k];
      const bool padding = c == '=' && g + 1 == groups && 3 * g + k > bytes;
      const unsigned value = padding ? 0 : values[static_cast<unsigned char>(c)];
      if (value > 63) return std::nullopt;
      bits = bits << 6 | value;
    }
    for (const unsigned shift : {16U, 8U, 0U}) out += static_cast<char>(bits >> shift & 255U);
  }
  out.resize(bytes);
  return out;
}

vtkSmartPointer<vtkDataCompressor> compressor_named(const std::string& name) {
  vtkSmartPointer<vtkDataCompressor> compressor;
  if (name == "vtkZLibDataCompressor") compressor = vtkSmartPointer<vtkZLibDataCompressor>::New();
  if (name == "vtkLZ4DataCompressor") compressor = vtkSmartPointer<vtkLZ4DataCompressor>::New();
  if (name == "vtkLZMADataCompressor") compressor = vtkSmartPointer<vtkLZMADataCompressor>::New();
  if (compressor) {  // otherwise it prints the error that our exception states
    const auto silence = vtkSmartPointer<vtkCallbackCommand>::New();
    compressor->AddObserver("ErrorEvent", silence);
    compressor->AddObserver("WarningEvent", silence);
  }
  return compressor;
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file)
      : file_(file.string()), text_(whole_file(file)) {
    head_ = read_vtp_head(file_, text_);
  }

  std::vector<SurfaceFile> pieces() {
    read_attributes();
    const VtpTag* data = head_.root.child("PolyData");
    if (data == nullptr) damaged(head_.root, "no PolyData in it");
    std::vector<SurfaceFile> pieces;
    for (const VtpTag& tag : data->children)
      if (tag.name == "Piece") pieces.push_back(read_piece(tag));
    if (pieces.empty()) damaged(*data, "no Piece in it");
    pieces.front().space = read_space(*data);
    return pieces;
  }

 private:
  [[noreturn]] void damaged(const VtpTag& tag, const std::string& what) const {
    refuse_vtp(file_, text_, tag.at, what);
  }

  void read_attributes() {
    const VtpTag& root = head_.root;
    if (root.name != "VTKFile" || root.value("type") != "PolyData")
      damaged(root, "a " + in_quotes(root.name) + " of type " + in_quotes(root.value("type")) +
                        " instead of a VTKFile of PolyData");
    const std::string order = root.value("byte_order");
    const bool little = std::endian::native == std::endian::little;
    if (order != "" && order != "LittleEndian" && order != "BigEndian")
      damaged(root, "the byte_order " + in_quotes(order));
    swap_ = order != "" && (order == "LittleEndian") != little;
    const std::string header = root.value("header_type");
    if (header != "" && header != "UInt32" && header != "UInt64")
      damaged(root, "the header_type " + in_quotes(header));
    word_ = header == "UInt64" ? 8 : 4;
    const std::string compressor = root.value("compressor");
    compressor_ = compressor_named(compressor);
    if (!compressor.empty() && !compressor_)
      damaged(root, "the compressor " + in_quotes(compressor));
    most_expansion_ = compressor == "vtkLZMADataCompressor" ? most_expansion_lzma : most_expansion;
  }

  // An attribute as a whole number from 0 to `most`. If it is missing: `otherwise`, or an error.
  std::size_t count(const VtpTag& tag, const std::string& attribute, std::size_t most,
                    std::optional<std::size_t> otherwise) const {
    if (!tag.attributes.contains(attribute)) {
      if (otherwise) return *otherwise;
      damaged(tag, "a " + in_quotes(tag.name) + " without " + attribute);
    }
    const std::string text = tag.value(attribute);
    std::size_t value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || stop != text.data() + text.size() || value > most)
      damaged(tag, "the " + attribute + " " + in_quotes(text));
    return value;
  }

  const Type* type_of(const VtpTag& array) const {
    const std::string name = array.value("type");
    for (const Type& type : types)
      if (type.name == name) return &type;
    if (name != "Bit" && name != "String") damaged(array, "the type " + in_quotes(name));
    return nullptr;
  }

  std::size_t components(const VtpTag& array) const {
    const std::size_t value = count(array, "NumberOfComponents", most_components, 1);
    if (value == 0) damaged(array, "an array of no components");
    return value;
  }

  std::string called(const VtpTag& array) const {
    return "the array " + in_quotes(array.value("Name"));
  }

  // Reads the `items` numbers of an array in any encoding.
  std::vector<double> numbers(const VtpTag& array, const Type& type, std::size_t items) {
    if (items == 0) return {};
    const std::string format = format_of(array);
    if (format == "ascii") return ascii_numbers(array, items);
    std::string inline_data;
    const bool base64 = format == "binary" || head_.appended_base64;
    const std::string bytes =
        unpacked(array, encoded(array, format, inline_data), base64, items * type.size);
    std::vector<double> values(items);
    type.to_doubles(bytes.data(), items, swap_, values.data());
    return values;
  }

  // ascii, binary (inline) or appended.
  std::string format_of(const VtpTag& array) const {
    std::string format = array.value("format");
    if (format.empty()) format = array.attributes.contains("offset") ? "appended" : "ascii";
    if (format != "ascii" && format != "binary" && format != "appended")
      damaged(array, "the format " + in_quotes(format));
    return format;
  }

  // Where the data of an array that is not ascii begin, header first. `inline_data` holds those of
  // an inline array, without its white space.
  std::string_view encoded(const VtpTag& array, const std::string& format,
                           std::string& inline_data) const {
    if (format == "appended") {
      const std::size_t offset =
          count(array, "offset", std::numeric_limits<std::size_t>::max(), std::nullopt);
      if (offset >= head_.appended.size())
        damaged(array, called(array) + " with an offset behind the file's end");
      return head_.appended.substr(offset);
    }
    inline_data = array.text;
    std::erase_if(inline_data,
                  [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; });
    return inline_data;
  }

  // The first text of an array of texts, which VTK stores as bytes that end with a zero; nothing
  // where the texts are longer than the name of a space can be.
  std::string first_text(const VtpTag& array) {
    constexpr std::size_t longest = 4096;
    const std::string format = format_of(array);
    std::string bytes;
    if (format == "ascii") {
      std::istringstream codes{std::string(array.text)};
      for (int code = 0; codes >> code && code > 0 && code < 128 && bytes.size() < longest;)
        bytes += static_cast<char>(code);
      return bytes;
    }
    std::string inline_data;
    const bool base64 = format == "binary" || head_.appended_base64;
    const std::string_view from = encoded(array, format, inline_data);
    const std::string sizes = front(array, from, base64, (compressor_ ? 3 : 1) * word_);
    std::uint64_t length = word(sizes, 0);
    if (compressor_) {
      if (length != 1) return {};  // so short a text is one block
      length = word(sizes, 2) > 0 ? word(sizes, 2) : word(sizes, 1);
    }
    if (length > longest) return {};
    bytes = unpacked(array, from, base64, length);
    return bytes.substr(0, bytes.find('\0'));
  }

  // What 3D Slicer says in the field data of the coordinates' space.
  std::string read_space(const VtpTag& data) {
    const VtpTag* fields = data.child("FieldData");
    if (fields == nullptr) return {};
    for (const VtpTag& tag : fields->children)
      if (tag.value("Name") == "SPACE" && tag.value("type") == "String")
        return known_space(first_text(tag));
    return {};
  }

  std::vector<double> ascii_numbers(const VtpTag& array, std::size_t items) const {
    const std::string_view text = array.text;
    if (items > text.size() / 2 + 1) wrong_length(array);
    std::vector<double> values;
    values.reserve(items);
    const char *at = text.data(), *const end = text.data() + text.size();
    while (true) {
      while (at < end && static_cast<unsigned char>(*at) <= ' ') ++at;
      if (at == end) break;
      if (*at == '+') ++at;
      double value = 0;
      const auto [stop, error] = std::from_chars(at, end, value);
      if (error != std::errc() || (stop<end&& static_cast<unsigned char>(*stop)> ' '))
        damaged(array, called(array) + " with a word where a number belongs");
      values.push_back(value);
      at = stop;
    }
    if (values.size() != items) wrong_length(array);
    return values;
  }

  [[noreturn]] void wrong_length(const VtpTag& array) const {
    damaged(array, called(array) + " is not as long as its points or cells ask for");
  }

  // The first `bytes` bytes of `from`, decoded.
  std::string front(const VtpTag& array, std::string_view from, bool base64,
                    std::size_t bytes) const {
    if (base64) {
      if (auto decoded = from_base64(from, bytes)) return std::move(*decoded);
    } else if (bytes <= from.size()) {
      return std::string(from.substr(0, bytes));
    }
    damaged(array, called(array) + " does not fit into the file");
  }

  std::uint64_t word(const std::string& words, std::size_t k) const {
    std::string one = words.substr(k * word_, word_);
    if (swap_) std::reverse(one.begin(), one.end());
    if (std::endian::native == std::endian::big)
      one.insert(0, 8 - word_, '\0');
    else
      one.resize(8, '\0');
    std::uint64_t value = 0;
    std::memcpy(&value, one.data(), 8);
    return value;
  }

  // The bytes of an array after its header, which must state the same number.
  std::string unpacked(const VtpTag& array, std::string_view from, bool base64, std::size_t bytes) {
    if (compressor_) return uncompressed(array, from, base64, bytes);
    if (word(front(array, from, base64, word_), 0) != bytes) wrong_length(array);
    use(array, word_ + bytes);
    return front(array, from, base64, word_ + bytes).substr(word_);
  }

  // The header of a compressed array: number of blocks, size of a block, size of the last block if
  // that is smaller, packed size of each block.
  std::string uncompressed(const VtpTag& array, std::string_view from, bool base64,
                           std::size_t bytes) {
    const std::string sizes = front(array, from, base64, 3 * word_);
    const std::uint64_t blocks = word(sizes, 0), size = word(sizes, 1), last = word(sizes, 2);
    if (blocks == 0 || blocks > from.size() / word_ || size == 0 || size > bytes + (1U << 30) ||
        last > size)
      damaged(array, called(array) + " in blocks that cannot be");
    // In long double, because the product of two wrong numbers may exceed 64 bits.
    const auto total =
        static_cast<long double>(blocks - (last > 0 ? 1 : 0)) * static_cast<long double>(size) +
        static_cast<long double>(last);
    if (total != static_cast<long double>(bytes)) wrong_length(array);
    const std::size_t head = (3 + blocks) * word_;
    const std::string packed_sizes = front(array, from, base64, head);
    std::size_t packed = 0;
    for (std::size_t k = 0; k < blocks; ++k) {
      const std::uint64_t one = word(packed_sizes, 3 + k);
      const std::uint64_t whole = k + 1 == blocks && last > 0 ? last : size;
      if (one > from.size() || whole / most_expansion_ > one + 1)
        damaged(array, called(array) + " in blocks that cannot be");
      packed += one;
      if (packed > from.size()) damaged(array, called(array) + " does not fit into the file");
    }
    use(array, head + packed);
    from.remove_prefix(std::min(from.size(), base64 ? (head + 2) / 3 * 4 : head));
    const std::string data = front(array, from, base64, packed);
    std::string out(bytes, '\0');
    const auto* in = reinterpret_cast<const unsigned char*>(data.data());
    auto* to = reinterpret_cast<unsigned char*>(out.data());
    for (std::size_t k = 0; k < blocks; ++k) {
      const std::size_t one = word(packed_sizes, 3 + k);
      const std::size_t whole = k + 1 == blocks && last > 0 ? last : size;
      if (compressor_->Uncompress(in, one, to, whole) != whole)
        damaged(array, called(array) + " with a block that does not unpack");
      in += one;
      to += whole;
    }
    return out;
  }

  // Arrays must not share bytes: a small file with many such arrays would fill the memory.
  void use(const VtpTag& array, std::size_t bytes) {
    used_ += bytes;
    if (used_ > text_.size()) damaged(array, called(array) + " lies over other arrays");
  }

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
      damaged(piece, "no connectivity or offsets of its " + kind);
    const Type *id_type = type_of(*ids), *end_type = type_of(*ends);
    if (id_type == nullptr || !id_type->integer || end_type == nullptr || !end_type->integer)
      damaged(*section, "cells of another type than whole numbers");
    const std::vector<double> offsets = numbers(*ends, *end_type, cells);
    double before = 0;
    for (const double end : offsets) {
      if (!(end >= before && end <= static_cast<double>(most_items) * 8))
        damaged(*ends, "offsets that do not fit");
      before = end;
    }
    const std::vector<double> points = numbers(*ids, *id_type, static_cast<std::size_t>(before));
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
      const Type* type = tag.name == "DataArray" ? type_of(tag) : nullptr;
      const bool known = std::any_of(arrays.begin(), arrays.end(),
                                     [&](const NamedArray& array) { return array.name == name; });
      if (type == nullptr || name.empty() || known) continue;  // strings are skipped
      const std::size_t columns = components(tag);
      const std::vector<double> values = numbers(tag, *type, rows * columns);
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
    const std::size_t points = count(piece, "NumberOfPoints", most_items, std::nullopt);
    const auto cells = [&](const std::string& kind) {
      return count(piece, "NumberOf" + kind, most_items, 0);
    };
    SurfaceFile out;
    out.points.resize(0, 3);
    if (points > 0) {
      const VtpTag* section = piece.child("Points");
      const VtpTag* at = section ? array_of(*section, "") : nullptr;
      if (at == nullptr) damaged(piece, "no Points in it");
      const Type* type = type_of(*at);
      if (type == nullptr || components(*at) != 3)
        damaged(*at, "points of other than three coordinates");
      const std::vector<double> values = numbers(*at, *type, 3 * points);
      out.points.resize(static_cast<Eigen::Index>(points), 3);
      std::copy(values.begin(), values.end(), out.points.data());
    }
    const std::size_t skipped = cells("Verts") + cells("Lines");
    const std::size_t all = skipped + cells("Polys") + cells("Strips");
    if (all > most_items) damaged(piece, "more cells than can be numbered");
    read_cells(piece, "Verts", cells("Verts"));  // checked but not kept
    out.lines = read_cells(piece, "Lines", cells("Lines"));
    out.polygons = read_cells(piece, "Polys", cells("Polys"));
    out.strips = read_cells(piece, "Strips", cells("Strips"));
    out.skipped_cells = static_cast<int>(skipped);
    out.point_arrays = read_arrays(piece.child("PointData"), points);
    out.cell_arrays = read_arrays(piece.child("CellData"), all);
    return out;
  }

  std::string file_, text_;
  VtpHead head_;
  bool swap_ = false;
  std::size_t word_ = 4, most_expansion_ = most_expansion, used_ = 0;
  vtkSmartPointer<vtkDataCompressor> compressor_;
};

const NamedArray* like(const std::vector<NamedArray>& arrays, const NamedArray& wanted) {
  for (const NamedArray& array : arrays)
    if (array.name == wanted.name && array.values.cols() == wanted.values.cols()) return &array;
  return nullptr;
}

// Joins the arrays that all pieces have. `blocks` gives the order of the rows: piece, first row and
// number of rows.
template <class Arrays>
std::vector<NamedArray> joined_arrays(const std::vector<SurfaceFile>& pieces, Arrays arrays_of,
                                      const std::vector<std::array<Eigen::Index, 3>>& blocks) {
  std::vector<NamedArray> joined;
  Eigen::Index rows = 0;
  for (const auto& [piece, first, count] : blocks) rows += count;
  for (const NamedArray& array : arrays_of(pieces.front())) {
    const bool everywhere = std::all_of(pieces.begin(), pieces.end(), [&](const SurfaceFile& p) {
      return like(arrays_of(p), array) != nullptr;
    });
    if (!everywhere) continue;
    NamedArray all = array;
    all.values.resize(rows, array.values.cols());
    Eigen::Index at = 0;
    for (const auto& [piece, first, count] : blocks) {
      all.values.middleRows(at, count) =
          like(arrays_of(pieces[index(piece)]), array)->values.middleRows(first, count);
      at += count;
    }
    joined.push_back(std::move(all));
  }
  return joined;
}

// Joins several pieces: points piece by piece, cells kind by kind.
SurfaceFile joined(const std::vector<SurfaceFile>& pieces) {
  SurfaceFile all;
  all.space = pieces.front().space;
  std::vector<std::array<Eigen::Index, 3>> point_rows, skipped_rows, polygon_rows, strip_rows;
  Eigen::Index points = 0;
  for (const SurfaceFile& piece : pieces) points += piece.points.rows();
  all.points.resize(points, 3);
  points = 0;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const SurfaceFile& piece = pieces[p];
    const auto at = static_cast<Eigen::Index>(p);
    const Eigen::Index skipped = piece.skipped_cells, polygons = std::ssize(piece.polygons);
    point_rows.push_back({at, 0, piece.points.rows()});
    skipped_rows.push_back({at, 0, skipped});
    polygon_rows.push_back({at, skipped, polygons});
    strip_rows.push_back({at, skipped + polygons, std::ssize(piece.strips)});
    all.points.middleRows(points, piece.points.rows()) = piece.points;
    const auto add = [&](const std::vector<std::vector<int>>& from,
                         std::vector<std::vector<int>>& to) {
      for (std::vector<int> cell : from) {
        for (int& id : cell)  // an index outside its piece stays invalid
          id = id >= 0 && id < piece.points.rows() && points + id < std::numeric_limits<int>::max()
                   ? static_cast<int>(points) + id
                   : -1;
        to.push_back(std::move(cell));
      }
    };
    add(piece.lines, all.lines);
    add(piece.polygons, all.polygons);
    add(piece.strips, all.strips);
    all.skipped_cells += piece.skipped_cells;
    points += piece.points.rows();
  }
  all.point_arrays = joined_arrays(
      pieces, [](const SurfaceFile& p) -> auto& { return p.point_arrays; }, point_rows);
  auto& cell_rows = skipped_rows;
  cell_rows.insert(cell_rows.end(), polygon_rows.begin(), polygon_rows.end());
  cell_rows.insert(cell_rows.end(), strip_rows.begin(), strip_rows.end());
  all.cell_arrays = joined_arrays(
      pieces, [](const SurfaceFile& p) -> auto& { return p.cell_arrays; }, cell_rows);
  return all;
}

}  // namespace

SurfaceFile read_vtp(const std::filesystem::path& file) {
  std::vector<SurfaceFile> pieces = Reader(file).pieces();
  return pieces.size() == 1 ? std::move(pieces.front()) : joined(pieces);
}

}  // namespace vasorod
