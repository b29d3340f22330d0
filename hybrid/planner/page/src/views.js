// What the views show: subjects, colours, transparency, legend, and the drawing over them.
import { colourValues, cssColour, parts, vesselColours } from "./colours.js";
import { byId, make, themeColour } from "./dom.js";
import { ballAbout, tubeAbout } from "./geometry.js";
import { drawOverlay } from "./overlay.js";
import { somePoints } from "./subjects.js";
import { nodeAt } from "./plots.js";
import { across, cross, dot, norm, sub, unit } from "./vectors.js";
import { fidelityText, isSolution, numberText, plainName, stateOf } from "./words.js";

const markerColours = { cut: [1, 0.69, 0], incision: [0, 0.76, 0.66], problem: [0.85, 0.15, 0.15] };
const standing = 0.35; // opacity of what lies beside the joined vessels, as in report.html

// Directions of the three buttons: towards the eye and up, for each space.
const viewsOf = {
  LPS: [
    ["Front", [0, -1, 0], [0, 0, 1]],
    ["Left", [1, 0, 0], [0, 0, 1]],
    ["Top", [0, 0, 1], [0, -1, 0]],
  ],
  RAS: [
    ["Front", [0, 1, 0], [0, 0, 1]],
    ["Left", [-1, 0, 0], [0, 0, 1]],
    ["Top", [0, 0, 1], [0, 1, 0]],
  ],
  "": [
    ["+X", [1, 0, 0], [0, 0, 1]],
    ["−Y", [0, -1, 0], [0, 0, 1]],
    ["+Z", [0, 0, 1], [0, 1, 0]],
  ],
};

export class Views {
  #app;
  field = "vessel";
  range = null; // two numbers where it is fixed
  visible = new Map();
  opacity = new Map();
  colours = new Map();
  chosen = ["rest", "current"]; // what the views show: rest, current or the name of a kept plan
  theme = {};

  constructor(app) {
    this.#app = app;
    const dark = matchMedia("(prefers-color-scheme: dark)");
    dark.addEventListener("change", () => this.readTheme());
    for (const k of [0, 1])
      byId(`head-${k}`).firstElementChild.addEventListener("change", (event) => {
        this.chosen[k] = event.target.value;
        this.refresh();
      });
    byId("one-view").addEventListener("click", () => this.setCount(1));
    byId("two-views").addEventListener("click", () => this.setCount(2));
    byId("colour").addEventListener("change", (event) => this.setField(event.target.value));
    byId("range-auto").addEventListener("change", (event) => {
      this.range = event.target.checked ? null : this.#commonRange();
      this.#showRange();
      this.paint();
    });
    for (const id of ["range-low", "range-high"])
      byId(id).addEventListener("change", () => {
        const range = [byId("range-low").valueAsNumber, byId("range-high").valueAsNumber];
        if (range[1] > range[0]) this.range = range;
        this.#showRange();
        this.paint();
      });
    for (const k of [0, 1, 2]) byId(`view-${k}`).addEventListener("click", () => this.lookFrom(k));
    byId("view-reset").addEventListener("click", () => this.resetView());
  }

  readTheme() {
    const { stage } = this.#app;
    const [ground, ink, soft, line, accent] = [
      "--stage",
      "--ink",
      "--soft",
      "--line",
      "--accent",
    ].map(themeColour);
    this.theme = { ground, ink, soft, line, accent };
    stage.setBackground(parts(parseInt(ground.slice(1), 16)));
    this.#nameCubes();
    stage.draw();
  }

  #nameCubes() {
    const [paper, ink, edge] = ["--card", "--ink", "--edge"].map(themeColour);
    this.#app.stage.setCubes(this.#app.scene?.space ?? "", { paper, ink, edge });
  }

  /** A scene was opened: its vessels, their colours and the first view. */
  start(scene) {
    const joined = scene.vessels.some(({ part }) => part);
    this.colours = vesselColours(scene.vessels);
    this.visible = new Map(scene.vessels.map(({ name }) => [name, true]));
    const glass = ({ part, role }) => (joined ? !part : role === "obstacle");
    this.opacity = new Map(
      scene.vessels.map((vessel) => [vessel.name, glass(vessel) ? standing : 1]),
    );
    viewsOf[scene.space]?.forEach(([title], k) => {
      byId(`view-${k}`).textContent = title;
      byId(`view-${k}`).setAttribute("aria-label", `View: ${title}`);
    });
    this.#nameCubes();
    this.#listVessels(scene);
    this.chosen = scene.kind === "result" ? ["current", "rest"] : ["rest", "current"];
    this.refresh();
    this.resetView();
  }

  #listVessels(scene) {
    byId("vessels").replaceChildren(
      ...scene.vessels.map(({ name }) => {
        const title = this.#app.vesselText(name);
        const box = make("input", {
          type: "checkbox",
          checked: true,
          change: () => {
            this.visible.set(name, box.checked);
            this.paint();
          },
        });
        const slider = make("input", {
          type: "range",
          min: 0,
          max: 100,
          step: 1,
          value: Math.round(100 * (1 - this.opacity.get(name))),
          "aria-label": `Transparency of ${title}, percent`,
          title: "Transparency",
          input: () => {
            this.opacity.set(name, 1 - slider.valueAsNumber / 100);
            this.paint();
          },
        });
        const dot = make("span", { class: "dot", style: `background:${this.cssOf(name)}` });
        return make("div", { class: "vessel" }, make("label", {}, box, dot, title), slider);
      }),
    );
    byId("vessels").prepend(
      make(
        "div",
        { class: "vessel soft small", "aria-hidden": "true" },
        make("span", {}, "Shown"),
        make("span", {}, "Transparency"),
      ),
    );
  }

  cssOf = (name) => cssColour(this.#colourOf(name));

  // A stump has the colour of its vessel.
  #colourOf(name) {
    return this.colours.get(name) ?? this.colours.get(this.#owner(name)) ?? 0xb0b0b0;
  }

  #owner(name) {
    return name.replace(/[ _]stump$/, "");
  }

  /** Names of the vessels that are drawn; only those that hide what is behind them if `solid`. */
  shownNames(subject, solid = false) {
    return new Set(
      [...(subject?.meshes.keys() ?? [])].filter((name) => {
        const owner = this.#owner(name);
        return (
          (this.visible.get(owner) ?? true) && (!solid || (this.opacity.get(owner) ?? 1) > 0.6)
        );
      }),
    );
  }

  // --- what is shown ---

  subjectOf(choice) {
    const { rest, current, kept } = this.#app;
    if (choice === "rest") return rest;
    if (choice === "current") return current;
    return kept.find(({ name }) => name === choice)?.subject ?? null;
  }

  /** The predictions in the views, without doubles: [{choice, subject, pane}]. */
  shownResults() {
    const { stage } = this.#app;
    return stage.shown
      .map((pane, k) => ({ choice: this.chosen[k], subject: pane.subject, pane }))
      .filter(
        ({ subject }, k, all) =>
          subject?.kind === "result" && all.findIndex((one) => one.subject === subject) === k,
      );
  }

  /** The predictions whose curves are drawn: those in the views, else the present one. */
  curveResults() {
    const shown = this.shownResults();
    const { current } = this.#app;
    return shown.length > 0 || !current ? shown : [{ choice: "current", subject: current }];
  }

  titleOf(choice) {
    if (choice === "rest") return "Before";
    if (choice === "current") return this.#app.scene?.kind === "result" ? "Result" : "After";
    return `Plan ${choice}`;
  }

  setCount(count) {
    this.#app.stage.layout(count);
    this.refresh();
    this.resetView(false);
  }

  show(choice, k = 1) {
    const { stage } = this.#app;
    if (k === 1 && stage.count === 1) k = 0;
    this.chosen[k] = choice;
    this.refresh();
  }

  /** Puts the chosen subjects into the views and everything that follows from it. */
  refresh() {
    const { stage, kept, scene, rest } = this.#app;
    const choices = [
      ...(rest ? ["rest"] : []),
      ...(scene ? ["current"] : []),
      ...kept.map(({ name }) => name),
    ];
    stage.panes.forEach((pane, k) => {
      if (!choices.includes(this.chosen[k]))
        this.chosen[k] = choices[Math.min(k, choices.length - 1)] ?? "rest";
      const shown = k < stage.count;
      const head = byId(`head-${k}`);
      head.hidden = !shown;
      head.firstElementChild.replaceChildren(
        ...choices.map((choice) =>
          make(
            "option",
            { value: choice, selected: choice === this.chosen[k] },
            this.#choiceText(choice),
          ),
        ),
      );
      pane.setSubject(shown ? this.subjectOf(this.chosen[k]) : null);
    });
    byId("one-view").setAttribute("aria-pressed", String(stage.count === 1));
    byId("two-views").setAttribute("aria-pressed", String(stage.count === 2));
    this.#badges();
    this.#listFields();
    this.paint();
    this.#app.shownChanged();
  }

  #choiceText(choice) {
    const { kept } = this.#app;
    if (choice === "rest") return "Before";
    const origin = kept.find(({ name }) => name === choice)?.origin;
    return this.titleOf(choice) + (origin ? ` (${origin})` : "");
  }

  #badges() {
    const { stage } = this.#app;
    stage.panes.forEach((pane, k) => {
      const badge = byId(`head-${k}`).lastElementChild;
      const text = this.stateText(k);
      badge.hidden = !text || k >= stage.count;
      badge.textContent = text?.[1] ?? "";
      badge.className = `badge ${text?.[0] ?? ""}`;
    });
  }

  /** What a view's head says of the state of what it shows: [mark, words] or null. */
  stateText(k) {
    const { busy, stale, current, noResult } = this.#app;
    const missing = noResult && (stale || !current);
    const choice = this.chosen[k];
    const subject = this.subjectOf(choice);
    if (choice === "rest") return null;
    if (choice === "current" && busy) return ["plain", "predicting…"];
    if (choice === "current" && missing)
      return ["bad", current ? "no prediction; earlier plan shown" : "no prediction"];
    if (choice === "current" && stale && current) return ["warn", "earlier plan"];
    if (!subject) return ["plain", "no prediction yet"];
    const [mark, words] = stateOf(subject.json);
    return [mark, `${fidelityText(subject.json.fidelity)}: ${words}`];
  }

  // --- colours ---

  setField(name) {
    this.field = name;
    this.range = null;
    byId("range-auto").checked = true;
    this.#showRange();
    this.paint();
  }

  #listFields() {
    const fields = new Map();
    for (const { subject } of this.shownResults())
      for (const field of subject.fields.values()) fields.set(field.name, field);
    if (this.field !== "vessel" && fields.size > 0 && !fields.has(this.field))
      this.field = "vessel";
    byId("colour").replaceChildren(
      make("option", { value: "vessel", selected: this.field === "vessel" }, "Vessels"),
      ...[...fields.values()].map(({ name, title, unit }) =>
        make("option", { value: name, selected: name === this.field }, fieldText(title, unit)),
      ),
    );
    this.#showRange();
  }

  #fieldShown() {
    return this.shownResults()
      .map(({ subject }) => subject.fields.get(this.field))
      .find(Boolean);
  }

  #commonRange() {
    const ranges = this.shownResults()
      .map(({ subject }) => subject.fields.get(this.field)?.range)
      .filter(Boolean);
    if (ranges.length === 0) return [0, 1];
    return [Math.min(...ranges.map(([low]) => low)), Math.max(...ranges.map(([, high]) => high))];
  }

  #showRange() {
    const field = this.#fieldShown();
    byId("range-auto").parentElement.hidden = !field;
    byId("range-numbers").hidden = !field || this.range === null;
    if (!field || !this.range) return;
    const [low, high] = this.range;
    byId("range-low").value = String(Number(low.toPrecision(4)));
    byId("range-high").value = String(Number(high.toPrecision(4)));
    byId("range-unit").textContent = field.unit ?? "";
  }

  /** Not of a state that is no solution, and not of an earlier plan. */
  meansSomething(subject) {
    const { current, outdated } = this.#app;
    return isSolution(subject.json.status) && !(subject === current && outdated);
  }

  // Numbers that say nothing are grey.
  mapOf(subject, field) {
    return this.meansSomething(subject) ? field.map : "grey";
  }

  paint() {
    const { stage } = this.#app;
    const range = this.range ?? this.#commonRange();
    for (const pane of stage.shown) {
      const field = pane.subject?.kind === "result" ? pane.subject.fields.get(this.field) : null;
      for (const [name, body] of pane.bodies) {
        const values = field?.values.get(name);
        if (values)
          body.paintVertices(colourValues(values, this.mapOf(pane.subject, field), range));
        else body.paint(field ? [0.8, 0.8, 0.8] : parts(this.#colourOf(name)));
        const owner = this.#owner(name);
        body.show(this.visible.get(owner) ?? true, this.opacity.get(owner) ?? 1);
      }
    }
    const field = this.#fieldShown();
    byId("legend-text").textContent = field
      ? `Colours: ${fieldText(field.title, field.unit)}, ` +
        `from ${numberText(range[0])} to ${numberText(range[1])}.`
      : "Colours: one for each vessel.";
    stage.draw();
  }

  #legendOf(pane) {
    const field = pane.subject?.kind === "result" ? pane.subject.fields.get(this.field) : null;
    if (!field) return null;
    const map = this.mapOf(pane.subject, field);
    const lines = [field.unit ? `${capital(field.title)}, ${field.unit}` : capital(field.title)];
    if (map === "grey")
      lines.push(isSolution(pane.subject.json.status) ? "earlier plan" : "no solution");
    return { map, range: this.range ?? this.#commonRange(), lines };
  }

  // --- camera ---

  lookFrom(k) {
    const { camera, scene } = this.#app;
    const [, eye, up] = (viewsOf[scene?.space] ?? viewsOf[""])[k];
    camera.look(eye, up);
    this.resetView(false);
  }

  /** Everything of interest in the view; `turn`: also from the first side. */
  resetView(turn = true) {
    const { camera, stage, scene, rest } = this.#app;
    const subject = stage.shown.map(({ subject: one }) => one).find(Boolean) ?? rest;
    if (!subject || !scene) return;
    const all = [...somePoints(subject), ...(rest ? somePoints(rest) : [])];
    const low = [0, 1, 2].map((k) => Math.min(...all.map((p) => p[k])));
    const high = [0, 1, 2].map((k) => Math.max(...all.map((p) => p[k])));
    camera.centre = low.map((x, k) => (x + high[k]) / 2);
    camera.reach = 0.6 * norm(sub(high, low));
    if (turn) camera.look(...this.#firstSide(scene));
    const joined = scene.vessels.filter(({ part }) => part).map(({ name }) => name);
    const names = new Set(
      joined.length > 0
        ? joined
        : scene.vessels.filter(({ role }) => role !== "obstacle").map(({ name }) => name),
    );
    const { rect } = stage.panes[0];
    const room = this.field === "vessel" ? 1 : 1 - Math.min(0.4, 130 / rect.width); // legend
    camera.fit(
      stage.shown.filter((pane) => pane.subject).flatMap((pane) => somePoints(pane.subject, names)),
      room * (rect.width / rect.height),
    );
    stage.draw();
  }

  // The front where the space is known. Else the kept end of the vein is up, and the way along the
  // artery, which goes to the patient's right lung, runs to the left: that is the front as well.
  #firstSide(scene) {
    if (scene.space) return viewsOf[scene.space][0].slice(1);
    const axisOf = (part) =>
      scene.vessels.find((vessel) => vessel.part === part)?.axis?.map(({ point }) => point) ?? [];
    const [vein, artery] = [axisOf("svc"), axisOf("rpa")];
    if (vein.length < 2 || artery.length < 2)
      return [
        [0, -1, 0],
        [0, 0, 1],
      ];
    const up = unit(sub(vein[0], vein.at(-1)));
    // The axis of the body in most data sets: near enough, it keeps the picture upright.
    const upright = Math.abs(up[2]) > 0.8 ? [0, 0, Math.sign(up[2])] : up;
    const eye = cross(upright, sub(artery.at(-1), artery[0]));
    return [norm(eye) > 0 ? eye : across(upright), upright];
  }

  // --- drawing over the views ---

  /** Markers and outlines of the plan in the views of the vessels before the operation. */
  drawPlan() {
    const { stage, placed, size } = this.#app;
    for (const pane of stage.panes) {
      const outlines = [];
      if (pane.subject?.kind === "rest" && placed?.cut) {
        const radius = 0.0022 * size;
        for (const [name, part] of [
          ["cut", placed.cut],
          ["incision", placed.incision],
        ]) {
          if (!part) continue;
          const colour = placed.problem ? markerColours.problem : markerColours[name];
          if (part.outline?.length > 1)
            outlines.push({
              mesh: tubeAbout(part.outline, radius, name === "cut" && !ends(part.outline)),
              colour,
            });
          outlines.push({ mesh: ballAbout(part.point, 2.2 * radius), colour });
        }
      }
      pane.setExtra("plan", outlines);
    }
    stage.draw();
  }

  // Whether a solid wall lies in front of a point of a wall.
  #hides(pane, point) {
    const { camera, size } = this.#app;
    const origin = camera.position;
    const way = sub(point, origin);
    const hit = pane.hit({ origin, direction: unit(way) }, this.shownNames(pane.subject, true));
    return Boolean(hit) && hit.distance < norm(way) - 0.012 * size;
  }

  // The cut goes around the vein: its marker is where the viewer sees it.
  #nearSide({ point, outline }) {
    const { eye } = this.#app.camera;
    const nearer = (a, b) => (dot(b, eye) > dot(a, eye) ? b : a);
    return outline?.length > 0 ? outline.reduce(nearer) : point;
  }

  markersIn(pane) {
    const { placed, hot, markedArc, editable } = this.#app;
    const markers = [];
    if (pane.subject?.kind === "rest" && placed?.cut && editable) {
      markers.push({
        name: "cut",
        point: this.#nearSide(placed.cut),
        label: "Cut",
        colour: "#ffb000",
        hot: hot === "cut",
      });
      if (placed.incision)
        markers.push({
          name: "incision",
          point: placed.incision.point,
          label: "Incision",
          colour: "#00c2a8",
          hot: hot === "incision",
        });
    }
    for (const marker of markers) marker.hidden = this.#hides(pane, marker.point);
    const path = markedArc === null ? null : this.#app.axisPath(pane.subject);
    if (path)
      markers.push({
        point: path.points[nodeAt(path, markedArc)],
        label: `${numberText(markedArc)} ${this.#app.unitLength}`,
        colour: this.theme.accent,
      });
    return markers;
  }

  overlay() {
    const { stage, unitLength, ruler } = this.#app;
    return {
      unit: unitLength,
      panes: stage.panes.map((pane) => ({
        markers: this.markersIn(pane),
        ruler: ruler.filter((one) => one.subject === pane.subject).map(({ point }) => point),
        legend: this.#legendOf(pane),
      })),
    };
  }

  drawOver() {
    const { stage, camera, scene } = this.#app;
    const canvas = byId("over");
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [Math.round(stage.width * ratio), Math.round(stage.height * ratio)];
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    const context = canvas.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, stage.width, stage.height);
    if (scene) drawOverlay(context, stage, camera, this.theme, this.overlay());
    stage.shown.forEach(({ rect }, k) => {
      Object.assign(byId(`head-${k}`).style, {
        left: `${rect.x + 8}px`,
        top: `${rect.y + 8}px`,
        maxWidth: `${rect.width - 16}px`,
      });
    });
  }
}

const ends = (outline) => norm(sub(outline[0], outline.at(-1))) < 1e-9;
const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);
export const fieldText = (title, unit) => capital(plainName(title)) + (unit ? `, ${unit}` : "");
