// PNG (ISO 15948): signature, IHDR, one IDAT, IEND. Every row is stored as its difference from the
// row above. For shaded surfaces on an empty background this packs as well as a filter chosen per
// row, and the choice took most of libpng's time.
#include <array>
#include <stdexcept>
#include <vtkNew.h>
#include <vtkZLibDataCompressor.h>

#include "report/picture.h"

namespace vasorod {
namespace {

constexpr std::array<std::uint32_t, 256> crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t n = 0; n < 256; ++n) {
    table[n] = n;
    for (int k = 0; k < 8; ++k)
      table[n] = (table[n] & 1U) ? 0xEDB88320U ^ (table[n] >> 1U) : table[n] >> 1U;
  }
  return table;
}

void append_number(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((value >> shift) & 0xFFU);
}

void append_chunk(std::string& bytes, const std::string& type, const std::string& data) {
  static constexpr std::array<std::uint32_t, 256> table = crc_table();
  append_number(bytes, static_cast<std::uint32_t>(data.size()));
  const std::size_t checked = bytes.size();
  bytes += type;
  bytes += data;
  std::uint32_t crc = 0xFFFFFFFFU;
  for (std::size_t i = checked; i < bytes.size(); ++i)
    crc = table[(crc ^ static_cast<std::uint8_t>(bytes[i])) & 0xFFU] ^ (crc >> 8U);
  append_number(bytes, ~crc);
}

// Each row follows the number of its filter: 2, the difference from the row above.
std::string filtered(const Picture& picture) {
  const std::size_t line = 4 * static_cast<std::size_t>(picture.width),
                    rows = static_cast<std::size_t>(picture.height);
  std::string bytes(rows * (line + 1), '\2');
  for (std::size_t row = 0; row < rows; ++row) {
    const std::uint8_t* here = &picture.rgba[row * line];
    const std::uint8_t* above = row > 0 ? here - line : nullptr;
    char* out = &bytes[row * (line + 1) + 1];
    for (std::size_t k = 0; k < line; ++k)
      out[k] = static_cast<char>(static_cast<std::uint8_t>(here[k] - (above ? above[k] : 0)));
  }
  return bytes;
}

std::string deflated(const std::string& raw) {
  vtkNew<vtkZLibDataCompressor> zlib;
  zlib->SetCompressionLevel(1);
  std::string packed(zlib->GetMaximumCompressionSpace(raw.size()), '\0');
  const auto* from = reinterpret_cast<const unsigned char*>(raw.data());
  const std::size_t size = zlib->Compress(
      from, raw.size(), reinterpret_cast<unsigned char*>(packed.data()), packed.size());
  if (size == 0) throw std::runtime_error("png_bytes: zlib could not pack the picture");
  packed.resize(size);
  return packed;
}

}  // namespace

std::string png_bytes(const Picture& picture) {
  std::string header;
  append_number(header, static_cast<std::uint32_t>(picture.width));
  append_number(header, static_cast<std::uint32_t>(picture.height));
  header += std::string("\10\6\0\0\0", 5);  // 8 bits, RGBA, deflate, filters by row, not interlaced
  std::string bytes = "\x89PNG\r\n\x1A\n";
  append_chunk(bytes, "IHDR", header);
  append_chunk(bytes, "IDAT", deflated(filtered(picture)));
  append_chunk(bytes, "IEND", "");
  return bytes;
}

}  // namespace vasorod
