// The numbers and texts in the arrays of a VTP file, in every encoding: ascii, base64 or raw, in
// the array or appended, in both byte orders, packed with zlib, LZ4 or LZMA. An array that lies
// outside its file or does not have the length asked for is refused.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>
#include <vtkDataCompressor.h>
#include <vtkSmartPointer.h>

#include "surface_file/vtp_xml.h"

namespace vasorod {

/// A type of numbers.
struct VtpNumber {
  std::string_view name;  ///< as in the file: "Float64"
  std::size_t size;       ///< bytes
  bool integer;
  /// Turns `count` numbers into doubles; `swap`: they have the other byte order.
  void (*to_doubles)(const char* bytes, std::size_t count, bool swap, double* out);
};

/// The arrays of one file. Every function throws InputError (refuse_vtp) for what cannot be.
class VtpArrays {
 public:
  /// `text` is the whole file, `head` its tags; both must outlive this. Refuses a file that is not
  /// one of PolyData.
  VtpArrays(std::string file, std::string_view text, const VtpHead& head);

  [[noreturn]] void damaged(const VtpTag& tag, const std::string& what) const;

  /// An attribute as a whole number from 0 to `most`. If it is missing: `otherwise`, or an error.
  std::size_t count(const VtpTag& tag, const std::string& attribute, std::size_t most,
                    std::optional<std::size_t> otherwise) const;

  /// Null for bits and texts.
  const VtpNumber* type_of(const VtpTag& array) const;

  /// The `items` numbers of an array.
  std::vector<double> numbers(const VtpTag& array, const VtpNumber& type, std::size_t items);

  /// The first text of an array of texts, which VTK stores as bytes that end with a zero; nothing
  /// where the texts are longer than 4096 bytes.
  std::string first_text(const VtpTag& array);

 private:
  std::string format_of(const VtpTag& array) const;
  std::string_view encoded(const VtpTag& array, const std::string& format,
                           std::string& inline_data) const;
  std::vector<double> ascii_numbers(const VtpTag& array, std::size_t items) const;
  [[noreturn]] void wrong_length(const VtpTag& array) const;
  std::string front(const VtpTag& array, std::string_view from, bool base64,
                    std::size_t bytes) const;
  std::uint64_t word(const std::string& words, std::size_t k) const;
  std::string unpacked(const VtpTag& array, std::string_view from, bool base64, std::size_t bytes);
  std::string uncompressed(const VtpTag& array, std::string_view from, bool base64,
                           std::size_t bytes);
  void use(const VtpTag& array, std::size_t bytes);

  std::string file_;
  std::string_view text_;
  const VtpHead& head_;
  bool swap_ = false;
  std::size_t word_ = 4, most_expansion_ = 0, used_ = 0;
  vtkSmartPointer<vtkDataCompressor> compressor_;
};

}  // namespace vasorod
