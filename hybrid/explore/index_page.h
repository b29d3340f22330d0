// index.html of an exploration: the ranking as a table, the scatter of two criteria, pictures side
// by side. One file that needs no network.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "explore/ranking.h"

namespace vasorod {

struct IndexPage {
  std::string scene, length_unit;
  std::map<std::string, std::string> links;  ///< to pages of kept results, by Row::option
  std::string spread;                        ///< RankingSpread::text(); empty: none
  bool finished = true;                      ///< false: the exploration was stopped
  std::vector<std::string> keys;             ///< option_keys()
  std::vector<RankingCriterion> criteria;    ///< criteria_for()
  std::vector<std::pair<std::string, std::string>> colours;  ///< of the pictures, with titles
  std::map<std::string, std::string> pictures;               ///< option_pictures() by Row::option
};

std::string index_html(const IndexPage& page, const std::vector<RankedRow>& rows);

}  // namespace vasorod
