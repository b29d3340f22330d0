#include "surface_file/vtp_xml.h"

#include <algorithm>
#include <charconv>

#include <vasorod/error.h>

#include "data/sentence.h"

namespace vasorod {

namespace {

// The deepest tag of a VTP file, the value of an information key of an array, is at level seven.
constexpr std::size_t deepest = 20;

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool is_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '.' || c == ':';
}

// One code point as UTF-8; empty if it is invalid.
std::string utf8(unsigned long code) {
  std::string out;
  if (code == 0 || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return out;
  if (code < 0x80) return {static_cast<char>(code)};
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  const unsigned long lead = more == 1 ? 0xC0 : more == 2 ? 0xE0 : 0xF0;
  out += static_cast<char>(lead | (code >> (6 * more)));
  for (int k = more - 1; k >= 0; --k) out += static_cast<char>(0x80 | ((code >> (6 * k)) & 0x3F));
  return out;
}

class Scanner {
 public:
  Scanner(const std::string& file, std::string_view text) : file_(file), text_(text) {}

  VtpHead read() {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
    VtpHead head;
    std::vector<VtpTag*> open;
    bool behind_start = false;  // the last tag opened an element, and text belongs to it
    while (true) {
      const std::size_t begin = at_, tag = text_.find('<', at_);
      if (tag == std::string_view::npos)
        damaged(text_.size(), open.empty() ? "no VTKFile in it" : "it ends within " + shown(open));
      const std::string_view between = text_.substr(begin, tag - begin);
      if (behind_start) open.back()->text = between;
      if (open.empty() && !std::all_of(between.begin(), between.end(), is_space))
        damaged(begin, "text before its first tag");
      at_ = tag + 1;
      if (starts("?")) {
        skip_past("?>");
      } else if (starts("!--")) {
        skip_past("-->");
      } else if (starts("/")) {
        ++at_;
        if (open.empty() || name() != open.back()->name)
          damaged(tag, "a closing tag that closes nothing");
        skip_spaces();
        if (!starts(">")) damaged(at_, "a closing tag that does not end");
        ++at_;
        open.pop_back();
        if (open.empty()) return head;
      } else {
        VtpTag read = start_tag(tag);
        if (read.name == "AppendedData" && open.size() == 1) {
          read_appended(read, head);
          return head;
        }
        if (open.size() >= deepest) damaged(tag, "tags within tags within tags");
        VtpTag* added = &head.root;
        if (open.empty())
          head.root = std::move(read);
        else
          added = &open.back()->children.emplace_back(std::move(read));
        if (!empty_element_) open.push_back(added);
        if (open.empty()) return head;
        behind_start = !empty_element_;
        continue;
      }
      behind_start = false;
    }
  }

 private:
  [[noreturn]] void damaged(std::size_t at, const std::string& what) const {
    refuse_vtp(file_, text_, at, what);
  }
  static std::string shown(const std::vector<VtpTag*>& open) {
    return in_quotes(open.back()->name);
  }
  bool starts(std::string_view what) const { return text_.substr(at_).starts_with(what); }
  void skip_spaces() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }
  void skip_past(std::string_view what) {
    const std::size_t end = text_.find(what, at_);
    if (end == std::string_view::npos) damaged(at_, "a comment that does not end");
    at_ = end + what.size();
  }
  std::string name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_name(text_[at_])) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }

  VtpTag start_tag(std::size_t tag_at) {
    VtpTag tag;
    tag.at = tag_at;
    tag.name = name();
    if (tag.name.empty()) damaged(tag_at, "a < that opens no tag");
    while (true) {
      const std::size_t before = at_;
      skip_spaces();
      empty_element_ = starts("/>");
      if (empty_element_ || starts(">")) {
        at_ += empty_element_ ? 2 : 1;
        return tag;
      }
      const std::size_t attribute_at = at_;
      const std::string attribute = name();
      if (attribute.empty() || before == attribute_at)
        damaged(attribute_at, "a tag " + in_quotes(tag.name) + " that does not end");
      skip_spaces();
      const bool equals = starts("=");
      if (equals) ++at_;
      skip_spaces();
      const char quote = at_ < text_.size() ? text_[at_] : ' ';
      const std::size_t end =
          quote == '"' || quote == '\'' ? text_.find(quote, at_ + 1) : std::string_view::npos;
      if (!equals || end == std::string_view::npos)
        damaged(attribute_at, "the attribute " + in_quotes(attribute) + " without a quoted value");
      const std::string_view raw = text_.substr(at_ + 1, end - at_ - 1);
      if (!tag.attributes.emplace(attribute, resolved(raw)).second)
        damaged(attribute_at, "the attribute " + in_quotes(attribute) + " a second time");
      at_ = end + 1;
    }
  }

  // Replaces references such as &amp; by their characters.
  std::string resolved(std::string_view raw) const {
    static const std::map<std::string_view, char> known{
        {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}};
    std::string out;
    for (std::size_t k = 0; k < raw.size(); ++k) {
      if (raw[k] == '<') damaged(at_, "a < within an attribute");
      if (raw[k] != '&') {
        out += raw[k];
        continue;
      }
      const std::size_t end = raw.find(';', k);
      if (end == std::string_view::npos) damaged(at_, "a & that stands for nothing");
      const std::string_view word = raw.substr(k + 1, end - k - 1);
      std::string character;
      if (const auto found = known.find(word); found != known.end()) {
        character = found->second;
      } else if (word.starts_with('#')) {
        const bool hex = word.starts_with("#x");
        const char *first = word.data() + (hex ? 2 : 1), *last = word.data() + word.size();
        unsigned long code = 0;
        const auto [stop, error] = std::from_chars(first, last, code, hex ? 16 : 10);
        if (error == std::errc() && stop == last) character = utf8(code);
      }
      if (character.empty()) damaged(at_, "a & that stands for nothing");
      out += character;
      k = end;
    }
    return out;
  }

  void read_appended(const VtpTag& tag, VtpHead& head) {
    const std::string encoding = tag.value("encoding");
    if (encoding != "raw" && encoding != "base64")
      damaged(tag.at, "the encoding " + in_quotes(encoding) + " of its appended data");
    head.appended_base64 = encoding == "base64";
    skip_spaces();
    const std::size_t end = text_.rfind("</AppendedData");
    if (!starts("_") || end == std::string_view::npos || end <= at_)
      damaged(at_, "appended data that do not begin or do not end");
    head.appended = text_.substr(at_ + 1, end - at_ - 1);
  }

  const std::string& file_;
  std::string_view text_;
  std::size_t at_ = 0;
  bool empty_element_ = false;  // the tag read last was <.../>
};

}  // namespace

const VtpTag* VtpTag::child(const std::string& child_name) const {
  for (const VtpTag& tag : children)
    if (tag.name == child_name) return &tag;
  return nullptr;
}

std::string VtpTag::value(const std::string& attribute) const {
  const auto found = attributes.find(attribute);
  return found == attributes.end() ? "" : found->second;
}

void refuse_vtp(const std::string& file, std::string_view text, std::size_t at,
                const std::string& what) {
  const auto* const end = text.begin() + static_cast<std::ptrdiff_t>(std::min(at, text.size()));
  throw InputError(file + ":" + std::to_string(1 + std::count(text.begin(), end, '\n')) +
                   ": found a damaged or truncated file (" + what + "), expected a sound VTP file");
}

VtpHead read_vtp_head(const std::string& file, std::string_view text) {
  return Scanner(file, text).read();
}

}  // namespace vasorod
