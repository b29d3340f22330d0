#include <algorithm>
#include <cmath>
#include <map>

#include "data/mmhg.h"
#include "data/sentence.h"
#include "report/report_parts.h"

namespace vasorod {

namespace {

// Rows of cells in HTML. The first `text_columns` columns are text, the others numbers.
struct Table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::size_t text_columns = 1;
};

// The region scrolls where it is too wide for the screen, so the keyboard must reach it.
std::string table_html(const std::string& title, const Table& table) {
  std::string html = R"(<div class="scroll" role="region" tabindex="0" aria-label=")" +
                     html_text(title) + "\"><table>\n";
  if (!table.head.empty()) {
    html += "<thead><tr>";
    for (std::size_t i = 0; i < table.head.size(); ++i)
      html += (i < table.text_columns ? "<th>" : "<th class=\"number\">") +
              html_text(table.head[i]) + "</th>";
    html += "</tr></thead>\n";
  }
  html += "<tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool heading = i == 0;
      html += heading ? "<th>" : i < table.text_columns ? "<td>" : "<td class=\"number\">";
      html += row[i] + (heading ? "</th>" : "</td>");
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string html_of(const std::string& title, const Table& table) {
  return table.rows.empty() ? std::string()
                            : "<h2>" + html_text(title) + "</h2>\n" + table_html(title, table);
}

template <class Text>
std::string vector_of(const Vec3& v, Text&& text) {
  const double rounding = 1e-9 * v.norm();
  const auto component = [&](double x) { return text(std::abs(x) < rounding ? 0 : x); };
  return component(v.x()) + ", " + component(v.y()) + ", " + component(v.z());
}

std::string vector_text(const Vec3& v) {
  return vector_of(v, cell_text);
}

// A place, to a ten-thousandth of its coordinates: a scan's may be far from the origin.
std::string place_cell(const Vec3& v) {
  return vector_of(v, [](double x) { return std::isfinite(x) ? number_text(x, 4) : "–"; });
}

// Numbers of a state that is no solution are greyed, under a line that says so.
std::string greyed_unless_solved(const Result& result, const std::string& tables) {
  if (is_solution(result.status) || tables.empty()) return tables;
  return "<div class=\"unsolved\">\n<p>The tables in grey are of a state that is no "
         "solution.</p>\n" +
         tables + "</div>\n";
}

std::string words_of(const Criterion& criterion) {
  static const std::map<std::string, std::string> words{
      {"lumen", "Smallest lumen over rest"},
      {"mouth", "Lumen of the mouth over the cut vein's"},
      {"twist", "Largest twist along a vessel"},
      {"twist_shear", "Largest twist shear"},
      {"stretch", "Stretch furthest from 1"},
      {"contact_pressure", "Largest contact pressure"}};
  const auto found = words.find(criterion.name);
  return found == words.end() ? criterion.name : found->second;
}

std::string value_of(const Criterion& criterion, const Result& result) {
  if (criterion.verdict == Verdict::unknown) return "unknown";
  std::string text = cell_text(criterion.value);
  // Both thresholds stand beside it.
  for (const auto& threshold : {criterion.threshold, criterion.strong_threshold})
    if (threshold && text == cell_text(*threshold))
      text = number_beside(criterion.value, *threshold, 3);
  if (!criterion.unit.empty()) text += " " + criterion.unit;
  if (criterion.unit == "mmHg")
    text += " (" + cell_text(criterion.value / mmhg_per(result.stress_unit)) + " " +
            result.stress_unit + ")";
  return text;
}

// Which side of a threshold warns follows from the two thresholds' order.
std::string threshold_of(const Criterion& criterion) {
  if (!criterion.threshold) return "–";
  const bool rising =
      !criterion.strong_threshold || *criterion.strong_threshold > *criterion.threshold;
  const std::string side = rising ? "from " : "below ";
  std::string text = side + cell_text(*criterion.threshold);
  if (criterion.strong_threshold)
    text += ", strong " + side + cell_text(*criterion.strong_threshold);
  return criterion.unit.empty() ? text : text + " " + criterion.unit;
}

std::string verdict_badge(Verdict verdict) {
  switch (verdict) {
    case Verdict::fine:
      return "<span class=\"badge good\">fine</span>";
    case Verdict::warning:
      return "<span class=\"badge warn\">warning</span>";
    case Verdict::strong_warning:
      return "<span class=\"badge bad\">strong warning</span>";
    case Verdict::not_judged:
      return "not judged";
    case Verdict::unknown:
      return "unknown";
  }
  return {};
}

std::string radii_of(const FittedLength& part) {
  return cell_text(part.smallest_radius) + " to " + cell_text(part.largest_radius) + ", mean " +
         cell_text(part.mean_radius);
}

std::string fit_tables(const Result& result) {
  if (!result.fit) return {};
  const std::string& unit = result.length_unit;
  Table ends;
  ends.head = {"End in a scene", "ModelFaceID", "Centre, " + unit, "Normal", "Radius, " + unit};
  ends.text_columns = 4;
  for (const FittedEnd& end : result.fit->ends)
    ends.rows.push_back({html_text(end.end), end.name.empty() ? "–" : html_text(end.name),
                         place_cell(end.center), vector_text(end.normal), cell_text(end.radius)});
  Table branches;
  branches.head = {"Branch", "Radius, " + unit, "Length, " + unit};
  branches.text_columns = 2;
  for (const FittedLength& branch : result.fit->branches)
    branches.rows.push_back(
        {std::to_string(branches.rows.size() + 1), radii_of(branch), cell_text(branch.length)});
  return html_of("Open ends", ends) + html_of("Branches between forks and ends", branches);
}

std::string metrics_table(const Result& result) {
  Table table;
  table.head = {"Vessel",
                "Largest twist shear",
                "Stretch from",
                "to",
                "Largest curvature, 1/" + result.length_unit,
                "Flattening",
                "Smallest lumen over rest",
                "Largest pressure, " + result.stress_unit,
                "mmHg",
                "Contact area, " + result.length_unit + "²"};
  // Without surfaces there is no section.
  const auto of_surface = [&](double value) {
    return result.fidelity == "rod" ? std::string("–") : cell_text(value);
  };
  const auto of_contact = [](const std::optional<double>& value, double scale = 1) {
    return value ? cell_text(scale * *value) : std::string("–");
  };
  for (const VesselMetrics& m : result.metrics)
    table.rows.push_back(
        {html_text(m.vessel), cell_text(m.largest_twist_shear), cell_text(m.stretch[0]),
         cell_text(m.stretch[1]), cell_text(m.largest_curvature), of_surface(m.flattening),
         of_surface(m.smallest_lumen_ratio), of_contact(m.largest_pressure),
         of_contact(m.largest_pressure, mmhg_per(result.stress_unit)), of_contact(m.contact_area)});
  Table where;
  where.head = {"Vessel", "Extreme", "At, " + result.length_unit};
  where.text_columns = 3;
  for (const VesselMetrics& m : result.metrics)
    for (const auto& [name, point] : m.where) {
      std::string words = name;
      std::replace(words.begin(), words.end(), '_', ' ');
      where.rows.push_back({html_text(m.vessel), html_text(words), place_cell(point)});
    }
  std::string html = html_of("What became of the vessels", table);
  if (!where.rows.empty())
    html += "<details><summary>Where each extreme occurs</summary>\n" +
            table_html("Where each extreme occurs", where) + "</details>\n";
  return html;
}

// The rows of an operation's table.
class OperationRows {
 public:
  explicit OperationRows(const Result& result) : result_(result) { table.text_columns = 2; }

  void add(const std::string& what, const std::string& value, const std::string& unit) {
    table.rows.push_back({html_text(what), html_text(value + (unit.empty() ? "" : " " + unit))});
  }
  // A value that belongs to the solution.
  void add_solved(const std::string& what, double value, const std::string& unit) {
    if (is_solution(result_.status))
      add(what, cell_text(value), unit);
    else
      add(what, "unknown", "");
  }
  // `what`: Cut, or Rim where it may be an end of a whole vessel.
  void add_cut(const std::string& what, const std::string& vessel, const CutReport& cut) {
    const std::string& length = result_.length_unit;
    add(what + " of " + vessel + ", part of its length", cell_text(cut.fraction), "");
    if (cut.tilt_deg != 0) add(what + ", tilt", cell_text(cut.tilt_deg), "degrees");
    add(what + ", perimeter", cell_text(cut.perimeter), length);
    add(what + ", plane through", place_cell(cut.point), length);
    add(what + ", normal", vector_text(cut.normal), "");
  }
  void add_seam(const SeamReport& seam) {
    add("Seam, pairs of points", std::to_string(seam.pairs), "");
    add("Seam, rotation", cell_text(seam.rotation_deg), "degrees");
    add("Seam, turn of the mouth's axis", cell_text(seam.axis_turn_deg), "degrees");
  }
  void add_solution(const SeamReport& seam, const MouthReport* mouth, const std::string& over) {
    const std::string& length = result_.length_unit;
    add_solved("Seam, largest gap", seam.largest_gap, length);
    add_solved("Seam, root mean square gap", seam.rms_gap, length);
    if (mouth == nullptr) return;
    add_solved("Mouth, lumen", mouth->lumen, length + "²");
    add_solved("Mouth, lumen over " + over, mouth->area_ratio, "");
    add_solved("Mouth, span", mouth->span, length);
    add_solved("Mouth, width", mouth->width, length);
    add_solved("Mouth, perimeter over " + over, mouth->perimeter_ratio, "");
  }

  Table table;

 private:
  const Result& result_;
};

std::string glenn_table(const Result& result, const JoinedVessels& joined) {
  const GlennReport& g = *result.glenn;
  const std::string& length = result.length_unit;
  OperationRows rows(result);
  rows.add_cut("Cut", g.svc, g.cut);
  rows.add("Incision of " + g.rpa + ", picked at", place_cell(g.incision.pick), length);
  rows.add("Incision of " + g.rpa + ", length", cell_text(g.incision.length), length);
  if (g.incision.shape != "slit") {
    rows.add("Incision, width of the " + g.incision.shape, cell_text(g.incision.width), length);
    rows.add("Incision, wall taken out", cell_text(g.incision.removed_area), length + "²");
  }
  rows.add("Incision, perimeter over the cut's", cell_text(g.incision.perimeter_ratio), "");
  rows.add("Incision, ends",
           place_cell(g.incision.ends[0]) + " and " + place_cell(g.incision.ends[1]), length);
  rows.add_seam(g.join);
  rows.add_solved("Incision, opened area", g.incision.opened_area, length + "²");
  rows.add_solution(g.join, joined.mouth, "the cut vein's");
  return html_of("The operation", rows.table);
}

std::string end_to_end_table(const Result& result, const JoinedVessels& joined) {
  OperationRows rows(result);
  for (const RimReport& rim : result.end_to_end->rims) rows.add_cut("Rim", rim.vessel, rim.cut);
  rows.add_seam(*joined.seam);
  rows.add_solution(*joined.seam, joined.mouth, "that of " + joined.mouth_of);
  return html_of("The operation", rows.table);
}

std::string operation_table(const Result& result) {
  const auto joined = joined_vessels(result);
  if (!joined) return {};
  return result.glenn ? glenn_table(result, *joined) : end_to_end_table(result, *joined);
}

std::string force_tables(const Result& result) {
  const std::string force = force_unit(result);
  Table ends;
  ends.head = {"Vessel", "End", "Force, " + force, "Moment, " + force + " " + result.length_unit,
               "About, " + result.length_unit};
  ends.text_columns = 2;
  for (const EndReaction& e : result.ends)
    ends.rows.push_back({html_text(e.vessel), html_text(e.end), vector_text(e.force),
                         vector_text(e.moment), place_cell(e.center)});
  Table contact;
  contact.head = {"Vessel",
                  "touches",
                  "Force on the first, " + force,
                  "Area, " + result.length_unit + "²",
                  "Largest pressure, " + result.stress_unit,
                  "mmHg",
                  "Smallest gap, " + result.length_unit};
  contact.text_columns = 2;
  for (const ContactReport& c : result.contact)
    contact.rows.push_back({html_text(c.a), html_text(c.b), vector_text(c.force), cell_text(c.area),
                            cell_text(c.largest_pressure),
                            cell_text(c.largest_pressure * mmhg_per(result.stress_unit)),
                            cell_text(c.smallest_gap)});
  Table crossing;
  crossing.head = {"Vessel", "passes through", "Pairs of triangles", "Depth, " + result.length_unit,
                   "Deepest at, " + result.length_unit};
  crossing.text_columns = 2;
  for (const SelfIntersection& s : result.self_intersections)
    crossing.rows.push_back({html_text(s.a), s.b == s.a ? "itself" : html_text(s.b),
                             std::to_string(s.pairs), cell_text(s.depth), place_cell(s.where)});
  Table balance;
  balance.head = {"Vessel",
                  "Supports",
                  "Loads",
                  "Seam",
                  "Contact",
                  "Pressure in the lumen",
                  "Rod through binding",
                  "Left on the rod",
                  "Residual over largest"};
  for (const Balance& b : result.balance)
    balance.rows.push_back(
        {html_text(b.vessel), vector_text(b.support), vector_text(b.load), vector_text(b.join),
         vector_text(b.contact), b.pressure ? vector_text(*b.pressure) : "–",
         b.binding ? vector_text(*b.binding) : "–",
         b.rod_unbalanced ? vector_text(*b.rod_unbalanced) : "–", cell_text(b.residual)});
  return html_of("What the supports do", ends) + html_of("Contact", contact) +
         html_of("Walls inside each other", crossing) +
         html_of("Balance of forces, " + force, balance);
}

std::string energy_table(const Result& result) {
  const Energies& e = result.energy;
  Table table;
  table.head = {"Energy, " + force_unit(result) + " " + result.length_unit, ""};
  const std::pair<const char*, double> rows[] = {
      {"rod", e.rod},         {"binding", e.binding},
      {"bending", e.bending}, {"stretching", e.stretching},
      {"joining", e.joining}, {"contact", e.contact},
      {"total", e.total()}};
  for (const auto& [name, value] : rows) table.rows.push_back({name, cell_text(value)});
  if (e.strain != 0)
    table.rows.insert(table.rows.begin(), {"strain of the wall", cell_text(e.strain)});
  return html_of("Energy", table);
}

std::string time_table(const Result& result) {
  Table table;
  table.head = {"Stage", "Seconds"};
  const std::vector<std::string> order{"read", "fit", "solve", "factor", "write"};
  // `fit` solves nothing: its zeros are no times.
  const auto shown = [&](double value) { return !result.fit || value > 0; };
  const auto add = [&](const std::string& name) {
    if (const auto found = result.seconds.find(name);
        found != result.seconds.end() && shown(found->second))
      table.rows.push_back({name == "factor" ? "of solve: factorisations" : html_text(name),
                            cell_text(found->second)});
  };
  for (const std::string& name : order) add(name);
  for (const auto& [name, seconds] : result.seconds)
    if (name != "total" && std::find(order.begin(), order.end(), name) == order.end()) add(name);
  add("total");
  for (const auto& [name, count] : result.iterations)
    if (shown(count))
      table.rows.push_back({"iterations of the " + html_text(name), std::to_string(count)});
  return html_of("Time", table);
}

std::string model_tables(const Result& result) {
  Table model;
  model.text_columns = 2;
  std::string terms;
  for (const std::string& term : result.model.terms) terms += (terms.empty() ? "" : ", ") + term;
  model.rows = {{"Fidelity", html_text(result.fidelity)},
                {"Rod nodes", std::to_string(result.model.rod_nodes)},
                {"Surface vertices", std::to_string(result.model.vertices)},
                {"Surface triangles", std::to_string(result.model.triangles)}};
  if (!terms.empty()) model.rows.push_back({"Terms", html_text(terms)});
  for (const auto& [what, reason] : result.model.left_out)
    model.rows.push_back({"Left out: " + html_text(what), html_text(reason)});
  for (const auto& [vessel, what] : result.model.cleaning)
    model.rows.push_back({"Read: " + html_text(vessel), html_text(what)});
  for (const std::string& note : result.certificate.notes)
    model.rows.push_back({"Note", html_text(note)});
  if (result.discretisation) {
    model.rows.push_back({"Unknowns", std::to_string(result.discretisation->dofs)});
    model.rows.push_back({"Degree", std::to_string(result.discretisation->degree)});
  }
  Table environment;
  environment.text_columns = 2;
  environment.rows = {{"Program", html_text(result.program)},
                      {"BLAS", html_text(result.environment.blas)},
                      {"Threads", std::to_string(result.environment.threads)}};
  for (const auto& [file, sum] : result.environment.inputs)
    environment.rows.push_back({html_text(file), "<code>" + html_text(sum) + "</code>"});
  return html_of("What was modelled", model) + html_of("Environment", environment);
}

}  // namespace

std::string html_text(const std::string& text) {
  std::string html;
  for (const char c : text) {
    if (c == '&')
      html += "&amp;";
    else if (c == '<')
      html += "&lt;";
    else if (c == '>')
      html += "&gt;";
    else if (c == '"')
      html += "&quot;";
    else
      html += c;
  }
  return html;
}

std::string cell_text(double value) {
  if (!std::isfinite(value)) return "–";
  if (std::abs(value) >= 1000 && std::abs(value) < 1e6) return fixed_text(value, 0);
  return number_text(value == 0 ? 0.0 : value, 3);  // no -0
}

std::string force_unit(const Result& result) {
  const std::string &length = result.length_unit, &stress = result.stress_unit;
  if ((length == "mm" && stress == "MPa") || (length == "m" && stress == "Pa")) return "N";
  if (length == "mm" && stress == "kPa") return "mN";
  if (length == "m" && stress == "kPa") return "kN";
  if (length == "m" && stress == "MPa") return "MN";
  return stress + " " + length + "²";
}

std::string criteria_table(const Result& result) {
  Table table;
  table.head = {"Criterion", "Vessel", "Value", "A warning", "Verdict", "Where this comes from"};
  table.text_columns = 6;
  for (const Criterion& criterion : result.criteria)
    table.rows.push_back({html_text(words_of(criterion)), html_text(criterion.vessel),
                          html_text(value_of(criterion, result)), threshold_of(criterion),
                          verdict_badge(criterion.verdict), html_text(criterion.source)});
  return html_of("Criteria", table);
}

std::string report_tables(const Result& result) {
  if (result.fit) return fit_tables(result) + time_table(result) + model_tables(result);
  return greyed_unless_solved(result, metrics_table(result)) + operation_table(result) +
         greyed_unless_solved(result, force_tables(result)) + "<div class=\"pair\"><div>" +
         greyed_unless_solved(result, energy_table(result)) + "</div><div>" + time_table(result) +
         "</div></div>\n" + model_tables(result);
}

}  // namespace vasorod
