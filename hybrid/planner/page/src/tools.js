// What clicks, drags and the pointer do in the views: setting the plan, ruler, section, values.
import { announce, byId } from "./dom.js";
import { valueAt } from "./geometry.js";
import { newest } from "./newest.js";
import { nodeAt } from "./plots.js";
import { followPointers } from "./pointers.js";
import { planeAt } from "./section.js";
import { distance } from "./vectors.js";
import { numberText, plainName } from "./words.js";

const hints = {
  plan:
    "Click the vein to place the cut, the artery to place the incision; drag the two markers. " +
    "Drag elsewhere to turn, wheel or pinch to zoom, Shift and drag to move.",
  locked: "The plan is locked. Drag to turn, wheel or pinch to zoom, Shift and drag to move.",
  fixed: "Drag to turn, wheel or pinch to zoom, Shift and drag to move.",
  ruler: "Click two points on the vessels to measure between them.",
  section: "Click a vessel to cut it there, or move the slider under Section.",
};

export class Tools {
  #app;
  tool = "plan";
  #section = null; // {arc}
  #inside = false; // whether the pointer is over the views and turns nothing

  constructor(app) {
    this.#app = app;
    const { stage, camera } = app;
    const surface = byId("surface");
    this.pick = newest((...request) => this.#pick(...request));
    const hover = newest((...request) => this.#hover(...request));
    followPointers(surface, stage, camera, {
      grab: (pane, x, y, touch) => this.#markerAt(pane, x, y, touch ? 28 : 15),
      drag: (name, pane, x, y) => {
        app.dragging = true;
        this.pick(name, pane, x, y);
      },
      drop: async (name) => {
        await this.pick.idle();
        app.dragging = false;
        app.state.commit();
        if (name) this.#heat(null);
      },
      click: (pane, x, y) => this.#click(pane, x, y),
      hover: (pane, x, y) => {
        this.#inside = true;
        hover(pane, x, y);
      },
      leave: () => {
        this.#inside = false;
        this.#leave();
      },
    });
    for (const name of ["plan", "ruler", "section"])
      byId(`tool-${name}`).addEventListener("click", () => this.choose(name));
    for (const id of ["section-at", "section-slider"])
      byId(id).addEventListener("input", (event) => {
        if (Number.isFinite(event.target.valueAsNumber)) this.cutAt(event.target.valueAsNumber);
      });
    byId("section-clip").addEventListener("change", (event) => {
      app.clip = event.target.checked;
      this.refreshSection();
    });
    for (const id of ["axis-plots", "axis-section"])
      byId(id).addEventListener("change", (event) => app.chooseAxis(event.target.value));
    this.showHint();
  }

  choose(name) {
    this.tool = name;
    for (const one of ["plan", "ruler", "section"])
      byId(`tool-${one}`).setAttribute("aria-pressed", String(one === name));
    byId("ruler-panel").hidden = name !== "ruler";
    byId("section-panel").hidden = name !== "section";
    if (name !== "ruler") this.#app.ruler = [];
    this.#showRuler();
    if (name === "section" && !this.#section) this.#section = this.#middle();
    this.refreshSection();
    this.showHint();
    this.#app.stage.draw();
  }

  showHint() {
    const { editable, state } = this.#app;
    const plan = state.locked ? "locked" : editable ? "plan" : "fixed";
    byId("hint").textContent = hints[this.tool === "plan" ? plan : this.tool];
  }

  // --- the plan ---

  #markerAt(pane, x, y, near) {
    const { editable, state, stage, views } = this.#app;
    if (!editable || state.locked || this.tool !== "plan") return null;
    let best = null;
    let least = near;
    for (const { name, point } of views.markersIn(pane)) {
      if (!name) continue;
      const [px, py] = stage.project(pane, point);
      const away = Math.hypot(px - x, py - y);
      if (away < least) [best, least] = [name, away];
    }
    if (best) this.#heat(best);
    return best;
  }

  #heat(name) {
    if (this.#app.hot === name) return;
    this.#app.hot = name;
    byId("surface").classList.toggle("on-marker", name !== null);
    this.#app.stage.draw();
  }

  // A marker stays on its own vessel; a click takes the vessel that is seen there.
  async #pick(marker, pane, x, y) {
    const { api, stage, scene, state, views } = this.#app;
    const own = scene.vessels.find(({ part }) => part === (marker === "cut" ? "svc" : "rpa"))?.name;
    const vessels = marker ? [own] : [...views.shownNames(pane.subject, true)];
    let hit;
    try {
      ({ hit } = await api.post("api/pick", { ...stage.rayAt(pane, x, y), vessels, result: null }));
    } catch (error) {
      this.#app.complain(error);
      return;
    }
    if (!hit || scene !== this.#app.scene) return;
    if (!hit.part) {
      this.#app.say(
        `That is the ${plainName(hit.vessel)}. ` +
          "The cut goes on the vein, the incision on the artery.",
      );
      return;
    }
    if (hit.along === null) {
      this.#app.say("The operation cannot be placed there: it is off the vessel's main way.");
      return;
    }
    // A place on another branch names its way; without one it is on the scene's.
    const route = hit.route ? { route: hit.route } : {};
    if (hit.part === "svc") state.preview({ cut: { along: hit.along, ...route } });
    else state.preview({ incision: { along: hit.along, around_deg: hit.around_deg, ...route } });
    if (!marker) {
      state.commit();
      announce(hit.part === "svc" ? "The cut was placed." : "The incision was placed.");
    }
  }

  // --- clicks ---

  #click(pane, x, y) {
    const { editable, state, views, stage } = this.#app;
    const hit = pane.hit(stage.rayAt(pane, x, y), views.shownNames(pane.subject, true));
    if (this.tool === "ruler") this.#measure(pane, hit);
    else if (this.tool === "section") this.#cutThrough(pane, hit);
    else if (pane.subject?.kind === "rest" && editable) {
      if (state.locked) this.#app.say("The plan is locked; unlock it to change it.");
      else this.pick(null, pane, x, y);
    } else if (hit) this.#app.chooseAxisAt(pane.subject, hit);
  }

  #measure(pane, hit) {
    if (!hit) return;
    const { ruler } = this.#app;
    const begin = ruler.length !== 1 || ruler[0].subject !== pane.subject;
    this.#app.ruler = [...(begin ? [] : ruler), { subject: pane.subject, point: hit.point }];
    this.#showRuler();
    this.#app.stage.draw();
  }

  /** A length between points that are no longer shown would be one of nothing. */
  refreshRuler() {
    const app = this.#app;
    app.ruler = app.ruler.filter(({ subject }) =>
      app.stage.shown.some((pane) => pane.subject === subject),
    );
    this.#showRuler();
  }

  #showRuler() {
    const { ruler, unitLength } = this.#app;
    const [a, b] = ruler;
    byId("ruler-text").textContent = b
      ? `${numberText(distance(a.point, b.point), 4)} ${unitLength} in a straight line.`
      : a
        ? "Click the second point."
        : "Click two points on the vessels.";
  }

  // --- section ---

  #middle() {
    const path = this.#app.axisPath(this.#app.axisSubject());
    return path ? { arc: path.arc.at(-1) / 2 } : null;
  }

  #cutThrough(pane, hit) {
    if (!hit) return;
    const arc = this.#app.chooseAxisAt(pane.subject, hit);
    if (arc === null)
      this.#app.say(`The axis of the ${this.#app.vesselText(hit.vessel)} is not known there.`);
    else this.cutAt(arc);
  }

  cutAt(arc) {
    this.#section = { arc };
    this.refreshSection();
  }

  refreshSection() {
    const app = this.#app;
    const longest = app.axisPath(app.axisSubject());
    const on = this.tool === "section" && longest && this.#section;
    if (on) {
      const most = longest.arc.at(-1);
      this.#section.arc = Math.min(most, Math.max(0, this.#section.arc));
      for (const id of ["section-at", "section-slider"]) {
        byId(id).max = String(most);
        if (document.activeElement !== byId(id) || id === "section-slider")
          byId(id).value = this.#section.arc.toFixed(2);
      }
      byId("section-at-unit").textContent = app.unitLength;
    }
    app.sections.show(
      app.stage.panes.map((pane, k) => {
        const path = on && k < app.stage.count ? app.axisPath(pane.subject) : null;
        if (!path) return null;
        const plane = planeAt(path.points, nodeAt(path, this.#section.arc));
        return {
          plane,
          result: pane.subject.kind === "result" ? pane.subject.id : null,
          title: app.views.titleOf(app.views.chosen[k]),
        };
      }),
    );
  }

  // --- the pointer over a vessel ---

  async #hover(pane, x, y) {
    // One look for each frame: a mouse may move far more often.
    await new Promise(requestAnimationFrame);
    if (!this.#inside) return;
    const { stage, views, state, editable } = this.#app;
    const surface = byId("surface");
    this.#heat(null);
    if (this.#markerAt(pane, x, y, 15)) {
      byId("tip").hidden = true;
      return;
    }
    const hit = pane.hit(stage.rayAt(pane, x, y), views.shownNames(pane.subject, true));
    surface.classList.toggle(
      "over",
      Boolean(hit) &&
        (this.tool !== "plan" || (pane.subject?.kind === "rest" && editable && !state.locked)),
    );
    if (!hit) {
      this.#leave();
      return;
    }
    const lines = [this.#app.vesselText(hit.vessel)];
    if (pane.subject.kind === "result") {
      const field = pane.subject.fields.get(views.field);
      const values = field?.values.get(hit.vessel);
      const meant = field && views.mapOf(pane.subject, field) !== "grey";
      if (values) {
        const number = numberText(valueAt(values, hit.mesh.triangles, hit));
        const value = meant ? `${number} ${field.unit ?? ""}`.trim() : "unknown";
        lines.push(`${capital(plainName(field.title))}: ${value}`);
      }
    }
    const arc = this.#app.arcAt(pane.subject, hit);
    if (arc !== null) lines.push(`${numberText(arc)} ${this.#app.unitLength} along the axis`);
    this.#tip(lines.join("\n"), x, y);
    this.#app.mark(arc !== null && this.#app.axisVessel() === hit.vessel ? arc : null, true);
  }

  #tip(text, x, y) {
    const tip = byId("tip");
    tip.hidden = false;
    tip.textContent = text;
    const { stage } = this.#app;
    const [width, height] = [tip.offsetWidth, tip.offsetHeight];
    tip.style.left = `${Math.max(4, x + 16 + width > stage.width ? x - 12 - width : x + 16)}px`;
    tip.style.top = `${Math.max(4, Math.min(y + 12, stage.height - height - 4))}px`;
  }

  #leave() {
    byId("tip").hidden = true;
    byId("surface").classList.remove("over");
    this.#app.mark(null, true);
  }
}

const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);
