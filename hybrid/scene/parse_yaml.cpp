#include "scene/parse_yaml.h"

#include <cstdio>
#include <map>
#include <sstream>
#include <vector>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <vasorod/error.h>

#include "data/sentence.h"

namespace vasorod {

namespace {

// The deepest value of a scene, a number in a rod's stiffness matrix, is at nesting level nine.
constexpr std::size_t deepest = 50;
// yaml-cpp needs a few hundred bytes per value. No real scene comes near these limits.
constexpr std::size_t most_values = 2'000'000, most_bytes = 16'000'000;

[[noreturn]] void refuse(const std::string& file, int line, const std::string& found,
                         const std::string& expected) {
  throw InputError((file.empty() ? "line " : one_line(file) + ":") + std::to_string(line) +
                   ": found " + found + ", expected " + expected);
}

void check_bytes(const std::string& file, const std::string& text) {
  int line = 1;
  bool indentation = true, tab = false;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 32 && c != '\t' && c != '\n' && c != '\r') || byte == 127) {
      char hex[8];
      std::snprintf(hex, sizeof hex, "0x%02x", byte);
      refuse(file, line, "the control byte " + std::string(hex), "a scene as text in UTF-8");
    }
    if (c == '\n') {
      ++line;
      indentation = true;
      tab = false;
    } else if (indentation && c == '\t') {
      tab = true;
    } else if (indentation && c != ' ' && c != '\r') {
      if (tab && c != '#')
        refuse(file, line, "a tab in the indentation", "spaces, as YAML asks for");
      indentation = false;
    }
  }
}

// Follows the parser's events without building a tree. An alias counts as all it stands for.
class Guard : public YAML::EventHandler {
 public:
  Guard(const std::string& file, const std::string& text) : file_(file), text_(text) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ < 2) return;
    // yaml-cpp does not advance past a character that cannot start a value: every parse returns
    // one more empty document there.
    const auto at = static_cast<std::size_t>(mark.pos);
    const bool stray = at < text_.size() && std::string(",]}").find(text_[at]) != std::string::npos;
    if (stray)
      refuse(file_, mark.line + 1,
             "a stray " + in_quotes(text_.substr(at, 1)) + " in column " +
                 std::to_string(mark.column + 1),
             "a scene in YAML");
    refuse(file_, mark.line + 1, "a second YAML document", "one scene");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { value(mark, anchor); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string&) override {
    value(mark, anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto known = sizes_.find(anchor);
    if (known == sizes_.end())
      refuse(file_, mark.line + 1, "an alias within what it stands for", "no rings of aliases");
    count(mark, known->second);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    start(mark, anchor);
  }
  void OnSequenceEnd() override { end(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    start(mark, anchor);
  }
  void OnMapEnd() override { end(); }

 private:
  struct Open {
    YAML::anchor_t anchor;
    std::size_t before;
  };

  void count(const YAML::Mark& mark, std::size_t more) {
    values_ += more;
    if (values_ > most_values)
      refuse(file_, mark.line + 1, "more than " + std::to_string(most_values) + " values",
             "a scene, every alias counted in full");
  }
  void value(const YAML::Mark& mark, YAML::anchor_t anchor) {
    count(mark, 1);
    if (anchor != 0) sizes_[anchor] = 1;
  }
  void start(const YAML::Mark& mark, YAML::anchor_t anchor) {
    open_.push_back({anchor, values_});
    count(mark, 1);
    if (open_.size() > deepest)
      refuse(file_, mark.line + 1, "lists or maps nested " + std::to_string(open_.size()) + " deep",
             "at most " + std::to_string(deepest));
  }
  void end() {
    const Open closed = open_.back();
    open_.pop_back();
    if (closed.anchor != 0) sizes_[closed.anchor] = values_ - closed.before;
  }

  const std::string& file_;
  const std::string& text_;
  int documents_ = 0;
  std::size_t values_ = 0;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, std::size_t> sizes_;
};

}  // namespace

YAML::Node parse_yaml(const std::string& file, const std::string& text) {
  if (text.size() > most_bytes)
    refuse(file, 1, "a file of " + std::to_string(text.size()) + " bytes",
           "a scene of at most " + std::to_string(most_bytes));
  check_bytes(file, text);
  std::istringstream stream(text);
  try {
    YAML::Parser parser(stream);
    Guard guard(file, text);
    while (parser.HandleNextDocument(guard)) {  // the guard refuses the second
    }
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    refuse(file, error.mark.line + 1,
           "a YAML error in column " + std::to_string(error.mark.column + 1) + " (" +
               shortened(error.msg, 120) + ")",
           "a scene in YAML");
  }
}

}  // namespace vasorod
