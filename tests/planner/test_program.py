"""vasorod-plan as its page uses it: geometry that is known, a solve that is vasorod's own."""

import json
import math
import subprocess
import unittest

from planner_program import SCENE, SOLVER, SOURCE, Planner, WithPlanner


def moved(plan, **changes):
    """A plan with other numbers; cut and incision are given whole."""
    return {**json.loads(json.dumps(plan)), **changes}


class Page(WithPlanner):
    """The files of the page."""

    def test_it_is_embedded(self):
        for name, kind in (
            ("", "text/html"),
            ("index.html", "text/html"),
            ("app.js", "application/javascript"),
            ("app.css", "text/css"),
        ):
            status, headers, body = self.planner.ask("GET", name)
            self.assertEqual(status, 200, name)
            self.assertTrue(headers["Content-Type"].startswith(kind), headers)
            self.assertGreater(len(body), 0, name)

    def test_the_session_says_what_can_be_opened(self):
        session = self.planner.get("api/session")
        self.assertTrue(session["program"].startswith("vasorod-plan "))
        self.assertEqual(session["folder"], str(self.planner.folder))
        self.assertEqual(session["sources"][0]["name"], "small")
        self.assertEqual(session["sources"][0]["kind"], "scene")
        names = [one["name"] for one in session["fidelities"]]
        self.assertEqual(names, ["rod", "skin", "paper", "coupled"])


class Geometry(WithPlanner):
    """Two straight tubes: every place can be written down."""

    def test_the_picks_of_the_scene_become_fractions(self):
        # The vein is kept from z = 45 down; it is cut at z = 10 of 40 mm.
        self.assertAlmostEqual(self.plan["cut"]["along"], 35 / 40, places=3)
        self.assertAlmostEqual(self.plan["incision"]["along"], 0.5, places=3)
        self.assertEqual(self.plan["shape"], "slit")
        self.assertIsNone(self.plan["rotation_deg"])

    def test_a_pick_meets_the_front_wall(self):
        for angle in (0, 1, 2.5, -2):
            for z in (12, 27.5, 40):
                out = (math.cos(angle), math.sin(angle), 0)
                body = {
                    "origin": [20 * out[0], 20 * out[1], z],
                    "direction": [-3 * out[0], -3 * out[1], 0],
                }
                hit = self.planner.post("api/pick", body)["hit"]
                self.assertEqual((hit["vessel"], hit["part"]), ("svc", "svc"))
                # The triangles lie inside the cylinder by at most its sagitta.
                inside = 3.3 * (1 - math.cos(math.pi / 24))
                self.assertLessEqual(20 - 3.3 - 1e-6, hit["distance"])
                self.assertLessEqual(hit["distance"], 20 - 3.3 + inside + 1e-6)
                self.assertAlmostEqual(hit["along"], (45 - z) / 40, places=3)

    def test_angles_turn_with_the_wall(self):
        found = []
        for k in range(8):
            angle = k * math.pi / 4
            y, z = math.cos(angle), math.sin(angle)
            body = {"origin": [5, 30 * y, 30 * z], "direction": [0, -y, -z], "vessels": ["rpa"]}
            hit = self.planner.post("api/pick", body)["hit"]
            self.assertEqual((hit["vessel"], hit["part"]), ("rpa", "rpa"))
            self.assertAlmostEqual(hit["along"], 0.6, places=3)
            found.append(hit["around_deg"])
        steps = {round((b - a) % 360) for a, b in zip(found, found[1:])}
        self.assertTrue(steps in ({45}, {315}), steps)

    def test_a_ray_past_everything_hits_nothing(self):
        body = {"origin": [100, 100, 100], "direction": [1, 0, 0]}
        self.assertIsNone(self.planner.post("api/pick", body)["hit"])

    def test_the_mesh_is_the_tube(self):
        mesh = self.planner.mesh("api/mesh/svc")
        self.assertEqual(len(mesh["points"]), 24 * 51)
        self.assertEqual(len(mesh["triangles"]), 2 * 24 * 50)
        for x, y, z in mesh["points"]:
            self.assertAlmostEqual(math.hypot(x, y), 3.3, places=4)
            self.assertTrue(5 - 1e-4 <= z <= 45 + 1e-4)

    def test_a_section_is_a_circle(self):
        body = {"result": None, "point": [0, 0, 25], "normal": [0, 0, 2]}
        vessels = self.planner.post("api/section", body)["vessels"]
        self.assertEqual([one["name"] for one in vessels], ["svc"])
        # A section of 24 staggered rows has 24 to 48 corners on or inside the circle.
        area, perimeter = math.pi * 3.3**2, 2 * math.pi * 3.3
        self.assertEqual(vessels[0]["closed"], [True])
        self.assertAlmostEqual(vessels[0]["area"] / area, 1, delta=0.02)
        self.assertAlmostEqual(vessels[0]["perimeter"] / perimeter, 1, delta=0.01)
        # A tube's surface is its mid-wall; the wall is 0.4 thick.
        inset = area - 0.2 * perimeter + math.pi * 0.04
        self.assertAlmostEqual(vessels[0]["lumen"] / inset, 1, delta=0.02)

    def test_a_plan_is_drawn_where_it_is(self):
        drawn = self.planner.post("api/place", {"plan": self.plan})
        self.assertIsNone(drawn["problem"])
        for _, _, z in drawn["cut"]["outline"]:
            self.assertAlmostEqual(z, 10, places=3)
        self.assertAlmostEqual(abs(drawn["cut"]["normal"][2]), 1, places=6)
        # The slit has half the perimeter of the mouth and runs along x at the top of the artery.
        (x0, y0, z0), (x1, _, _) = drawn["incision"]["ends"]
        self.assertAlmostEqual(abs(x1 - x0) / (math.pi * 3.3), 1, delta=0.02)
        self.assertAlmostEqual(y0, 0, delta=0.02)
        self.assertAlmostEqual(z0, 4, delta=0.03)

    def test_a_plan_that_cannot_be_built_says_why(self):
        plan = moved(self.plan, incision={"along": 0.02, "around_deg": 0})
        drawn = self.planner.post("api/place", {"plan": plan})
        self.assertIn("incision", drawn["problem"])
        self.assertIsNotNone(drawn["cut"])
        status = self.planner.solved(plan)
        self.assertEqual(status["state"], "failed")
        self.assertEqual(status["error"], drawn["problem"])


class Solving(WithPlanner):
    """Results are those of vasorod."""

    def numbers(self, result):
        """result.json without what differs from run to run or from place to place."""
        left = {"seconds", "environment", "program", "scene"}
        return {key: value for key, value in result.items() if key not in left}

    def same_as_the_solver(self, plan, fidelity, name):
        """A saved scene solved by vasorod has the numbers of the page's result."""
        status = self.planner.solved(plan, fidelity)
        self.assertEqual(status["state"], "done", status)
        answer = self.planner.get("api/result/" + status["result"])
        saved = self.planner.post(
            "api/save", {"name": name, "plan": plan, "fidelity": fidelity, "overwrite": False}
        )
        self.assertIsNone(saved["note"])
        folder = self.planner.folder / (name + "-solved")
        subprocess.run(
            [SOLVER, "solve", saved["file"], "-o", folder, "--no-report", "-q"],
            check=True,
            capture_output=True,
        )
        theirs = json.loads((folder / "result.json").read_text())
        self.assertEqual(self.numbers(answer["json"]), self.numbers(theirs))
        # The hash of the scene is that of the saved file.
        ours = answer["json"]["environment"]["inputs"]
        self.assertEqual(sorted(ours.values()), sorted(theirs["environment"]["inputs"].values()))
        self.assertEqual(answer["plan"], plan)
        return status, saved

    def test_as_opened(self):
        self.same_as_the_solver(self.plan, "skin", "as_opened.yaml")

    def test_everything_changed(self):
        plan = moved(
            self.plan,
            cut={"along": 0.8123456789012345},
            cut_tilt_deg=12.5,
            incision={"along": 0.47, "around_deg": self.plan["incision"]["around_deg"] + 7.25},
            incision_length=1.1,
            shape={"ellipse": 0.4},
            rotation_deg=-15.5,
        )
        _, saved = self.same_as_the_solver(plan, "skin", "changed.yaml")
        with Planner(saved["file"], scene=None, folder=self.planner.folder) as again:
            self.assertEqual(again.get("api/scene")["plan"], plan)

    def test_another_fidelity(self):
        self.same_as_the_solver(self.plan, "rod", "rod.yaml")

    def test_the_scene_as_it_is(self):
        status = self.planner.solved(None, "skin")
        self.assertEqual(status["state"], "done")
        self.assertIsNone(self.planner.get("api/result/" + status["result"])["plan"])

    def test_meshes_picks_and_lines_of_a_result(self):
        status = self.planner.solved(self.plan)
        rid = status["result"]
        answer = self.planner.get("api/result/" + rid)
        names = {one["name"]: one for one in answer["vessels"]}
        self.assertEqual(names["svc_stump"]["role"], "stump")
        mesh = self.planner.mesh(f"api/result/{rid}/mesh/svc")
        self.assertEqual(len(mesh["points"]), len(mesh["rest"]))
        fields = {one["name"] for one in names["svc"]["fields"]}
        self.assertEqual(fields, set(mesh) - {"points", "triangles", "rest"})
        self.assertGreater(len(self.planner.mesh(f"api/result/{rid}/mesh/svc_stump")["points"]), 0)
        # The middle of a triangle that is seen from outside.
        a, b, c = (mesh["points"][k] for k in mesh["triangles"][100])
        middle = [sum(p[k] for p in (a, b, c)) / 3 for k in range(3)]
        u, v = ([q[k] - a[k] for k in range(3)] for q in (b, c))
        normal = [
            u[1] * v[2] - u[2] * v[1],
            u[2] * v[0] - u[0] * v[2],
            u[0] * v[1] - u[1] * v[0],
        ]
        size = math.sqrt(sum(x * x for x in normal))
        origin = [m + 0.05 * n / size for m, n in zip(middle, normal)]
        body = {"origin": origin, "direction": [-n for n in normal], "result": rid}
        hit = self.planner.post("api/pick", body)["hit"]
        self.assertEqual((hit["vessel"], hit["triangle"]), ("svc", 100))
        for weight in hit["weights"]:
            self.assertAlmostEqual(weight, 1 / 3, places=3)
        for name, value in hit["values"].items():
            mean = sum(mesh[name][k][0] for k in mesh["triangles"][100]) / 3
            self.assertAlmostEqual(value, mean, places=4)
        for line in answer["lines"]:
            arcs = {len(line[key]) for key in ("arc", "point", "rest", "stretch", "radius")}
            self.assertEqual(len(arcs), 1)

    def test_the_newest_wins(self):
        first = self.planner.post("api/solve", {"plan": self.plan, "fidelity": "coupled"})["job"]
        second = self.planner.post("api/solve", {"plan": self.plan, "fidelity": "skin"})["job"]
        self.assertEqual(self.planner.ended(second)["state"], "done")
        dropped = self.planner.ended(first)
        self.assertEqual((dropped["state"], dropped["result"]), ("cancelled", None))

    def test_a_cancelled_solve_leaves_its_last_state(self):
        job = self.planner.post("api/solve", {"plan": self.plan, "fidelity": "coupled"})["job"]
        status = self.planner.get(f"api/job/{job}")
        early = ("waiting", "surgery", "rod of")
        while status["state"] == "running" and status["stage"].startswith(early):
            status = self.planner.get(f"api/job/{job}?wait=1000")
        self.planner.post("api/cancel", {"job": job})
        status = self.planner.ended(job)
        self.assertEqual(status["state"], "cancelled", status)
        result = self.planner.get("api/result/" + status["result"])["json"]
        self.assertEqual(result["status"], "interrupted")

    def test_only_held_results_outlive_32_others(self):
        first = self.planner.solved(self.plan, "rod")["result"]
        held = self.planner.solved(self.plan, "rod")["result"]
        self.assertEqual(
            self.planner.post("api/hold", {"result": held, "hold": True}), {"held": True}
        )
        for _ in range(33):
            self.planner.solved(self.plan, "rod")
        self.assertEqual(self.planner.ask("GET", "api/result/" + first)[0], 404)
        self.assertEqual(self.planner.ask("GET", "api/result/" + held)[0], 200)


class Files(WithPlanner):
    """What is written, and that nothing else is."""

    def save(self, **changes):
        """Status and answer of a save."""
        body = {"name": "x.yaml", "plan": self.plan, "fidelity": "skin", "overwrite": False}
        status, _, answer = self.planner.ask("POST", "api/save", json.dumps({**body, **changes}))
        return status, json.loads(answer)

    def test_a_saved_scene_keeps_every_other_line(self):
        plan = moved(self.plan, cut={"along": 0.8}, cut_tilt_deg=5)
        status, answer = self.save(name="lines.yaml", plan=plan, fidelity="paper")
        self.assertEqual((status, answer["note"]), (200, None))
        wanted = (
            SCENE.replace(
                "    cut: [3.3, 0, 10]        # above the artery\n",
                "    cut: {along: 0.8}        # was: above the artery\n",
            )
            .replace("    incision: [0, 0, 4]\n", "    incision: [0, 0, 4]\n    cut_tilt_deg: 5\n")
            .replace("fidelity: skin   # quick", "fidelity: paper  # was: quick")
        )
        self.assertEqual((self.planner.folder / "lines.yaml").read_text(), wanted)

    def test_no_file_is_written_over_without_being_asked(self):
        there = self.planner.folder / "there.yaml"
        there.write_text("mine")
        status, answer = self.save(name="there.yaml")
        self.assertEqual(status, 409)
        self.assertIn("there.yaml", answer["error"])
        self.assertEqual(there.read_text(), "mine")
        self.assertEqual(self.save(name="there.yaml", overwrite=True)[0], 200)
        self.assertNotEqual(there.read_text(), "mine")
        self.assertEqual([p.name for p in self.planner.folder.glob(".*")], [])

    def test_names_stay_in_the_folder(self):
        before = sorted(self.planner.folder.parent.iterdir())
        for name in (
            "../up.yaml",
            "a/b.yaml",
            "/tmp/abs.yaml",
            ".hidden.yaml",
            "",
            ".yaml",
            "..",
            "x.yml",
            "x y.yaml",
            "x\u0000.yaml",
            "x\n.yaml",
            "-x.yaml",
            "a" * 200 + ".yaml",
            "ü.yaml",
        ):
            status, answer = self.save(name=name)
            self.assertEqual(status, 400, name)
            self.assertIn("name: found", answer["error"])
            status, sentence = self.planner.refused("api/keep", {"result": "r1", "name": "../x"})
            self.assertIn(status, (400, 404))
        self.assertEqual(sorted(self.planner.folder.parent.iterdir()), before)

    def test_a_kept_result_is_a_result_folder(self):
        rid = self.planner.solved(self.plan)["result"]
        answer = self.planner.post("api/keep", {"result": rid, "name": "kept"})
        folder = self.planner.folder / "kept"
        self.assertEqual(answer["folder"], str(folder))
        self.assertTrue((folder / "report.html").is_file())
        ours = self.planner.get("api/result/" + rid)["json"]
        theirs = json.loads((folder / "result.json").read_text())
        for one in (ours, theirs):
            one.pop("seconds")
        self.assertEqual(ours, theirs)
        self.assertEqual(self.planner.refused("api/keep", {"result": rid, "name": "kept"})[0], 409)
        with Planner(str(folder), scene=None, folder=self.planner.folder) as again:
            scene = again.get("api/scene")
            self.assertEqual((scene["kind"], scene["editable"]), ("result", False))
            held = again.post("api/hold", {"result": scene["result"], "hold": True})
            self.assertEqual(held, {"held": True})
            opened = again.get("api/result/" + scene["result"])
            here = self.planner.get("api/result/" + rid)
            # A file has the fields that were not modelled too, at their values at rest.
            names = [[one["name"] for one in answer["vessels"]] for answer in (opened, here)]
            self.assertEqual(*names)
            for theirs, ours in zip(opened["vessels"], here["vessels"]):
                for field in ours["fields"]:
                    self.assertIn(field, theirs["fields"])
            self.assertEqual(opened["lines"], here["lines"])
            for name in ("svc", "rpa", "svc_stump"):
                ours = self.planner.mesh(f"api/result/{rid}/mesh/{name}")
                theirs = again.mesh(f"api/result/{scene['result']}/mesh/{name}")
                self.assertEqual(ours, {key: theirs[key] for key in ours})

    def test_other_scenes_of_the_folder_can_be_opened(self):
        (self.planner.folder / "zz_other.yaml").write_text(SCENE.replace("small", "other"))
        with Planner(
            str(self.planner.folder / "small.yaml"), scene=None, folder=self.planner.folder
        ) as other:
            sources = {one["name"]: one for one in other.get("api/session")["sources"]}
            scene = other.post("api/open", {"id": sources["zz_other"]["id"]})
            self.assertEqual(scene["name"], "other")
            self.assertEqual(other.get("api/session")["current"], sources["zz_other"]["id"])


class Bundled(unittest.TestCase):
    """The scene that ./run plan opens."""

    def test_a_branched_artery_can_be_picked_on_every_branch(self):
        scene = SOURCE / "benchmarks" / "cases" / "glenn" / "infant.yaml"
        with Planner(str(scene), scene=None) as planner:
            opened = planner.get("api/scene")
            self.assertTrue(opened["editable"])
            artery = next(one for one in opened["vessels"] if one["part"] == "rpa")
            self.assertEqual(len(artery["ends"]), 3)
            routes = set()
            for place in artery["routes"]:
                at = place["axis"][85]
                body = {"origin": at["point"], "direction": [0, 0, 1], "vessels": [artery["name"]]}
                hit = planner.post("api/pick", body)["hit"]
                self.assertAlmostEqual(hit["along"], 0.85, delta=0.1)
                routes.add(tuple(hit.get("route", artery["route"])))
                plan = moved(opened["plan"])
                plan["incision"] = {
                    key: hit[key] for key in ("along", "around_deg", "route") if key in hit
                }
                drawn = planner.post("api/place", {"plan": plan})
                for mine, theirs in zip(drawn["incision"]["point"], hit["point"]):
                    self.assertAlmostEqual(mine, theirs, delta=0.1)
            self.assertEqual(len(routes), 2)


if __name__ == "__main__":
    unittest.main()
