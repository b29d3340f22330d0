#include "planner/scene_edit.h"

#include <algorithm>
#include <sstream>
#include <yaml-cpp/yaml.h>

#include <vasorod/error.h>

#include "data/index.h"

namespace vasorod::planner {
namespace {

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text) {
  Lines lines;
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t end = text.find('\n', from);
    if (end == std::string::npos) {
      lines.push_back(text.substr(from));
      break;
    }
    lines.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

std::string joined(const Lines& lines) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) text += (i > 0 ? "\n" : "") + lines[i];
  return text;
}

// Two trees with the same values; the order of a map's keys does not count.
bool alike(const YAML::Node& a, const YAML::Node& b) {
  if (a.Type() != b.Type()) return false;
  if (a.IsScalar()) return a.Scalar() == b.Scalar() && a.Tag() == b.Tag();
  if (a.IsSequence()) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
      if (!alike(a[i], b[i])) return false;
    return true;
  }
  if (a.IsMap()) {
    if (a.size() != b.size()) return false;
    for (const auto& entry : a) {
      const YAML::Node other = b[entry.first.Scalar()];
      if (!other.IsDefined() || !alike(entry.second, other)) return false;
    }
  }
  return true;
}

// The tree that the new text has to mean.
YAML::Node wanted_tree(const std::string& text, const SceneEdit& edit) {
  YAML::Node root = YAML::Load(text);
  // Copied, so that a change does not show at the aliases of the same block.
  YAML::Node glenn = YAML::Clone(root["surgery"]["glenn"]);
  for (const auto& [key, value] : edit.glenn) glenn[key] = YAML::Load(value);
  YAML::Node surgery = YAML::Clone(root["surgery"]);
  surgery["glenn"] = glenn;
  YAML::Node whole;
  for (const auto& entry : root) {
    const std::string& key = entry.first.Scalar();
    if (key == "surgery")
      whole[key] = surgery;
    else if (edit.fidelity && (key == "accuracy" || key == "fidelity"))
      whole["fidelity"] = YAML::Load(*edit.fidelity);
    else
      whole[key] = YAML::Clone(entry.second);
  }
  return whole;
}

bool means(const std::string& text, const YAML::Node& wanted) {
  try {
    return alike(YAML::Load(text), wanted);
  } catch (const YAML::Exception&) {
    return false;
  }
}

std::size_t indent_of(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

bool blank_or_comment(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string::npos || line[first] == '#';
}

// One key of a block map in the text.
struct Entry {
  std::size_t first = 0, last = 0;  // its lines
  std::size_t column = 0;           // of the key
  std::size_t value = 0;            // in the first line: behind the colon
};

// The keys of a map in block style, one line or more each; empty where the map is written
// otherwise.
std::optional<std::vector<std::pair<std::string, Entry>>> entries_of(const YAML::Node& map,
                                                                     const Lines& lines) {
  if (map.Style() == YAML::EmitterStyle::Flow) return std::nullopt;
  std::vector<std::pair<std::string, Entry>> entries;
  for (const auto& one : map) {
    Entry entry;
    const YAML::Mark mark = one.first.Mark();
    if (mark.line < 0 || mark.column < 0 || index(mark.line) >= lines.size()) return std::nullopt;
    entry.first = index(mark.line);
    entry.column = index(mark.column);
    const std::string& line = lines[entry.first];
    const std::string& key = one.first.Scalar();
    if (indent_of(line) != entry.column || line.compare(entry.column, key.size(), key) != 0)
      return std::nullopt;
    entry.value = entry.column + key.size();
    if (entry.value >= line.size() || line[entry.value] != ':') return std::nullopt;
    ++entry.value;
    entry.last = entry.first;
    for (std::size_t i = entry.first + 1; i < lines.size(); ++i) {
      if (blank_or_comment(lines[i])) continue;
      // An item of a list may stand in its key's column.
      const bool item = indent_of(lines[i]) == entry.column && lines[i][entry.column] == '-';
      if (indent_of(lines[i]) <= entry.column && !item) break;
      entry.last = i;
    }
    entries.emplace_back(key, entry);
  }
  return entries;
}

const Entry* entry_named(const std::vector<std::pair<std::string, Entry>>& entries,
                         const std::string& key) {
  for (const auto& [name, entry] : entries)
    if (name == key) return &entry;
  return nullptr;
}

// Where a comment begins in a line, after `from`; npos: there is none.
std::size_t comment_in(const std::string& line, std::size_t from) {
  char quote = 0;
  for (std::size_t i = from; i < line.size(); ++i) {
    if (quote != 0) {
      if (line[i] == quote) quote = 0;
    } else if ((line[i] == '"' || line[i] == '\'') && (i == from || line[i - 1] == ' ')) {
      quote = line[i];
    } else if (line[i] == '#' && i > 0 && (line[i - 1] == ' ' || line[i - 1] == '\t')) {
      return i;
    }
  }
  return std::string::npos;
}

std::string said_before(const std::string& comment) {
  const std::size_t word = comment.find_first_not_of("# \t");
  if (word == std::string::npos || comment.compare(word, 4, "was:") == 0) return comment;
  return "# was: " + comment.substr(word);
}

// The line with another value, and the lines that its old value had beyond it taken away but for
// their comments.
void replace(Lines& lines, const Entry& entry, const std::string& key, const std::string& value) {
  std::string& line = lines[entry.first];
  const bool carriage = !line.empty() && line.back() == '\r';
  if (carriage) line.pop_back();
  const std::size_t comment = comment_in(line, entry.value);
  std::string written = std::string(entry.column, ' ') + key + ": " + value;
  if (comment != std::string::npos) {
    // The comment stays in its column where the new value leaves room.
    const std::size_t gap = comment > written.size() + 1 ? comment - written.size() : 2;
    written += std::string(gap, ' ') + said_before(line.substr(comment));
  }
  line = written + (carriage ? "\r" : "");
  for (std::size_t i = entry.last; i > entry.first; --i)
    if (!blank_or_comment(lines[i])) lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(i));
}

// The lines edited one by one; empty where they are not written one key a line.
std::optional<std::string> edited_lines(const std::string& text, const SceneEdit& edit) {
  const YAML::Node root = YAML::Load(text);
  Lines lines = lines_of(text);
  struct Change {
    Entry entry;
    std::string key, value;
  };
  std::vector<Change> changes;
  std::vector<std::string> fresh;
  const auto of_root = entries_of(root, lines);
  if (!of_root || !entries_of(root["surgery"], lines)) return std::nullopt;
  const auto of_glenn = entries_of(root["surgery"]["glenn"], lines);
  if (!of_glenn) return std::nullopt;
  const Entry* behind = entry_named(*of_glenn, "incision");
  if (behind == nullptr) return std::nullopt;
  const bool carriage = lines[behind->first].ends_with('\r');
  for (const auto& [key, value] : edit.glenn) {
    if (const Entry* entry = entry_named(*of_glenn, key))
      changes.push_back({*entry, key, value});
    else
      fresh.push_back(std::string(behind->column, ' ') + key + ": " + value +
                      (carriage ? "\r" : ""));
  }
  if (edit.fidelity) {
    const Entry* entry = entry_named(*of_root, "fidelity");
    if (entry == nullptr) entry = entry_named(*of_root, "accuracy");
    if (entry == nullptr) return std::nullopt;
    changes.push_back({*entry, "fidelity", *edit.fidelity});
  }
  // From below, so that the places above stay where they are.
  std::sort(changes.begin(), changes.end(),
            [](const Change& a, const Change& b) { return a.entry.first > b.entry.first; });
  bool inserted = false;
  const auto insert = [&] {
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(behind->last) + 1, fresh.begin(),
                 fresh.end());
    inserted = true;
  };
  for (const Change& change : changes) {
    if (!inserted && change.entry.first <= behind->first) insert();
    replace(lines, change.entry, change.key, change.value);
  }
  if (!inserted) insert();
  return joined(lines);
}

std::string emitted(const YAML::Node& node) {
  YAML::Emitter out;
  out.SetIndent(2);
  out << node;
  return out.c_str();
}

// The block `surgery` written anew between the lines of the others.
std::optional<std::string> rewritten_block(const std::string& text, const SceneEdit& edit,
                                           const YAML::Node& wanted) {
  const YAML::Node root = YAML::Load(text);
  Lines lines = lines_of(text);
  const auto of_root = entries_of(root, lines);
  if (!of_root) return std::nullopt;
  const Entry* surgery = entry_named(*of_root, "surgery");
  const Entry* fidelity = entry_named(*of_root, "fidelity");
  if (fidelity == nullptr) fidelity = entry_named(*of_root, "accuracy");
  if (surgery == nullptr || (edit.fidelity && fidelity == nullptr)) return std::nullopt;
  const auto write_block = [&] {
    YAML::Node block;
    block["surgery"] = YAML::Clone(wanted["surgery"]);
    block["surgery"].SetStyle(YAML::EmitterStyle::Block);
    block["surgery"]["glenn"].SetStyle(YAML::EmitterStyle::Block);
    const Lines fresh = lines_of(emitted(block));
    const auto first = lines.begin() + static_cast<std::ptrdiff_t>(surgery->first);
    lines.erase(first, lines.begin() + static_cast<std::ptrdiff_t>(surgery->last) + 1);
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(surgery->first), fresh.begin(),
                 fresh.end());
  };
  const bool first = fidelity != nullptr && fidelity->first > surgery->first;
  if (edit.fidelity && first) replace(lines, *fidelity, "fidelity", *edit.fidelity);
  write_block();
  if (edit.fidelity && !first) replace(lines, *fidelity, "fidelity", *edit.fidelity);
  return joined(lines);
}

}  // namespace

EditedScene edited_scene(const std::string& text, const SceneEdit& edit) {
  YAML::Node wanted;
  try {
    const YAML::Node root = YAML::Load(text);
    if (!root.IsMap() || !root["surgery"].IsMap() || !root["surgery"]["glenn"].IsMap())
      throw InputError("found a scene without surgery: glenn, expected one whose plan is changed");
    wanted = wanted_tree(text, edit);
  } catch (const YAML::Exception& error) {
    throw InputError(std::string("found a scene that is no YAML (") + error.what() +
                     "), expected a scene file");
  }
  if (const auto lines = edited_lines(text, edit); lines && means(*lines, wanted))
    return {*lines, std::nullopt};
  if (const auto block = rewritten_block(text, edit, wanted); block && means(*block, wanted))
    return {*block,
            "the lines of surgery could not be edited one by one, so the block was written anew, "
            "without its comments"};
  return {emitted(wanted) + "\n",
          "the file could not be edited line by line, so it was written anew, without comments"};
}

}  // namespace vasorod::planner
