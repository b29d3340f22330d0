#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "explore/index_page.h"

namespace vasorod::testing {
namespace {

RankedRow one_row() {
  RankedRow one;
  one.row.option = "0123456789abcdef";
  one.row.values = {{"cut_along", "0.5"}};
  one.row.fidelity = "skin";
  one.row.ending = Ending::solved;
  one.row.status = Status::converged;
  one.row.criteria = {{"twist_shear", 0.25}};
  one.row.sentences = {"</script><b>not markup</b>"};
  one.rank = 1;
  one.score = 0.5;
  return one;
}

// What the page's script reads.
nlohmann::json data_of(const std::string& html) {
  const std::string start = "<script type=\"application/json\" id=\"data\">";
  const auto begin = html.find(start) + start.size();
  return nlohmann::json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

TEST(IndexPage, CarriesItsDataAndNothingOfTheNetwork) {
  IndexPage page;
  page.scene = "a <scene> & its name";
  page.keys = {"cut_along"};
  page.criteria = ranking_criteria();
  page.colours = {{"vessel", "Vessels"}};
  page.pictures = {{"0123456789abcdef", R"({"vessel": "iVBORw0KGgo="})"}};
  const std::string html = index_html(page, {one_row()});
  EXPECT_NE(html.find("a &lt;scene&gt; &amp; its name"), std::string::npos);
  EXPECT_EQ(html.find("<b>not markup"), std::string::npos);
  for (const char* foreign : {"http:", "https:", "src=\"//", "@import", "<link"}) {
    // The one address is the name of SVG's elements, which is not fetched.
    std::string rest = html;
    const std::string svg = "http://www.w3.org/2000/svg";
    for (auto at = rest.find(svg); at != std::string::npos; at = rest.find(svg))
      rest.erase(at, svg.size());
    EXPECT_EQ(rest.find(foreign), std::string::npos) << foreign;
  }
  const auto data = data_of(html);
  EXPECT_EQ(data["rows"][0]["values"]["cut_along"], "0.5");
  EXPECT_EQ(data["rows"][0]["criteria"]["twist_shear"], 0.25);
  EXPECT_EQ(data["rows"][0]["sentences"][0], "</script><b>not markup</b>");
  EXPECT_EQ(data["pictures"]["0123456789abcdef"]["vessel"], "iVBORw0KGgo=");
  EXPECT_EQ(data["criteria"].size(), ranking_criteria().size());
}

TEST(IndexPage, SaysThatItWasStopped) {
  IndexPage page;
  EXPECT_EQ(index_html(page, {}).find("was stopped before its end"), std::string::npos);
  page.finished = false;
  EXPECT_NE(index_html(page, {}).find("was stopped before its end"), std::string::npos);
}

}  // namespace
}  // namespace vasorod::testing
