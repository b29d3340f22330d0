#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "report/base64.h"
#include "report/report.h"
#include "report/report_parts.h"
#include "result/example_result.h"

namespace vasorod {
namespace {

std::string page_of(const Result& result) {
  return report_html(result, {});
}

bool has(const std::string& page, const std::string& text) {
  return page.find(text) != std::string::npos;
}

// Decodes by the definition: six bits per character.
std::string decoded(const std::string& text) {
  static const std::string digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 255U);
    }
  }
  return bytes;
}

nlohmann::json scene_of(const std::string& page) {
  const std::string opening = R"(<script type="application/json" id="scene">)";
  const std::size_t begin = page.find(opening) + opening.size();
  return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(Report, NeedsNoNetwork) {
  const std::string page =
      report_html(test::example_result(), report_pictures(test::example_result()));
  EXPECT_FALSE(has(page, "http:"));
  EXPECT_FALSE(has(page, "https:"));
  EXPECT_FALSE(has(page, "@import"));
  EXPECT_FALSE(has(page, "<link"));
  EXPECT_FALSE(std::regex_search(page, std::regex("src=\"(?!data:)")));
}

TEST(Report, SaysStatusValidityAndWhatItIsNot) {
  Result result = test::example_result();
  std::string page = page_of(result);
  EXPECT_TRUE(has(page, "not for clinical use"));
  EXPECT_TRUE(has(page, "Status: converged"));
  EXPECT_TRUE(has(page, "outside the model's range"));
  EXPECT_TRUE(has(page, "svc bends to 0.95 of the curvature where a tube kinks."));
  result.status = Status::buckled;
  result.validity = {};
  page = page_of(result);
  EXPECT_TRUE(has(page, "Status: buckled"));
  EXPECT_TRUE(has(page, "within the model's range"));
  EXPECT_FALSE(has(page, "class=\"notice"));
}

// Peaks of the example: twist shear 0.05, lumen 0.9, pressure 1e-3 MPa, seam gap 0.01.
TEST(Report, PeaksOfAStateThatIsNoSolutionAreNotShownAsPeaks) {
  const auto fact = [](const std::string& name, const std::string& value) {
    return "<dt>" + name + "</dt><dd>" + value;
  };
  const std::string solved = page_of(test::example_result());
  EXPECT_TRUE(has(solved, fact("Largest twist shear", "0.05")));
  EXPECT_TRUE(has(solved, fact("Largest gap in the seam", "0.01")));
  EXPECT_FALSE(has(solved, "class=\"unsolved\""));
  for (const Status status : {Status::interrupted, Status::iteration_limit, Status::unstable}) {
    Result result = test::example_result();
    result.status = status;
    result.criteria = {{"lumen", "svc", 0.9, "", 0.6, 0.4, Verdict::unknown, "a convention"}};
    const std::string page = page_of(result);
    for (const char* name : {"Largest twist shear", "Smallest lumen over rest",
                             "Largest contact pressure", "Largest gap in the seam"})
      EXPECT_TRUE(has(page, fact(name, "unknown</dd>"))) << name;
    EXPECT_TRUE(has(page, "Validity: unknown")) << to_string(status);
    EXPECT_TRUE(has(page, "validity is unknown, and the numbers"));
    EXPECT_FALSE(has(page, "Brazier ratio"));
    EXPECT_FALSE(has(page, "badge good"));
    // The only tables outside the grey are those of the scene, the model and the times.
    const std::size_t grey = page.find("class=\"unsolved\"");
    EXPECT_LT(grey, page.find("What became of the vessels"));
    EXPECT_TRUE(has(page, "<th>Seam, largest gap</th><td>unknown</td>"));
  }
}

TEST(Report, FieldsOfAStateThatIsNoSolutionAreGrey) {
  Result result = test::example_result();
  const std::vector<NamedPicture> solved = report_pictures(result);
  result.status = Status::interrupted;
  for (const DrawnField& field : drawn_fields(result)) {
    EXPECT_TRUE(field.scale.ticks().empty()) << "no numbers on its legend";
    EXPECT_TRUE(has(field.scale.title, "no solution"));
    for (const double part : {0.0, 0.3, 1.0}) {
      const Colour colour =
          field.scale(field.scale.low + part * (field.scale.high - field.scale.low));
      EXPECT_EQ(colour[0], colour[1]);
      EXPECT_EQ(colour[1], colour[2]);
    }
  }
  const std::vector<NamedPicture> pictures = report_pictures(result);
  ASSERT_EQ(pictures.size(), solved.size());
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    EXPECT_EQ(pictures[k].file, solved[k].file);
    EXPECT_EQ(pictures[k].png != solved[k].png, pictures[k].field) << pictures[k].file;
  }
  EXPECT_EQ(pictures[3].title, "result, no solution");
  const nlohmann::json drawn = scene_of(page_of(result));
  for (const auto& field : drawn.at("fields"))
    for (const auto& colour : field.at("colours")) {
      const int rgb = colour.get<int>();
      EXPECT_EQ(rgb >> 16, rgb & 255);
    }
}

TEST(Report, CriteriaHaveTheirColoursOnlyWhereAThresholdIsKnown) {
  Result result = test::example_result();
  EXPECT_FALSE(has(page_of(result), "<h2>Criteria</h2>"));
  result.criteria = {{"lumen", "svc", 0.7, "", 0.6, 0.4, Verdict::fine, "a <convention>"},
                     {"twist", "svc", 100, "degrees", 90.0, 180.0, Verdict::warning, "rats"},
                     {"lumen", "rpa", 0.3, "", 0.6, 0.4, Verdict::strong_warning, "a convention"},
                     {"contact_pressure",
                      "svc",
                      7.500617,
                      "mmHg",
                      {},
                      {},
                      Verdict::not_judged,
                      "no threshold is known"}};
  const std::string page = page_of(result);
  EXPECT_TRUE(has(page,
                  "<th>Smallest lumen over rest</th><td>svc</td><td>0.7</td>"
                  "<td>below 0.6, strong below 0.4</td>"
                  "<td><span class=\"badge good\">fine</span></td><td>a &lt;convention&gt;"));
  EXPECT_TRUE(has(page,
                  "<td>100 degrees</td><td>from 90, strong from 180 degrees</td>"
                  "<td><span class=\"badge warn\">warning</span></td><td>rats</td>"));
  EXPECT_TRUE(has(page, "<td><span class=\"badge bad\">strong warning</span></td>"));
  EXPECT_TRUE(has(page,
                  "<td>7.5 mmHg (0.001 MPa)</td><td>–</td><td>not judged</td>"
                  "<td>no threshold is known</td>"));
}

TEST(Report, WithoutSurfacesThereIsNoLumenAndNoContact) {
  Result result = test::example_result();
  EXPECT_TRUE(has(page_of(result), "<dt>Smallest lumen over rest</dt>"));
  result.fidelity = "rod";
  EXPECT_FALSE(has(page_of(result), "<dt>Smallest lumen over rest</dt>"));
  EXPECT_FALSE(has(page_of(result), "<dt>Largest contact pressure</dt>"));
  result.fidelity = "skin";  // surfaces that do not feel each other
  for (VesselMetrics& metrics : result.metrics) {
    metrics.largest_pressure.reset();
    metrics.contact_area.reset();
  }
  result.contact.clear();
  EXPECT_TRUE(has(page_of(result), "<dt>Largest contact pressure</dt><dd>not modelled</dd>"));
}

Result fitted() {
  Result result = test::example_result();
  const VesselResult svc = result.vessels[0];
  result = Result{};
  result.scene = "svc";
  result.fidelity = "fit";
  result.seconds = {{"fit", 0.5}, {"solve", 0}, {"total", 0.5}};
  result.iterations = {{"rod", 0}};
  result.vessels = {svc};
  result.vessels[0].stump.reset();
  result.stages = {{"rest", {{svc.rest, svc.triangles}}, {"svc"}}};
  result.fit = FitReport{{60, 4, 5, 6},
                         {{60, 4, 5, 6}},
                         {{"start", "3", {1, 2, 3}, {0, 0, -1}, 4}, {"end", "", {}, {}, 6}}};
  return result;
}

TEST(Report, AFitShowsItsAxisAndEndsAndNoTablesOfNothing) {
  const Result result = fitted();
  const std::vector<NamedPicture> pictures = report_pictures(result);
  ASSERT_EQ(pictures.size(), 1U);
  EXPECT_EQ(pictures[0].file, "picture_rest.png");
  const std::string page = report_html(result, pictures);
  EXPECT_FALSE(has(page, "<td class=\"number\">0</td>"));
  EXPECT_TRUE(has(page, "<dt>Length</dt><dd>60"));
  EXPECT_TRUE(has(page, "<h2>Open ends</h2>"));
  EXPECT_TRUE(has(page, "<th>start</th><td>3</td><td>1, 2, 3</td><td>0, 0, -1</td>"));
  for (const char* nothing :
       {"Energy", "Twist", "twist", "ontact", "Balance", "Validity", "Status", "Criteria"})
    EXPECT_FALSE(has(page.substr(0, page.find("<script")), nothing)) << nothing;
  const nlohmann::json scene = scene_of(page);
  EXPECT_TRUE(scene.at("fields").empty());
  EXPECT_TRUE(scene.at("still").get<bool>());
  ASSERT_EQ(scene.at("vessels").size(), 2U) << "the wall and the axis";
  EXPECT_TRUE(scene.at("vessels").at(0).at("glass").get<bool>());
  EXPECT_FALSE(scene.at("vessels").at(1).at("glass").get<bool>());
}

TEST(Report, TheAxisOfAFitIsSeenThroughItsWall) {
  Result result = fitted();
  const std::string with = report_pictures(result).at(0).png;
  result.vessels[0].centerline.reset();
  EXPECT_NE(report_pictures(result).at(0).png, with);
}

TEST(Report, AnUnfinishedSolveSaysHowFarItWasAndKnowsNoValidity) {
  for (const Status status : {Status::interrupted, Status::iteration_limit}) {
    Result result = test::example_result();
    result.status = status;
    result.certificate.relative_residual = 0.03125;
    for (const bool in_range : {true, false}) {
      result.validity.in_range = in_range;
      const std::string page = page_of(result);
      EXPECT_TRUE(has(page, ", relative residual 0.0312</span>"));
      EXPECT_TRUE(has(page, "Validity: unknown"));
      EXPECT_FALSE(has(page, "the model's range"));
      EXPECT_FALSE(has(page, "badge good"));
      EXPECT_TRUE(has(page, "Do not rely on this result"));
    }
  }
  EXPECT_FALSE(has(page_of(test::example_result()), "relative residual"));
}

TEST(Report, HasAPictureOfEachStageAndField) {
  const std::vector<NamedPicture> pictures = report_pictures(test::example_result());
  std::vector<std::string> files;
  for (const NamedPicture& picture : pictures) {
    files.push_back(picture.file);
    EXPECT_EQ(picture.png.substr(1, 3), "PNG");
  }
  EXPECT_EQ(files, (std::vector<std::string>{"picture_rest.png", "picture_cut.png",
                                             "picture_incision.png", "picture_result.png",
                                             "picture_twist_shear.png", "picture_axial_stretch.png",
                                             "picture_contact_pressure.png"}));
  EXPECT_NE(pictures[0].png, pictures[3].png) << "rest and result look the same";
  const std::string page = report_html(test::example_result(), pictures);
  for (const NamedPicture& picture : pictures)
    EXPECT_TRUE(has(page, base64(picture.png))) << picture.file;
}

TEST(Report, PicturesAreAsWideAsTheyAreAskedFor) {
  for (const NamedPicture& picture : report_pictures(test::example_result(), 2, {}, 1600)) {
    EXPECT_EQ(picture.width, 1600) << picture.file;
    EXPECT_GT(picture.height, 1000) << picture.file;
  }
}

// A wall sheared or stretched by a hundredth is no cause for alarm; one by 0.3 has the last colour.
TEST(Report, HarmlessValuesArePale) {
  const auto strongest = [](double strain) {
    Result result = test::example_result();
    for (VesselResult& vessel : result.vessels) {
      vessel.twist_shear.setConstant(strain);
      vessel.axial_stretch.setConstant(1 + strain);
      vessel.contact_pressure.setConstant(1e-3 * strain);
    }
    std::vector<float> distances;
    for (const DrawnField& field : drawn_fields(result)) {
      const double value = field.file == "axial_stretch"      ? 1 + strain
                           : field.file == "contact_pressure" ? 1e-3 * strain
                                                              : strain;
      const Colour colour = field.scale(value), rest = field.scale(field.at_rest);
      float most = 0;
      for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(colour[k] - rest[k]));
      distances.push_back(most);
    }
    return distances;
  };
  for (const float distance : strongest(0.01)) EXPECT_LT(distance, 0.05F);
  const std::vector<float> large = strongest(0.3);
  ASSERT_EQ(large.size(), 3U);
  EXPECT_GT(large[0], 0.5F);
  EXPECT_GT(large[1], 0.5F);
}

TEST(Report, PressuresAreInMillimetresOfMercuryToo) {
  Result result = test::example_result();
  const std::string page = page_of(result);
  EXPECT_TRUE(has(page, "7.5 <small>mmHg (0.001 MPa)</small>")) << "the peak of the example";
  for (const DrawnField& field : drawn_fields(result))
    if (field.file == "contact_pressure") {
      EXPECT_EQ(field.scale.title, "contact pressure, mmHg");
      EXPECT_EQ(field.scale.text_at(field.scale.ticks().at(1)), "2");
      EXPECT_NEAR(field.scale.high, 10 * 133.322387415e-6, 1e-12);
    }
}

TEST(Report, AFieldThatWasNotModelledHasNoPicture) {
  Result result = test::example_result();
  for (VesselResult& vessel : result.vessels) vessel.contact_pressure.resize(0);
  for (const NamedPicture& picture : report_pictures(result))
    EXPECT_NE(picture.file, "picture_contact_pressure.png");
}

// Every region that may scroll takes the keyboard's focus and has a name.
TEST(Report, WhatScrollsIsReachedByTheKeyboard) {
  const std::string page = page_of(test::example_result());
  const std::regex region("<div class=\"scroll\"[^>]*>"),
      good("<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"[^\"]+\">");
  int count = 0;
  for (auto it = std::sregex_iterator(page.begin(), page.end(), region);
       it != std::sregex_iterator(); ++it, ++count)
    EXPECT_TRUE(std::regex_match(it->str(), good)) << it->str();
  EXPECT_GT(count, 5);
}

TEST(Report, TheStumpIsThereFromTheCutOn) {
  Result result = test::example_result();
  const auto with = report_pictures(result);
  result.vessels[0].stump.reset();
  const auto without = report_pictures(result);
  EXPECT_EQ(with[0].png, without[0].png) << "rest";
  for (std::size_t stage = 1; stage < 4; ++stage)
    EXPECT_NE(with[stage].png, without[stage].png) << stage;
}

// Contact on one side or on the other: one of the two is not visible in the direction of the other
// pictures.
TEST(Report, TheContactPressureIsLookedAtFromItsSide) {
  int turned = 0;
  for (const double side : {-1.0, 1.0}) {
    Result result = test::example_result();
    VesselResult& svc = result.vessels[0];
    for (Eigen::Index i = 0; i < svc.rest.rows(); ++i)
      svc.contact_pressure[i] =
          side * svc.rest(i, 0) > 4.5 && std::abs(svc.rest(i, 2) - 30) < 5 ? 1e-3 : 0;
    const auto pictures = report_pictures(result);
    EXPECT_EQ(pictures[4].title, "twist shear");
    turned += has(pictures[6].title, "from where most of it is seen");
  }
  EXPECT_GE(turned, 1);
}

TEST(Report, ThreadsDoNotChangeThePictures) {
  const std::vector<NamedPicture> one = report_pictures(test::example_result(), 1);
  const std::vector<NamedPicture> three = report_pictures(test::example_result(), 3);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].png, three[i].png) << one[i].file;
}

TEST(Report, HasEveryTable) {
  const std::string page = page_of(test::example_result());
  for (const char* heading :
       {"What became of the vessels", "The operation", "What the supports do", "Contact",
        "Balance of forces, N", "Energy", "What was modelled", "Time", "Environment"})
    EXPECT_TRUE(has(page, "<h2>" + std::string(heading) + "</h2>")) << heading;
  EXPECT_TRUE(has(page, "no vessel within reach"));
  EXPECT_TRUE(has(page, "sha256:00ff"));
}

TEST(Report, EscapesWhatItWasGiven) {
  Result result = test::example_result();
  result.scene = "<script>alert(1)</script>";
  result.vessels[0].name = "</script><b>";
  const std::string page = page_of(result);
  EXPECT_FALSE(has(page, "<script>alert"));
  EXPECT_FALSE(has(page, "</script><b>"));
  EXPECT_EQ(scene_of(page).at("vessels").at(0).at("name"), "</script><b>");
}

TEST(Report, TheViewHasThePointsWithinAStep) {
  const Result result = test::example_result();
  const nlohmann::json scene = scene_of(page_of(result));
  ASSERT_EQ(scene.at("vessels").size(), 3u) << "svc, its stump, aorta";
  const VesselResult& vessel = result.vessels[0];
  const std::string bytes = decoded(scene.at("vessels").at(0).at("current").get<std::string>());
  ASSERT_EQ(bytes.size(), static_cast<std::size_t>(vessel.current.size()) * 2);
  const double step = scene.at("size").get<double>() / 65535;
  for (Eigen::Index i = 0; i < vessel.current.rows(); ++i)
    for (int k = 0; k < 3; ++k) {
      const std::size_t at = 2 * static_cast<std::size_t>(3 * i + k);
      const int value =
          static_cast<unsigned char>(bytes[at]) + 256 * static_cast<unsigned char>(bytes[at + 1]);
      ASSERT_NEAR(scene.at("low").at(static_cast<std::size_t>(k)).get<double>() + value * step,
                  vessel.current(i, k), step);
    }
  EXPECT_EQ(decoded(scene.at("vessels").at(0).at("triangles").get<std::string>()).size(),
            static_cast<std::size_t>(vessel.triangles.size()) * 4);
  EXPECT_TRUE(scene.at("vessels").at(0).at("fields").at(0).is_string());
  EXPECT_TRUE(scene.at("vessels").at(2).at("fields").at(0).is_null()) << "an obstacle has no twist";
}

TEST(Report, AnOperationIsAboutTheVesselsItJoins) {
  Result result = test::example_result();
  result.vessels[1].name = "rpa";
  result.vessels[1].obstacle = false;
  VesselResult beside = test::obstacle(24, 30);
  beside.obstacle = false;  // deformable, but not joined by the operation
  result.vessels.push_back(beside);
  const auto wanted = [&] {
    std::map<std::string, bool> names;
    for (const DrawnBody& body : drawn_bodies(result)) names[body.name] = body.wanted;
    return names;
  };
  EXPECT_EQ(wanted(), (std::map<std::string, bool>{
                          {"svc", true}, {"svc stump", false}, {"rpa", true}, {"aorta", false}}));
  result.glenn.reset();
  EXPECT_TRUE(wanted().at("aorta"));
}

TEST(Report, AnEndToEndJoinHasItsTableAndATransparentStump) {
  Result result = test::example_result();
  result.glenn.reset();
  EndToEndReport& report = result.end_to_end.emplace();
  report.rims[0].vessel = "svc";
  report.rims[0].cut.perimeter = 61.25;
  report.rims[1].vessel = "graft";
  report.narrower = 1;
  report.join.pairs = 73;
  report.mouth.emplace();
  report.mouth->area_ratio = 0.875;
  const std::string page = page_of(result);
  for (const char* text : {"Rim of svc, part of its length", "61.2 mm", "Rim of graft",
                           "Mouth, lumen over that of graft", "0.875", "73"})
    EXPECT_TRUE(has(page, text)) << text;
  std::map<std::string, bool> glass;
  for (const DrawnBody& body : drawn_bodies(result)) glass[body.name] = body.glass;
  EXPECT_TRUE(glass.at("svc stump"));
  EXPECT_FALSE(glass.at("svc"));
}

TEST(Report, ABareRodIsDrawnAsATube) {
  Result result = test::example_result();
  VesselResult rod;
  rod.name = "rod";
  rod.centerline = result.vessels[0].centerline;
  rod.centerline->radius.clear();
  result.vessels = {rod};
  result.stages.clear();
  const DrawnBody shape = drawn_bodies(result).at(0);
  EXPECT_EQ(shape.current.rows(), 12 * rod.centerline->current.rows());
  for (Eigen::Index i = 0; i < shape.current.rows(); ++i) {
    EXPECT_NEAR((shape.current.row(i) - rod.centerline->current.row(i / 12)).norm(), 0.6, 1e-9);
    EXPECT_NEAR((shape.rest.row(i) - rod.centerline->rest.row(i / 12)).norm(), 0.6, 1e-9);
  }
  const std::vector<NamedPicture> pictures = report_pictures(result);
  ASSERT_EQ(pictures.size(), 2u) << "rest and result; a rod has no field on a wall";
  EXPECT_NE(pictures[0].png, pictures[1].png);
}

TEST(Report, SurvivesAnEmptyResultAndWhatIsNotANumber) {
  EXPECT_TRUE(has(report_html(Result{}, report_pictures(Result{})), "</html>"));
  Result result = test::example_result();
  result.vessels[0].current.row(5).setConstant(std::numeric_limits<double>::quiet_NaN());
  result.vessels[0].twist_shear[3] = std::numeric_limits<double>::infinity();
  result.energy.rod = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(has(report_html(result, report_pictures(result)), "</html>"));
}

TEST(Report, ForceUnitsFollowTheScene) {
  Result result;
  EXPECT_EQ(force_unit(result), "N");
  result.stress_unit = "kPa";
  EXPECT_EQ(force_unit(result), "mN");
  result.length_unit = "cm";
  EXPECT_EQ(force_unit(result), "kPa cm²");
}

}  // namespace
}  // namespace vasorod
