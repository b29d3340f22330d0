#include <vasorod/error.h>

#include "planner/session.h"
#include "planner/small_scene.h"

namespace vasorod::planner {
namespace {

using SessionTest = SmallScene;

int status_of(Session& session, const std::string& what, const std::string& body) {
  return refusal_of([&] { session.post(what, Body(body)); }).status;
}

TEST_F(SessionTest, OpensTheFirstSourceWhenItIsAskedForOne) {
  Session session({write("small.yaml", small_scene)}, folder);
  EXPECT_TRUE(session.about()["current"].is_null());
  EXPECT_EQ(session.scene()["name"], "small");
  EXPECT_EQ(session.about()["current"], "s1");
  EXPECT_EQ(session.about()["fidelities"].size(), 4U);
}

TEST_F(SessionTest, AFolderWithoutAnythingSaysSo) {
  Session session({}, folder);
  EXPECT_TRUE(session.about()["sources"].empty());
  EXPECT_EQ(refusal_of([&] { session.scene(); }).status, 404);
  EXPECT_EQ(status_of(session, "solve", R"({"plan": null, "fidelity": "rod"})"), 404);
}

TEST_F(SessionTest, ASceneThatDoesNotOpenLeavesTheOpenedOne) {
  write("a.yaml", small_scene);
  write("b.yaml", "vessels:\n  - 3\n");
  Session session({folder / "a.yaml"}, folder);
  session.scene();
  EXPECT_THROW(session.post("open", Body(R"({"id": "s2"})")), InputError);
  EXPECT_EQ(session.about()["current"], "s1");
  EXPECT_EQ(session.scene()["name"], "small");
}

TEST_F(SessionTest, UnknownThingsAreRefused) {
  Session session({write("small.yaml", small_scene)}, folder);
  EXPECT_EQ(status_of(session, "open", R"({"id": "s9"})"), 404);
  EXPECT_EQ(status_of(session, "fly", "{}"), 404);
  EXPECT_EQ(status_of(session, "cancel", R"({"job": "j1"})"), 404);
  EXPECT_EQ(status_of(session, "solve", R"({"plan": null, "fidelity": "fast"})"), 400);
  EXPECT_EQ(refusal_of([&] { session.job("j1", 0); }).status, 404);
  EXPECT_EQ(refusal_of([&] { session.result("r1"); }).status, 404);
  EXPECT_EQ(refusal_of([&] { session.result_mesh("r1", "svc"); }).status, 404);
  EXPECT_EQ(refusal_of([&] { session.mesh("none"); }).status, 404);
}

TEST_F(SessionTest, OpeningDropsWhatIsSolved) {
  Session session({write("small.yaml", small_scene)}, folder);
  session.scene();
  const std::string job =
      session.post("solve", Body(R"({"plan": null, "fidelity": "coupled"})"))["job"];
  session.post("open", Body(R"({"id": "s1"})"));
  EXPECT_EQ(session.job(job, 0)["state"], "cancelled");
}

}  // namespace
}  // namespace vasorod::planner
