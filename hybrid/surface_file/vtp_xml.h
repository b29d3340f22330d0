// Parses the XML of a VTP file: tags and attributes, only the part of XML that such files use. Any
// input is parsed in one pass or refused with one sentence.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace vasorod {

struct VtpTag {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string_view text;  ///< between this tag and the next: the data of an inline array
  std::size_t at = 0;     ///< where it begins in the file
  std::vector<VtpTag> children;

  /// The first child of that name, or null.
  const VtpTag* child(const std::string& child_name) const;
  /// An attribute's value; empty when it is missing.
  std::string value(const std::string& attribute) const;
};

struct VtpHead {
  VtpTag root;
  std::string_view appended;  ///< after the underscore, up to the closing tag
  bool appended_base64 = false;
};

/// Throws InputError "FILE:LINE: found a damaged or truncated file (WHAT), expected a sound VTP
/// file" for the place `at` of its text.
[[noreturn]] void refuse_vtp(const std::string& file, std::string_view text, std::size_t at,
                             const std::string& what);

/// `text` is the whole file; the head points into it.
VtpHead read_vtp_head(const std::string& file, std::string_view text);

}  // namespace vasorod
