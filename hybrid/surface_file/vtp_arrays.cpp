#include "surface_file/vtp_arrays.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <limits>
#include <sstream>
#include <utility>
#include <vtkCallbackCommand.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkZLibDataCompressor.h>

#include "data/sentence.h"

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

constexpr std::array<VtpNumber, 10> types{{{"Int8", 1, true, to_doubles<std::int8_t>},
                                           {"UInt8", 1, true, to_doubles<std::uint8_t>},
                                           {"Int16", 2, true, to_doubles<std::int16_t>},
                                           {"UInt16", 2, true, to_doubles<std::uint16_t>},
                                           {"Int32", 4, true, to_doubles<std::int32_t>},
                                           {"UInt32", 4, true, to_doubles<std::uint32_t>},
                                           {"Int64", 8, true, to_doubles<std::int64_t>},
                                           {"UInt64", 8, true, to_doubles<std::uint64_t>},
                                           {"Float32", 4, false, to_doubles<float>},
                                           {"Float64", 8, false, to_doubles<double>}}};

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

std::string called(const VtpTag& array) {
  return "the array " + in_quotes(array.value("Name"));
}

}  // namespace

VtpArrays::VtpArrays(std::string file, std::string_view text, const VtpHead& head)
    : file_(std::move(file)), text_(text), head_(head) {
  const VtpTag& root = head_.root;
  if (root.name != "VTKFile" || root.value("type") != "PolyData")
    damaged(root, "a " + in_quotes(root.name) + " of type " + in_quotes(root.value("type")) +
                      " instead of a VTKFile of PolyData");
  const std::string order = root.value("byte_order");
  const bool little = std::endian::native == std::endian::little;
  if (!order.empty() && order != "LittleEndian" && order != "BigEndian")
    damaged(root, "the byte_order " + in_quotes(order));
  swap_ = !order.empty() && (order == "LittleEndian") != little;
  const std::string header = root.value("header_type");
  if (!header.empty() && header != "UInt32" && header != "UInt64")
    damaged(root, "the header_type " + in_quotes(header));
  word_ = header == "UInt64" ? 8 : 4;
  const std::string compressor = root.value("compressor");
  compressor_ = compressor_named(compressor);
  if (!compressor.empty() && !compressor_) damaged(root, "the compressor " + in_quotes(compressor));
  most_expansion_ = compressor == "vtkLZMADataCompressor" ? most_expansion_lzma : most_expansion;
}

void VtpArrays::damaged(const VtpTag& tag, const std::string& what) const {
  refuse_vtp(file_, text_, tag.at, what);
}

std::size_t VtpArrays::count(const VtpTag& tag, const std::string& attribute, std::size_t most,
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

const VtpNumber* VtpArrays::type_of(const VtpTag& array) const {
  const std::string name = array.value("type");
  for (const VtpNumber& type : types)
    if (type.name == name) return &type;
  if (name != "Bit" && name != "String") damaged(array, "the type " + in_quotes(name));
  return nullptr;
}

std::vector<double> VtpArrays::numbers(const VtpTag& array, const VtpNumber& type,
                                       std::size_t items) {
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
std::string VtpArrays::format_of(const VtpTag& array) const {
  std::string format = array.value("format");
  if (format.empty()) format = array.attributes.contains("offset") ? "appended" : "ascii";
  if (format != "ascii" && format != "binary" && format != "appended")
    damaged(array, "the format " + in_quotes(format));
  return format;
}

// Where the data of an array that is not ascii begin, header first. `inline_data` holds those of
// an inline array, without its white space.
std::string_view VtpArrays::encoded(const VtpTag& array, const std::string& format,
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

std::string VtpArrays::first_text(const VtpTag& array) {
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

std::vector<double> VtpArrays::ascii_numbers(const VtpTag& array, std::size_t items) const {
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

void VtpArrays::wrong_length(const VtpTag& array) const {
  damaged(array, called(array) + " is not as long as its points or cells ask for");
}

// The first `bytes` bytes of `from`, decoded.
std::string VtpArrays::front(const VtpTag& array, std::string_view from, bool base64,
                             std::size_t bytes) const {
  if (base64) {
    if (auto decoded = from_base64(from, bytes)) return std::move(*decoded);
  } else if (bytes <= from.size()) {
    return std::string(from.substr(0, bytes));
  }
  damaged(array, called(array) + " does not fit into the file");
}

std::uint64_t VtpArrays::word(const std::string& words, std::size_t k) const {
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
std::string VtpArrays::unpacked(const VtpTag& array, std::string_view from, bool base64,
                                std::size_t bytes) {
  if (compressor_) return uncompressed(array, from, base64, bytes);
  if (word(front(array, from, base64, word_), 0) != bytes) wrong_length(array);
  use(array, word_ + bytes);
  return front(array, from, base64, word_ + bytes).substr(word_);
}

// The header of a compressed array: number of blocks, size of a block, size of the last block if
// that is smaller, packed size of each block.
std::string VtpArrays::uncompressed(const VtpTag& array, std::string_view from, bool base64,
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
void VtpArrays::use(const VtpTag& array, std::size_t bytes) {
  used_ += bytes;
  if (used_ > text_.size()) damaged(array, called(array) + " lies over other arrays");
}

}  // namespace vasorod
