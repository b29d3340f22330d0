// Why a surface solve ended without an equilibrium: which of its criteria were not met.
#pragma once

#include <string>

namespace vasorod {

class UnmetCriteria {
 public:
  /// Listed unless `value` is at most `tolerance`.
  void require(const std::string& what, double value, double tolerance);
  void add(const std::string& what) { list_ += (list_.empty() ? "" : "; ") + what; }

  /// "ended WHEN without an equilibrium: residual 0.01, expected at most 1e-09; ...".
  std::string sentence(const std::string& when) const;

 private:
  std::string list_;
};

}  // namespace vasorod
