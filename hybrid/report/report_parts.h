// The parts of report.html.
#pragma once

#include <string>

#include <vasorod/result.h>

namespace vasorod {

/// Text with the characters HTML reserves replaced.
std::string html_text(const std::string& text);

/// Four significant digits; a dash for what is not finite.
std::string cell_text(double value);

/// "N" where the scene's units make newtons (mN, kN, MN likewise), else "MPa cm²".
std::string force_unit(const Result& result);

/// Every table of the report, each under its heading; what a result has nothing of is left out.
std::string report_tables(const Result& result);

/// The scene of the interactive view as JSON that may stand inside a script element.
std::string view_scene(const Result& result);

}  // namespace vasorod
