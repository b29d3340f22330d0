// The cutting plane across a vessel: its outline in the views, and the areas it cuts.
import { byId, columnHead, make, tableOf } from "./dom.js";
import { tubeAbout } from "./geometry.js";
import { newest } from "./newest.js";
import { across, cross, dot, sub, times, unit } from "./vectors.js";
import { numberText, plainName } from "./words.js";

/** The plane across a polyline at a node. */
export function planeAt(path, node) {
  const before = path[Math.max(node - 1, 0)];
  const after = path[Math.min(node + 1, path.length - 1)];
  return { point: path[node], normal: unit(sub(after, before)) };
}

// The outline flat on the page; `colourOf` gives a vessel's colour.
function flatOutline(cut, plane, colourOf) {
  const side = across(plane.normal);
  const other = cross(plane.normal, side);
  const flat = cut.vessels.flatMap(({ name, loops, closed }) =>
    loops.map((loop, k) => ({
      name,
      closed: closed[k],
      path: loop.map((point) => [
        dot(sub(point, plane.point), side),
        -dot(sub(point, plane.point), other),
      ]),
    })),
  );
  const all = flat.flatMap(({ path }) => path);
  if (all.length === 0) return "";
  const low = [0, 1].map((k) => Math.min(...all.map((p) => p[k])));
  const high = [0, 1].map((k) => Math.max(...all.map((p) => p[k])));
  const size = Math.max(high[0] - low[0], high[1] - low[1]) || 1;
  const pad = 0.05 * size;
  return make(
    "svg",
    {
      viewBox: [...low.map((x) => x - pad), ...high.map((x, k) => x - low[k] + 2 * pad)].join(" "),
      role: "img",
      "aria-label": "Outline of the section",
      class: "outline",
    },
    flat.map(({ name, path, closed }) =>
      make("path", {
        d: `M${path.map((p) => p.map((x) => x.toFixed(3))).join("L")}${closed ? "Z" : ""}`,
        fill: "none",
        stroke: colourOf(name),
        "stroke-width": 0.015 * size,
        "stroke-linejoin": "round",
      }),
    ),
  );
}

/** Asks for the section of a pane and shows it there; `app` is the page. */
export class Sections {
  #app;
  #cuts = new Map(); // pane -> {plane, cut, title}
  #ask;

  constructor(app) {
    this.#app = app;
    this.#ask = newest((planes) => this.#cut(planes));
  }

  /** planes: for each pane {plane, result, title} or null. */
  show(planes) {
    return this.#ask(planes);
  }

  async #cut(planes) {
    const { api, stage } = this.#app;
    const made = new Map();
    for (const [k, pane] of stage.panes.entries()) {
      const asked = planes[k];
      if (!asked) continue;
      try {
        const cut = await api.post("api/section", { result: asked.result, ...asked.plane });
        made.set(pane, { ...asked, cut });
      } catch (error) {
        this.#app.complain(error);
      }
    }
    this.#cuts = made;
    this.#draw();
  }

  #draw() {
    const { stage, unitLength, cssOf, size, clip } = this.#app;
    for (const pane of stage.panes) {
      const found = this.#cuts.get(pane);
      const loops =
        found?.cut.vessels.flatMap(({ loops, closed }) =>
          loops.map((loop, k) => ({ loop, closed: closed[k] })),
        ) ?? [];
      pane.setExtra(
        "section",
        loops
          .filter(({ loop }) => loop.length > 1)
          .map(({ loop, closed }) => ({
            mesh: tubeAbout(open(loop, closed), 0.0022 * size, closed),
            colour: [1, 0.82, 0.2],
          })),
      );
      pane.setClip(found && clip ? facing(found.plane, this.#app.camera) : null);
    }
    stage.draw();
    const parts = [...this.#cuts.values()].map(({ cut, plane, title }) =>
      make(
        "div",
        { class: "section-result" },
        make("h3", {}, title),
        flatOutline(cut, plane, cssOf),
        cut.vessels.some(({ loops }) => loops.length > 0)
          ? tableOf(
              [
                columnHead("Vessel"),
                columnHead(`Area, ${unitLength}²`, true),
                columnHead(`Lumen, ${unitLength}²`, true),
              ],
              cut.vessels
                .filter(({ loops }) => loops.length > 0)
                .map(({ name, area, lumen }) =>
                  make(
                    "tr",
                    {},
                    make(
                      "th",
                      { scope: "row" },
                      make("span", { class: "dot", style: `background:${cssOf(name)}` }),
                      " ",
                      plainName(name),
                    ),
                    make("td", { class: "number" }, numberText(area)),
                    make("td", { class: "number" }, numberText(lumen)),
                  ),
                ),
            )
          : make("p", { class: "soft" }, "The plane meets no vessel."),
      ),
    );
    byId("section-results").replaceChildren(...parts);
  }
}

// A loop that repeats its first point at the end would make a knot in its tube.
function open(loop, closed) {
  const [first, last] = [loop[0], loop.at(-1)];
  return closed && loop.length > 2 && first.every((x, k) => x === last[k])
    ? loop.slice(0, -1)
    : loop;
}

// What lies between the eye and the plane is hidden.
function facing({ point, normal }, camera) {
  const towards = dot(camera.eye, normal) > 0 ? times(-1, normal) : normal;
  return { point, normal: towards };
}
