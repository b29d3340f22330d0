// The page of vasorod-plan: puts the pieces together.
import "./app.css";
import { Api, Unreachable } from "./api.js";
import { Camera } from "./camera.js";
import { letterOf, showComparison } from "./compare.js";
import { announce, byId, make } from "./dom.js";
import { askName, fileOf, showSources } from "./files.js";
import { nearestNode } from "./geometry.js";
import { newest } from "./newest.js";
import { download, pictureOf } from "./picture.js";
import { PlanState } from "./plan.js";
import { planPanel } from "./plan_panel.js";
import { Plots } from "./plots.js";
import { Predicting } from "./predicting.js";
import { showResult } from "./result_panel.js";
import { Sections } from "./section.js";
import { Solving } from "./solving.js";
import { Stage } from "./stage.js";
import { loadRest, loadResult } from "./subjects.js";
import { Tools } from "./tools.js";
import { distance, norm, sub } from "./vectors.js";
import { Views } from "./views.js";
import { plainName } from "./words.js";

const keys = [
  ["Click the vein, the artery", "place the cut, the incision"],
  ["Drag a marker", "move it along its vessel; the quick prediction follows"],
  ["Drag, arrow keys", "turn"],
  ["Wheel, pinch, + and −", "zoom"],
  ["Shift and drag, two fingers, Shift and arrows", "move"],
  ["1, 2, 3", "view from the front, the left, the top"],
  ["0", "the whole scene again"],
  ["Ctrl+Z, Ctrl+Shift+Z", "undo, redo"],
  ["L", "lock or unlock the plan"],
  ["K", "keep this plan beside the others"],
  ["B", "before or after, in one view"],
  ["R, S, Esc", "ruler, section, back to the plan"],
  ["Esc", "cancels a running prediction"],
  ["P", "save a picture"],
];

class App {
  api = new Api();
  camera = new Camera();
  state = new PlanState();
  solving = new Solving(this.api);
  stage = new Stage(byId("picture-3d"), this.camera, () => this.views?.drawOver());
  views = new Views(this);
  sections = new Sections(this);
  predicting = new Predicting(this);
  plots = new Plots((arc) => this.mark(arc, false));
  tools = new Tools(this);

  session = null;
  scene = null;
  rest = null; // the vessels before the operation
  current = null; // the shown prediction
  kept = []; // {name, subject, origin, sceneId}
  placed = null; // the answer of api/place
  noResult = null; // the sentence why there is no prediction
  ruler = [];
  busy = false;
  dragging = false;
  hot = null;
  clip = false;
  size = 1;
  markedArc = null;
  axis = ""; // "vessel#branch" of the curves and the section
  #showPlan = () => {};

  get unitLength() {
    return this.scene?.units.length ?? "mm";
  }

  get editable() {
    return Boolean(this.scene?.editable && this.state.plan);
  }

  get stale() {
    return this.predicting.stale;
  }

  get outdated() {
    return this.predicting.outdated;
  }

  get cssOf() {
    return this.views.cssOf;
  }

  vesselText(name) {
    const part = this.scene?.vessels.find((vessel) => vessel.name === name)?.part;
    return plainName(name) + ({ svc: " (vein)", rpa: " (artery)" }[part] ?? "");
  }

  // --- sentences ---

  say(text) {
    byId("message").hidden = false;
    byId("message-text").textContent = text;
    clearTimeout(this.messageClock);
    this.messageClock = setTimeout(() => (byId("message").hidden = true), 9000);
  }

  complain(error) {
    if (error instanceof Unreachable) return; // said in the line at the top
    this.say(error.message);
  }

  // --- opening ---

  async start() {
    this.views.readTheme();
    this.stage.resize();
    this.stage.layout(2);
    this.#listen();
    try {
      this.session = await this.api.get("api/session");
      this.predicting.list(this.session.fidelities);
      await this.#show(await this.api.get("api/scene"));
    } catch (error) {
      byId("loading").textContent = error.message;
      if (this.session) this.#openDialog(error.message);
    }
  }

  // One after the other: the program has one scene open, and its vessels are asked for by name.
  open = newest((source) => this.#open(source));

  async #open(source) {
    byId("loading").hidden = false;
    byId("loading").textContent = `Reading ${source.name}…`;
    try {
      await this.solving.clear();
      await this.#show(await this.api.post("api/open", { id: source.id }));
    } catch (error) {
      this.complain(error);
      byId("loading").hidden = Boolean(this.scene);
      byId("loading").textContent = error.message;
    }
  }

  async #show(scene) {
    const failed = (error) => {
      this.complain(error);
      return null;
    };
    const rest = await loadRest(this.api, scene).catch(failed);
    const current = scene.result
      ? await loadResult(this.api, scene.result, scene, rest ?? { meshes: new Map() }).catch(failed)
      : null;
    if (!rest && !current) {
      byId("loading").textContent = "The vessels could not be read.";
      return;
    }
    Object.assign(this, {
      scene,
      rest,
      current: null,
      placed: null,
      noResult: null,
      ruler: [],
      markedArc: null,
    });
    this.size = sizeOf(rest ?? current);
    byId("scene-name").textContent = scene.name;
    const file = fileOf(this.session.sources.find(({ id }) => id === scene.id) ?? {});
    byId("scene-file").textContent = file ? `${file} · ` : "";
    document.title = `${scene.name}, Vasorod plan`;
    byId("loading").hidden = true;
    byId("why-not").hidden = scene.editable || !scene.why_not;
    byId("why-not").textContent = scene.why_not ?? "";
    byId("plan-controls").hidden = !scene.plan;
    if (scene.plan) this.#showPlan = planPanel(this.state, scene);
    byId("predict").hidden = scene.kind === "result";
    this.predicting.start();
    this.state.start(scene.plan);
    if (current) this.predicting.opened(current);
    this.axis = "";
    this.views.start(scene);
    this.resultChanged();
    this.tools.choose("plan");
    announce(`${scene.name} is open.`);
  }

  // --- what follows from changes ---

  planChanged() {
    const { state } = this;
    byId("undo").disabled = !state.canUndo;
    byId("redo").disabled = !state.canRedo;
    byId("lock").disabled = !this.editable;
    byId("lock").setAttribute("aria-pressed", String(state.locked));
    byId("lock").textContent = state.locked ? "Unlock plan" : "Lock plan";
    byId("save").disabled = !this.editable;
    this.#showPlan(state.plan, this.placed, this.#veinLength());
    this.tools.showHint();
    this.stage.draw();
  }

  #veinLength() {
    const vein = this.scene?.vessels.find(({ part }) => part === "svc");
    const axis = wayOf(vein, this.state.plan?.cut.route) ?? [];
    return axis.slice(1).reduce((sum, { point }, k) => sum + distance(point, axis[k].point), 0);
  }

  placeChanged() {
    const problem = this.placed?.problem ?? null;
    byId("problem").hidden = !problem;
    byId("problem").textContent = problem ?? "";
    this.planChanged();
    this.views.drawPlan();
  }

  resultChanged() {
    this.views.refresh();
  }

  /** Called by the views when what they show has changed. */
  shownChanged() {
    const { current, busy, stale, noResult, kept, scene } = this;
    const opened = scene?.kind === "result";
    showResult({
      subject: current,
      title: opened ? "Result" : "Prediction of this plan",
      stale,
      sentence: noResult,
      busy,
    });
    byId("keep-plan").disabled = !current || stale || busy;
    byId("keep-result").disabled = !current || stale || busy;
    const rows = kept.map((one) => ({
      ...one,
      name: `Plan ${one.name}`,
      choice: one.name,
      kept: true,
    }));
    if (current)
      rows.unshift({
        name: opened ? "This result" : "This plan",
        choice: "current",
        subject: current,
        instead: stale ? (busy ? "predicting…" : "earlier plan") : null,
      });
    showComparison(rows, {
      locked: this.state.locked || !this.editable,
      beside: ({ choice }) => this.#showBeside(choice),
      sceneId: scene?.id,
      use: ({ subject }) => this.state.set(structuredClone(subject.plan)),
      drop: ({ choice }) => this.#drop(choice),
    });
    this.#listAxes();
    this.#drawCurves();
    this.views.drawPlan();
    this.tools.refreshSection();
    this.tools.refreshRuler();
  }

  #showBeside(choice) {
    const { stage, views } = this;
    if (stage.count === 1) {
      if (stage.width >= 560) views.setCount(2);
      else return views.show(choice, 0);
    }
    // Two predictions are compared with each other; the vessels before give way.
    if (choice !== "current" && views.chosen[0] === "rest" && views.chosen[1] === "current")
      views.chosen[0] = "current";
    views.show(choice, 1);
  }

  keepPlan() {
    const { current, kept, scene, stale, busy } = this;
    if (!current || stale || busy) return;
    const taken = new Set(kept.map(({ name }) => name));
    let count = 0;
    while (taken.has(letterOf(count))) count++;
    const name = letterOf(count);
    this.kept = [
      ...kept,
      {
        name,
        subject: current,
        sceneId: scene.id,
        origin: scene.kind === "result" ? scene.name : "",
      },
    ];
    this.#hold(current.id, true);
    announce(`Kept as plan ${name}.`);
    this.#chooseTab("compare");
    this.views.refresh();
  }

  #drop(name) {
    const gone = this.kept.find((one) => one.name === name);
    this.kept = this.kept.filter((one) => one !== gone);
    if (gone && !this.kept.some(({ subject }) => subject === gone.subject))
      this.#hold(gone.subject.id, false);
    this.views.refresh();
  }

  // The program forgets old predictions; those that are kept here stay.
  #hold(result, hold) {
    this.api.post("api/hold", { result, hold }).catch(() => {});
  }

  // --- axes: curves and section ---

  /** The prediction whose axes are listed: the last one in the views. */
  axisSubject() {
    return this.views.curveResults().at(-1)?.subject ?? this.rest;
  }

  #pathsOf(subject) {
    if (subject?.kind === "result")
      return withAxis(subject.lines).map((line) => ({
        vessel: line.vessel,
        branch: line.branch ?? 0,
        arc: line.arc,
        points: line.point,
        rest: line.rest,
        line,
      }));
    const lines = withAxis(this.views.curveResults().at(-1)?.subject.lines ?? []);
    if (lines.length > 0)
      return lines.map((line) => ({
        vessel: line.vessel,
        branch: line.branch ?? 0,
        arc: line.arc,
        points: line.rest,
      }));
    return (this.scene?.vessels ?? [])
      .filter(({ axis }) => axis?.length > 1)
      .map(({ name, axis }) => {
        const points = axis.map(({ point }) => point);
        const arc = points.reduce(
          (sums, point, k) => [...sums, k === 0 ? 0 : sums[k - 1] + distance(point, points[k - 1])],
          [],
        );
        return { vessel: name, branch: 0, arc, points };
      });
  }

  axisPath(subject) {
    if (!subject) return null;
    return (
      this.#pathsOf(subject).find(({ vessel, branch }) => `${vessel}#${branch}` === this.axis) ??
      null
    );
  }

  axisVessel() {
    return this.axis.split("#")[0];
  }

  #listAxes() {
    const paths = this.#pathsOf(this.axisSubject());
    const names = paths.map(({ vessel, branch }) => `${vessel}#${branch}`);
    if (!names.includes(this.axis)) this.axis = names[0] ?? "";
    const count = (name) => paths.filter(({ vessel }) => vessel === name).length;
    const text = ({ vessel, branch }) =>
      this.vesselText(vessel) + (count(vessel) > 1 ? `, branch ${Number(branch) + 1}` : "");
    for (const id of ["axis-plots", "axis-section"])
      byId(id).replaceChildren(
        ...paths.map((path, k) =>
          make("option", { value: names[k], selected: names[k] === this.axis }, text(path)),
        ),
      );
  }

  chooseAxis(axis) {
    this.axis = axis;
    this.markedArc = null;
    this.#listAxes();
    this.#drawCurves();
    this.tools.refreshSection();
  }

  #nodeAt(subject, hit) {
    const paths = this.#pathsOf(subject).filter(({ vessel }) => vessel === hit.vessel);
    return nearestNode(paths, "points", hit.point);
  }

  /** The arc length of the axis nearest to a place on a wall, on the chosen axis if it is there. */
  arcAt(subject, hit) {
    const own = this.axisVessel() === hit.vessel ? this.axisPath(subject) : null;
    const found = own ? nearestNode([own], "points", hit.point) : this.#nodeAt(subject, hit);
    return found ? found.line.arc[found.node] : null;
  }

  /** Chooses the branch that was clicked and gives the arc length there; null without one. */
  chooseAxisAt(subject, hit) {
    const found = this.#nodeAt(subject, hit);
    if (!found) return null;
    this.chooseAxis(`${found.line.vessel}#${found.line.branch}`);
    return found.line.arc[found.node];
  }

  #drawCurves() {
    const lines = this.views
      .curveResults()
      .map(({ choice, subject }) => ({
        name: this.views.titleOf(choice),
        line: this.axisPath(subject)?.line,
        solved: this.views.meansSomething(subject),
      }))
      .filter(({ line }) => line);
    if (byId("curves").hidden) return;
    this.plots.show(lines, this.unitLength);
    byId("curve-key").replaceChildren(
      `over ${this.unitLength} along the axis`,
      ...(lines.length > 1
        ? lines.map(({ name }, k) => make("span", { class: `key${k}` }, name))
        : []),
    );
  }

  /** The same place in the views and in the curves. */
  mark(arc, fromViews) {
    if (arc === this.markedArc) return;
    this.markedArc = arc;
    if (fromViews && !byId("curves").hidden) this.plots.mark(arc);
    this.stage.draw();
  }

  // --- files ---

  async #openDialog(problem) {
    try {
      this.session = await this.api.get("api/session");
      showSources(
        this.session,
        this.scene?.id ?? this.session.current,
        (source) => this.open(source),
        problem,
      );
    } catch (error) {
      this.complain(error);
    }
  }

  #save() {
    askName({
      title: "Save plan",
      label: "File name",
      name: `${this.#plainTitle()}_plan.yaml`,
      mayOverwrite: true,
      fidelities: this.session.fidelities,
      fidelity: this.current?.fidelity ?? this.scene.fidelity,
      save: async (name, fidelity, overwrite) => {
        const file = name.endsWith(".yaml") ? name : `${name}.yaml`;
        const saved = await this.api.post("api/save", {
          name: file,
          plan: this.state.plan,
          fidelity,
          overwrite,
        });
        this.say([`Saved as ${saved.file}.`, saved.note].filter(Boolean).join(" "));
      },
    });
  }

  #keepResult() {
    // The one that is shown now: another prediction may end while the name is typed.
    const { id, fidelity } = this.current;
    askName({
      title: "Save result",
      label: "Folder name",
      name: `${this.#plainTitle()}_${fidelity}`,
      save: async (name) => {
        const { folder } = await this.api.post("api/keep", { result: id, name });
        this.say(`Saved in ${folder}, with its report.html.`);
      },
    });
  }

  async #picture() {
    const { stage, camera, views, scene } = this;
    if (!scene) return;
    const heads = stage.shown.map((_, k) => {
      const state = views.stateText(k);
      return views.titleOf(views.chosen[k]) + (state ? `, ${state[1]}` : "");
    });
    const note = `${scene.name}. ${this.session.program}. Research software, not for clinical use.`;
    const blob = await pictureOf(stage, camera, views.theme, views.overlay(), heads, note);
    download(blob, `${this.#plainTitle()}.png`);
  }

  /** The scene's name as a part of a file's name. */
  #plainTitle() {
    return this.scene.name.replace(/\.yaml$/, "").replace(/[^A-Za-z0-9_.-]+/g, "_");
  }

  // --- controls ---

  #chooseTab(name) {
    for (const one of ["compare", "curves"]) {
      const chosen = one === name;
      byId(one).hidden = !chosen;
      byId(`tab-${one}`).setAttribute("aria-selected", String(chosen));
      byId(`tab-${one}`).tabIndex = chosen ? 0 : -1;
    }
    byId("curve-axis").hidden = name !== "curves";
    this.#drawCurves();
  }

  #listen() {
    const on = (id, action) => byId(id).addEventListener("click", action);
    on("undo", () => this.state.undo());
    on("redo", () => this.state.redo());
    on("lock", () => this.#toggleLock());
    on("open", () => this.#openDialog(""));
    on("save", () => this.#save());
    on("keep-result", () => this.#keepResult());
    on("picture", () => this.#picture());
    on("help", () => byId("help-dialog").showModal());
    on("keep-plan", () => this.keepPlan());
    on("message-close", () => (byId("message").hidden = true));
    on("retry", () => this.#tryAgain());
    on("tab-compare", () => this.#chooseTab("compare"));
    on("tab-curves", () => this.#chooseTab("curves"));
    this.#chooseTab("compare");
    byId("tab-compare").parentElement.addEventListener("keydown", ({ key }) => {
      if (key !== "ArrowLeft" && key !== "ArrowRight") return;
      const next = byId("compare").hidden ? "compare" : "curves";
      this.#chooseTab(next);
      byId(`tab-${next}`).focus();
    });
    byId("help-list").replaceChildren(
      ...keys.flatMap(([key, text]) => [make("dt", {}, key), make("dd", {}, text)]),
    );
    document.addEventListener("keydown", (event) => this.#key(event));
    this.api.addEventListener("lost", () => {
      byId("lost").hidden = false;
      this.#measureHead();
      this.lostClock = setInterval(() => this.#tryAgain(), 3000);
    });
    this.api.addEventListener("found", () => {
      clearInterval(this.lostClock);
      byId("lost").hidden = true;
      this.#measureHead();
      this.#resume();
    });
    new ResizeObserver(() => this.#measureHead()).observe(document.querySelector("header"));
    for (const id of ["lost", "message"])
      new ResizeObserver(() => this.#measureHead()).observe(byId(id));
  }

  // The three columns fill what the head leaves of the window.
  #measureHead() {
    const top = document.querySelector("main").getBoundingClientRect().top + window.scrollY;
    document.documentElement.style.setProperty("--top", `${top}px`);
  }

  #tryAgain() {
    return this.api.get("api/session").catch(() => {});
  }

  #resume() {
    if (this.scene) this.predicting.resume();
    else location.reload();
  }

  #toggleLock() {
    if (!this.editable) return;
    this.state.lock(!this.state.locked);
    this.shownChanged();
    announce(this.state.locked ? "The plan is locked." : "The plan can be changed.");
  }

  #key(event) {
    if (document.querySelector("dialog[open]")) return;
    const { key, ctrlKey, metaKey, shiftKey, altKey, target } = event;
    const typing = target.matches("input[type=number], input:not([type]), select");
    if ((ctrlKey || metaKey) && !altKey && key.toLowerCase() === "z" && !typing) {
      if (shiftKey) this.state.redo();
      else this.state.undo();
    } else if ((ctrlKey || metaKey) && key.toLowerCase() === "y" && !typing) this.state.redo();
    else if (ctrlKey || metaKey || altKey || typing) return;
    else if (key === "Escape") {
      if (this.solving.running) this.predicting.cancel();
      else this.tools.choose("plan");
    } else if (target.matches("input[type=range]") && /^\d$/.test(key)) return;
    else if ("123".includes(key)) this.views.lookFrom(Number(key) - 1);
    else if (key === "0") this.views.resetView();
    else if (key === "l") this.#toggleLock();
    else if (key === "k") this.keepPlan();
    else if (key === "r") this.tools.choose("ruler");
    else if (key === "s") this.tools.choose("section");
    else if (key === "p") this.#picture();
    else if (key === "b") this.#beforeOrAfter();
    else if (key === "?") byId("help-dialog").showModal();
    else return;
    event.preventDefault();
  }

  #beforeOrAfter() {
    if (this.stage.count === 2) this.views.setCount(1);
    this.views.show(this.views.chosen[0] === "rest" ? "current" : "rest", 0);
  }
}

// Lines of a folder that was read may lack their arc lengths.
const withAxis = (lines) => lines.filter(({ arc, point, rest }) => arc && point && rest);

/** The axis of a vessel on a way (a pair of its ends); without one that of the scene. */
function wayOf(vessel, route) {
  if (!vessel) return null;
  const same = (one) => JSON.stringify(one.route) === JSON.stringify(route);
  return (route && vessel.routes?.find(same)?.axis) ?? vessel.axis;
}

function sizeOf(subject) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const { points } of subject.meshes.values())
    for (let i = 0; i < points.length; i++) {
      low[i % 3] = Math.min(low[i % 3], points[i]);
      high[i % 3] = Math.max(high[i % 3], points[i]);
    }
  return norm(sub(high, low));
}

new App().start();
