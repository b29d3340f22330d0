#include "report/report.h"

#include <algorithm>

#include "data/mmhg.h"
#include "report/base64.h"
#include "report/page_assets.h"
#include "report/report_parts.h"
#include "result/unknown_validity.h"

namespace vasorod {

namespace {

std::string status_sentence(Status status) {
  switch (status) {
    case Status::converged:
      return "converged";
    case Status::equilibrium_only:
      return "in equilibrium, minimum not certified";
    case Status::unstable:
      return "unstable: an equilibrium that does not last";
    case Status::buckled:
      return "buckled";
    case Status::not_unique:
      return "the minimum is not unique";
    case Status::self_intersecting:
      return "walls pass through themselves or each other";
    case Status::iteration_limit:
      return "stopped at the iteration limit";
    case Status::interrupted:
      return "interrupted: the best state so far";
  }
  return to_string(status);
}

std::string badge(const std::string& kind, const std::string& text) {
  return "<span class=\"badge " + kind + "\">" + html_text(text) + "</span>\n";
}

// An unfinished solve says how far it was from an equilibrium.
std::string headline(const Result& result) {
  std::string text = "Status: " + status_sentence(result.status);
  if (is_unfinished(result.status))
    text += ", relative residual " + cell_text(result.certificate.relative_residual);
  return text;
}

std::string badges(const Result& result) {
  std::string html = "<div class=\"badges\">\n";
  if (result.fit) return html + badge("plain", "fitted at rest, nothing solved") + "</div>\n";
  html += badge(result.status == Status::converged          ? "good"
                : result.status == Status::equilibrium_only ? "warn"
                                                            : "bad",
                headline(result));
  const std::optional<bool> in_range = known_range(result);
  html += !in_range   ? badge("warn", "Validity: unknown")
          : *in_range ? badge("good", "Validity: within the model's range")
                      : badge("bad", "Validity: outside the model's range");
  html += badge("plain", "fidelity " + result.fidelity);
  return html + "</div>\n";
}

std::string validity_notice(const Result& result) {
  const Validity& validity = result.validity;
  std::vector<std::string> warnings = validity.warnings;
  if (!is_solution(result.status)) warnings.insert(warnings.begin(), why_unknown(result.status));
  const bool fine = result.fit || known_range(result).value_or(false);
  std::string html;
  if (!warnings.empty()) {
    html += std::string("<div class=\"notice ") + (fine ? "warn" : "bad") + "\"><strong>" +
            (fine ? "Check before you rely on it" : "Do not rely on this result as it stands") +
            "</strong><ul>\n";
    for (const std::string& warning : warnings) html += "<li>" + html_text(warning) + "</li>\n";
    html += "</ul></div>\n";
  }
  if (!known_range(result)) return html;  // the ratios would be taken for those of a solution
  return html + "<p class=\"soft small\">Brazier ratio " + cell_text(validity.brazier_ratio) +
         ", wrinkling ratio " + cell_text(validity.wrinkling_ratio) + ", twist ratio " +
         cell_text(validity.twist_ratio) + ", largest strain " +
         cell_text(validity.largest_strain) + ".</p>\n";
}

std::string fact(const std::string& name, const std::string& value, const std::string& unit) {
  return "<div><dt>" + html_text(name) + "</dt><dd>" + html_text(value) +
         (unit.empty() ? "" : " <small>" + html_text(unit) + "</small>") + "</dd></div>\n";
}

std::string fit_facts(const FitReport& fit, const std::string& unit) {
  return fact("Length", cell_text(fit.whole.length), unit) +
         fact("Smallest radius", cell_text(fit.whole.smallest_radius), unit) +
         fact("Mean radius", cell_text(fit.whole.mean_radius), unit) +
         fact("Largest radius", cell_text(fit.whole.largest_radius), unit) +
         fact("Branches", std::to_string(fit.branches.size()), "") +
         fact("Open ends", std::to_string(fit.ends.size()), "");
}

std::string facts(const Result& result) {
  const bool solved = is_solution(result.status);
  const auto peak = [&](double value) { return solved ? cell_text(value) : "unknown"; };
  const auto unit = [&](const std::string& name) { return solved ? name : std::string(); };
  double twist = 0, lumen = 1;
  std::optional<double> pressure;
  for (const VesselMetrics& m : result.metrics) {
    twist = std::max(twist, m.largest_twist_shear);
    lumen = std::min(lumen, m.smallest_lumen_ratio);
    pressure = std::max(pressure, m.largest_pressure);  // none is less than any
  }
  for (const ContactReport& c : result.contact)
    pressure = std::max(pressure, std::optional(c.largest_pressure));
  std::string html = "<dl class=\"facts\">\n";
  if (result.fit) html += fit_facts(*result.fit, result.length_unit);
  if (!result.metrics.empty()) {
    html += fact("Largest twist shear", peak(twist), "");
    if (result.fidelity != "rod") {  // without surfaces there is no lumen and no contact
      html += fact("Smallest lumen over rest", peak(lumen), "");
      if (!pressure)
        html += fact("Largest contact pressure", "not modelled", "");
      else
        html += fact("Largest contact pressure", peak(*pressure * mmhg_per(result.stress_unit)),
                     unit("mmHg (" + cell_text(*pressure) + " " + result.stress_unit + ")"));
    }
  }
  if (const auto joined = joined_vessels(result))
    html +=
        fact("Largest gap in the seam", peak(joined->seam->largest_gap), unit(result.length_unit));
  if (const auto total = result.seconds.find("total"); total != result.seconds.end())
    html += fact("Computed in", cell_text(total->second), "s");
  return html + "</dl>\n";
}

std::string figures(const std::vector<NamedPicture>& pictures, bool fields) {
  std::string html = std::string("<div class=\"pictures") + (fields ? " fields" : "") + "\">\n";
  for (const NamedPicture& picture : pictures)
    if (picture.field == fields)
      html += "<figure><img width=\"" + std::to_string(picture.width) + "\" height=\"" +
              std::to_string(picture.height) + "\" alt=\"" + html_text(picture.title) +
              "\" src=\"data:image/png;base64," + base64(picture.png) + "\"><figcaption>" +
              html_text(picture.title) + "</figcaption></figure>\n";
  return html + "</div>\n";
}

// What the colours of the pictures mean.
std::string ranges_note(const Result& result) {
  if (drawn_fields(result).empty() || !is_solution(result.status)) return {};
  return "<p class=\"soft small\">The colours of twist and stretch reach at least 0.2 from the "
         "value at rest, the strain up to which the laws of the wall agree; those of contact at "
         "least 10 mmHg, about the pressure in the veins after a Glenn operation. Larger values "
         "widen them. Below each legend stand the extremes of this result. Scale bars hold at the "
         "depth of the picture's middle.</p>\n";
}

}  // namespace

std::string report_html(const Result& result, const std::vector<NamedPicture>& pictures) {
  const std::string title = html_text(result.scene);
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<title>" +
                     title +
                     "</title>\n<meta name=\"viewport\" content=\"width=device-width, "
                     "initial-scale=1\">\n<style>\n";
  html += report_css;
  html += "</style></head>\n<body><main>\n<header><h1>" + title +
          "</h1>\n<p class=\"soft\">Predicted by " + html_text(result.program) +
          ". Research software, not for clinical use.</p>\n";
  html += badges(result) + validity_notice(result) + facts(result) + "</header>\n";
  html += criteria_table(result);
  html += "<h2 id=\"view-title\">";
  html += result.fit                   ? "The vessel and its axis"
          : is_solution(result.status) ? "The result"
                                       : "The state in which the solve ended";
  html +=
      "</h2>\n<div id=\"view\"><div id=\"stage\"><canvas "
      "tabindex=\"0\" "
      "aria-label=\"The "
      "vessels in three dimensions\"></canvas><div id=\"legend\"></div></div><div "
      "id=\"controls\"></div></div>\n"
      "<p class=\"soft small\" id=\"view-help\">Drag to turn, wheel or pinch to zoom, shift-drag "
      "or two "
      "fingers to "
      "move, double click to start again.</p>\n";
  if (result.fit) {
    html += figures(pictures, false);
  } else {
    html += "<h2>Stages</h2>\n" + figures(pictures, false);
    if (std::any_of(pictures.begin(), pictures.end(), [](const auto& one) { return one.field; }))
      html +=
          "<h2>Twist, stretch and contact</h2>\n" + figures(pictures, true) + ranges_note(result);
  }
  html += report_tables(result);
  html += "<footer>Lengths in " + html_text(result.length_unit);
  if (!result.fit)
    html += ", stresses in " + html_text(result.stress_unit) +
            ". Twist shear is (u3 − u3 at rest) times the distance to the axis; the lumen is the "
            "mid-wall section moved in by half the wall";
  html +=
      ". Every number is in result.json. Research software, not for clinical "
      "use.</footer>\n</main>\n";
  html += R"(<script type="application/json" id="scene">)" + view_scene(result) +
          "</script>\n<script>\n";
  html += view_js;
  return html + "</script>\n</body></html>\n";
}

}  // namespace vasorod
