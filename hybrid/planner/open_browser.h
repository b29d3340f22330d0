// Shows an address in the user's browser.
#pragma once

#include <string>

namespace vasorod::planner {

/// Starts xdg-open with the address and does not wait for it; does nothing where there is none.
void open_browser(const std::string& url);

}  // namespace vasorod::planner
