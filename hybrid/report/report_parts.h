// The parts of report.html.
#pragma once

#include <string>

#include <vasorod/result.h>

namespace vasorod {

/// Text with the reserved characters of HTML replaced.
std::string html_text(const std::string& text);

/// Three significant digits, all before the point up to a million; a dash if the value is not
/// finite. result.json has every digit.
std::string cell_text(double value);

/// "N" if the scene's units give newtons (also mN, kN, MN), else as "MPa cm²".
std::string force_unit(const Result& result);

/// The criteria with their thresholds, coloured verdicts and sources; nothing where there are none.
std::string criteria_table(const Result& result);

/// Every table of the report under its heading. Empty tables are left out.
std::string report_tables(const Result& result);

/// The scene of the interactive view, as JSON that is safe inside a script element.
std::string view_scene(const Result& result);

}  // namespace vasorod
