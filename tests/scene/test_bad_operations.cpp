// Operations that must be refused with one sentence.
#include "bad_scene.h"

namespace vasorod {
namespace {

using testing::Bad;

const std::string glenn =
    "  glenn: {svc: tube, rpa: other, cut: [10, 0, 50], incision: [35, 0, 25], keep: {near: [0, 0, "
    "100]}}";

std::string end_to_end(const std::string& rims) {
  return "  end_to_end: {rims: [" + rims + "]}";
}

const std::vector<Bad> bads = {
    {"surgery_unknown", "glenn:", "fontan:", {"\"fontan\"", "glenn"}},
    {"surgery_empty", glenn, "  {}", {":15:", "surgery: found neither glenn nor end_to_end"}},
    {"surgery_both",
     "contact: [[tube, other]]\nsurgery:",
     "contact: [[tube, other]]\nsurgery:\n  end_to_end: {}",
     {"surgery: found both glenn and end_to_end", "one operation"}},
    {"rims_missing", glenn, "  end_to_end: {}", {"surgery.end_to_end.rims: found nothing"}},
    {"rims_one",
     glenn,
     end_to_end("{vessel: tube, end: end}"),
     {"rims: found", "a list of two rims"}},
    {"rims_same",
     glenn,
     end_to_end("{vessel: tube, end: end}, {vessel: tube, end: start}"),
     {":15:", "rims[1].vessel: found \"tube\" a second time", "another vessel"}},
    {"rim_unknown_vessel",
     glenn,
     end_to_end("{vessel: tube, end: end}, {vessel: othr, end: start}"),
     {"rims[1].vessel", "\"othr\"", "\"other\""}},
    {"rim_without_place",
     glenn,
     end_to_end("{vessel: tube, end: end}, {vessel: other}"),
     {"rims[1]: found neither cut nor end"}},
    {"rim_with_two_places",
     glenn,
     end_to_end("{vessel: tube, end: end, cut: [10, 0, 50]}, {vessel: other, end: start}"),
     {"rims[0]: found both cut and end"}},
    {"rim_without_keep",
     glenn,
     end_to_end("{vessel: tube, cut: [10, 0, 50]}, {vessel: other, end: start}"),
     {"rims[0].keep: found nothing"}},
    {"rim_keeps_a_whole_vessel",
     glenn,
     end_to_end("{vessel: tube, end: end, cut_tilt_deg: 5}, {vessel: other, end: start}"),
     {"rims[0].cut_tilt_deg: found it beside end"}},
    {"rim_tilt",
     glenn,
     end_to_end("{vessel: tube, cut: [10, 0, 50], cut_tilt_deg: 76, keep: {near: [0, 0, 0]}}, "
                "{vessel: other, end: start}"),
     {"rims[0].cut_tilt_deg: found 76", "-75 to 75"}},
    {"rim_end_word",
     glenn,
     end_to_end("{vessel: tube, end: top}, {vessel: other, end: start}"),
     {"rims[0].end: found \"top\"", "start, end, {near: [x, y, z]} or {face: ModelFaceID}"}},
    {"end_to_end_rotation_word",
     glenn,
     end_to_end("{vessel: tube, end: end}, {vessel: other, end: start}], rotation_deg: [automatic"),
     {"rotation_deg: found", "auto or a number"}},
    {"glenn_same", "rpa: other", "rpa: tube", {"another vessel"}},
    {"glenn_no_cut", "cut: [10, 0, 50], ", "", {"surgery.glenn.cut: found nothing"}},
    {"glenn_incision_length",
     "svc: tube,",
     "svc: tube, incision_length: 5,",
     {"surgery.glenn.incision_length: found 5"}},
    {"glenn_tilt",
     "svc: tube,",
     "svc: tube, cut_tilt_deg: 80,",
     {"surgery.glenn.cut_tilt_deg: found 80", "-75 to 75"}},
    {"glenn_shape_word",
     "svc: tube,",
     "svc: tube, incision_shape: oval,",
     {"surgery.glenn.incision_shape: found \"oval\"", "slit, {ellipse: RATIO}"}},
    {"glenn_ellipse_ratio",
     "svc: tube,",
     "svc: tube, incision_shape: {ellipse: 1.5},",
     {"incision_shape.ellipse: found 1.5", "0.1 to 1"}},
    {"glenn_ellipse_no_width",
     "svc: tube,",
     "svc: tube, incision_shape: {ellipse: {length: 8}},",
     {"incision_shape.ellipse.width: found nothing", "across the artery"}},
    {"glenn_ellipse_two_lengths",
     "svc: tube,",
     "svc: tube, incision_length: 1, incision_shape: {ellipse: {length: 8, width: 4}},",
     {"surgery.glenn.incision_length: found it beside an ellipse that has a length"}},
    {"glenn_rotation_word",
     "svc: tube",
     "svc: tube, rotation_deg: automatic",
     {"auto or a number"}},
    {"glenn_no_keep", ", keep: {near: [0, 0, 100]}", "", {"surgery.glenn.keep"}},
};

class BadOperation : public testing::BadScene {};

TEST_F(BadOperation, IsRefusedWithOneSentence) {
  expect_refused(bads);
}

}  // namespace
}  // namespace vasorod
