#include "explore/index_page.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include <vasorod/version.h>

#include "data/sentence.h"
#include "explore/index_assets.h"
#include "explore/options.h"
#include "report/page_assets.h"
#include "report/report_parts.h"

namespace vasorod {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json json_of(const RankedRow& ranked, const std::map<std::string, std::string>& links) {
  const Row& row = ranked.row;
  const bool solved = row.ending == Ending::solved;
  Json json{{"option", row.option},
            {"rank", ranked.rank},
            {"mark", to_string(ranked.mark)},
            {"score", number(ranked.score)},
            {"fidelity", row.fidelity},
            {"ending", to_string(row.ending)},
            {"status", solved ? to_string(row.status) : ""},
            {"folder", row.folder},
            {"link", links.contains(row.option) ? links.at(row.option) : ""},
            {"past", ranked.past},
            {"sentences", row.sentences}};
  json["in_range"] = row.in_range ? Json(*row.in_range) : Json();
  json["values"] = Json::object();
  for (const auto& [key, value] : row.values) json["values"][key] = value;
  json["criteria"] = Json::object();
  for (const auto& [name, value] : row.criteria) json["criteria"][name] = number(value);
  return json;
}

Json json_of(const RankingCriterion& criterion) {
  return {{"name", criterion.name},
          {"title", criterion.title},
          {"unit", criterion.unit},
          {"threshold", number(criterion.threshold)},
          {"weight", number(criterion.weight)},
          {"distance", criterion.ideal == 1 && !criterion.small_is_bad},
          {"source", criterion.source}};
}

std::string data_of(const IndexPage& page, const std::vector<RankedRow>& rows) {
  Json data{{"keys", page.keys}};
  data["criteria"] = Json::array();
  for (const RankingCriterion& criterion : page.criteria)
    data["criteria"].push_back(json_of(criterion));
  data["colours"] = Json::array();
  for (const auto& [name, title] : page.colours)
    data["colours"].push_back({{"name", name}, {"title", title}});
  data["rows"] = Json::array();
  for (const RankedRow& row : rows) data["rows"].push_back(json_of(row, page.links));
  data["pictures"] = Json::object();
  for (const auto& [option, pictures] : page.pictures)
    data["pictures"][option] = Json::parse(pictures);
  const std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string safe;  // inside a script element
  for (const char c : text)
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  return safe;
}

std::string summary(const IndexPage& page, const std::vector<RankedRow>& rows) {
  int converged = 0, solved = 0, refused = 0, failed = 0, kept = 0;
  for (const RankedRow& one : rows) {
    const bool has_result = one.row.ending == Ending::solved;
    solved += has_result ? 1 : 0;
    converged += has_result && one.row.status == Status::converged ? 1 : 0;
    refused += one.row.ending == Ending::not_built ? 1 : 0;
    failed += one.row.ending == Ending::failed ? 1 : 0;
    kept += has_result && !one.row.folder.empty() ? 1 : 0;
  }
  std::string html = "<p>" + std::to_string(rows.size()) + " options: " + std::to_string(solved) +
                     " solved, " + std::to_string(converged) + " of them converged; " +
                     std::to_string(refused) + " cannot be built";
  if (failed > 0) html += "; " + std::to_string(failed) + " failed";
  html += "; " + std::to_string(kept) + " kept with their result folders.</p>\n";
  if (!page.finished)
    html +=
        "<div class=\"notice warn\"><strong>The exploration was stopped before its end.</strong> "
        "The "
        "same command goes on where it stopped.</div>\n";
  return html;
}

std::string range_text(const Spread& spread, const std::string& name) {
  const auto found = spread.intervals.find(name);
  if (found == spread.intervals.end()) return "";
  return number_text(found->second[0], 3) + " to " + number_text(found->second[1], 3);
}

// The intervals of the options whose uncertainty was carried through.
std::string uncertainty(const IndexPage& page, const std::vector<RankedRow>& rows) {
  if (page.spread.empty()) return "";
  std::string html = "<h2>Uncertainty</h2>\n<p>In words: " + html_text(page.spread) +
                     ".</p>\n<p class=\"soft small\">From the 5th to the 95th percentile of the "
                     "samples that converged; the same samples for every option.</p>\n"
                     "<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
                     "aria-label=\"Uncertainty\"><table><tr><th>Rank</th><th>Option</th>"
                     "<th>Converged</th><th>First</th><th>Score</th>";
  for (const RankingCriterion& criterion : page.criteria)
    html += "<th>" + html_text(criterion.title) + "</th>";
  html += "</tr>\n";
  for (const RankedRow& one : rows) {
    if (!one.spread) continue;
    const Spread& spread = *one.spread;
    const auto share = [&](int count) {
      return std::to_string(count) + " of " + std::to_string(spread.samples);
    };
    Option option;
    option.values = one.row.values;
    html += "<tr><td>" + std::to_string(one.rank) + "</td><td>" + html_text(option.text()) +
            "</td><td>" + share(spread.converged) + "</td><td>" + share(spread.first) +
            "</td><td>" + range_text(spread, "score") + "</td>";
    for (const RankingCriterion& criterion : page.criteria)
      html += "<td>" + range_text(spread, criterion.name) + "</td>";
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

}  // namespace

std::string index_html(const IndexPage& page, const std::vector<RankedRow>& rows) {
  const std::string title = html_text(page.scene) + ": options";
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<title>" +
                     title +
                     "</title>\n<meta name=\"viewport\" content=\"width=device-width, "
                     "initial-scale=1\">\n<style>\n";
  html += report_css;
  html += index_css;
  html += "</style></head>\n<body><main>\n<header><h1>" + title +
          "</h1>\n<p class=\"soft\">Predicted by vasorod " + version() +
          ". Research software, not for clinical use. The order is not a recommendation: most "
          "thresholds are conventions, and the weights are a choice.</p>\n" +
          summary(page, rows) + "</header>\n";
  html +=
      R"(<noscript><p>Tables and pictures need JavaScript; options.csv beside this page has every
number.</p></noscript>
<h2 id="table-title">Ranking</h2>
<p class="soft small">A heading sorts the table. Tick options to see their pictures side by side.
Green: converged, in the model's range, no warning, every criterion within its threshold. Amber: with
warnings, or a criterion past its threshold. Plain: converged without a warning, but this fidelity
does not see every criterion.</p>
<div id="options-box" role="region" aria-labelledby="table-title" tabindex="0">
<table id="options"></table></div>
<div id="pictures-part"><h2>Side by side</h2>
<div id="picture-controls" class="bar"></div><div id="pictures" class="pictures"></div></div>
<h2>Two criteria</h2>
<div id="scatter-controls" class="bar"></div><div id="scatter"></div>
<div id="chosen" role="status" class="soft small"></div>
)";
  html += uncertainty(page, rows);
  html += R"(<h2>What is counted</h2>
<p class="soft small">Score: the sum of weight times penalty over the sum of the weights. A penalty
is 0 at the ideal value and 1 at the threshold. What a fidelity does not see adds nothing, so scores
of different fidelities are not comparable, and options of a later stage stand before those of an
earlier one.</p>
<div class="scroll" tabindex="0" role="region" aria-label="Criteria">
<table id="criteria"></table></div>
)";
  html += "<footer>Lengths in " + html_text(page.length_unit) +
          ". Every number is in options.csv. Research software, not for clinical use.</footer>\n"
          "</main>\n";
  html += R"(<script type="application/json" id="data">)" + data_of(page, rows) +
          "</script>\n<script>\n";
  html += index_js;
  return html + "</script>\n</body></html>\n";
}

}  // namespace vasorod
