#include <algorithm>
#include <cmath>

#include "data/sentence.h"
#include "report/report_parts.h"

namespace vasorod {

namespace {

// Rows of cells that are HTML already; the first `text_columns` are text, the rest numbers.
struct Table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::size_t text_columns = 1;
};

std::string table_html(const Table& table) {
  std::string html = "<div class=\"scroll\"><table>\n";
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
                            : "<h2>" + html_text(title) + "</h2>\n" + table_html(table);
}

std::string vector_text(const Vec3& v) {
  return cell_text(v.x()) + ", " + cell_text(v.y()) + ", " + cell_text(v.z());
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
                "Contact area, " + result.length_unit + "²"};
  for (const VesselMetrics& m : result.metrics)
    table.rows.push_back({html_text(m.vessel), cell_text(m.largest_twist_shear),
                          cell_text(m.stretch[0]), cell_text(m.stretch[1]),
                          cell_text(m.largest_curvature), cell_text(m.flattening),
                          cell_text(m.smallest_lumen_ratio), cell_text(m.largest_pressure),
                          cell_text(m.contact_area)});
  Table where;
  where.head = {"Vessel", "Extreme", "At, " + result.length_unit};
  where.text_columns = 3;
  for (const VesselMetrics& m : result.metrics)
    for (const auto& [name, point] : m.where) {
      std::string words = name;
      std::replace(words.begin(), words.end(), '_', ' ');
      where.rows.push_back({html_text(m.vessel), html_text(words), vector_text(point)});
    }
  std::string html = html_of("What became of the vessels", table);
  if (!where.rows.empty())
    html += "<details><summary>Where each extreme occurs</summary>\n" + table_html(where) +
            "</details>\n";
  return html;
}

std::string glenn_table(const Result& result) {
  if (!result.glenn) return {};
  const GlennReport& g = *result.glenn;
  const std::string& length = result.length_unit;
  Table table;
  table.text_columns = 2;
  const auto add = [&](const std::string& what, const std::string& value, const std::string& unit) {
    table.rows.push_back({html_text(what), html_text(value + (unit.empty() ? "" : " " + unit))});
  };
  add("Cut of " + g.svc + ", part of its length", cell_text(g.cut.fraction), "");
  add("Cut, perimeter", cell_text(g.cut.perimeter), length);
  add("Cut, plane through", vector_text(g.cut.point), length);
  add("Cut, normal", vector_text(g.cut.normal), "");
  add("Incision of " + g.rpa + ", length", cell_text(g.incision.length), length);
  add("Incision, ends", vector_text(g.incision.ends[0]) + " and " + vector_text(g.incision.ends[1]),
      length);
  add("Incision, opened area", cell_text(g.incision.opened_area), length + "²");
  add("Seam, pairs of points", std::to_string(g.join.pairs), "");
  add("Seam, rotation", cell_text(g.join.rotation_deg), "degrees");
  add("Seam, largest gap", cell_text(g.join.largest_gap), length);
  add("Seam, root mean square gap", cell_text(g.join.rms_gap), length);
  return html_of("The operation", table);
}

std::string force_tables(const Result& result) {
  const std::string force = force_unit(result);
  Table ends;
  ends.head = {"Vessel", "End", "Force, " + force, "Moment, " + force + " " + result.length_unit,
               "About, " + result.length_unit};
  ends.text_columns = 2;
  for (const EndReaction& e : result.ends)
    ends.rows.push_back({html_text(e.vessel), html_text(e.end), vector_text(e.force),
                         vector_text(e.moment), vector_text(e.center)});
  Table contact;
  contact.head = {"Vessel",
                  "touches",
                  "Force on the first, " + force,
                  "Area, " + result.length_unit + "²",
                  "Largest pressure, " + result.stress_unit,
                  "Smallest gap, " + result.length_unit};
  contact.text_columns = 2;
  for (const ContactReport& c : result.contact)
    contact.rows.push_back({html_text(c.a), html_text(c.b), vector_text(c.force), cell_text(c.area),
                            cell_text(c.largest_pressure), cell_text(c.smallest_gap)});
  Table balance;
  balance.head = {"Vessel",          "Supports",
                  "Loads",           "Seam",
                  "Contact",         "Rod through binding",
                  "Left on the rod", "Residual over largest"};
  for (const Balance& b : result.balance)
    balance.rows.push_back(
        {html_text(b.vessel), vector_text(b.support), vector_text(b.load), vector_text(b.join),
         vector_text(b.contact), b.binding ? vector_text(*b.binding) : "–",
         b.rod_unbalanced ? vector_text(*b.rod_unbalanced) : "–", cell_text(b.residual)});
  return html_of("What the supports do", ends) + html_of("Contact", contact) +
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
  const std::vector<std::string> order{"read", "fit", "factor", "solve", "write"};
  const auto add = [&](const std::string& name) {
    if (const auto found = result.seconds.find(name); found != result.seconds.end())
      table.rows.push_back({html_text(name), cell_text(found->second)});
  };
  for (const std::string& name : order) add(name);
  for (const auto& [name, seconds] : result.seconds)
    if (name != "total" && std::find(order.begin(), order.end(), name) == order.end()) add(name);
  add("total");
  for (const auto& [name, count] : result.iterations)
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
                {"Surface triangles", std::to_string(result.model.triangles)},
                {"Terms", html_text(terms)}};
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
  return number_text(value == 0 ? 0.0 : value, 4);  // no -0
}

std::string force_unit(const Result& result) {
  const std::string &length = result.length_unit, &stress = result.stress_unit;
  if ((length == "mm" && stress == "MPa") || (length == "m" && stress == "Pa")) return "N";
  if (length == "mm" && stress == "kPa") return "mN";
  if (length == "m" && stress == "kPa") return "kN";
  if (length == "m" && stress == "MPa") return "MN";
  return stress + " " + length + "²";
}

std::string report_tables(const Result& result) {
  return metrics_table(result) + glenn_table(result) + force_tables(result) +
         "<div class=\"pair\"><div>" + energy_table(result) + "</div><div>" + time_table(result) +
         "</div></div>\n" + model_tables(result);
}

}  // namespace vasorod
