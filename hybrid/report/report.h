// report.html: one file, no network. Status, validity and criteria first, then the view, the
// pictures and the tables.
#pragma once

#include <string>
#include <vector>

#include <vasorod/result.h>

#include "report/report_pictures.h"

namespace vasorod {

std::string report_html(const Result& result, const std::vector<NamedPicture>& pictures);

}  // namespace vasorod
