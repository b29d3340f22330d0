// Curves along a vessel's axis: lumen, stretch, twist and curvature over the arc length, with one
// cursor that is also a place in the views.
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { byId, make, themeColour } from "./dom.js";

const plotHeight = 118;

const curves = (unit) => [
  { key: "lumen_area", title: `Lumen area, ${unit}²` },
  { key: "stretch", title: "Stretch" },
  { key: "twist_deg_per_length", title: `Twist, °/${unit}` },
  { key: "curvature", title: `Curvature, 1/${unit}` },
];

/** `marked(arc)` is called when the cursor moves over a plot, with null when it leaves. */
export class Plots {
  #plots = [];
  #marked;
  #lines = []; // of each shown result: {name, line}
  #quiet = false;
  #shape = "";

  constructor(marked) {
    this.#marked = marked;
    new ResizeObserver(() => this.#fit()).observe(byId("plots"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.#make());
  }

  /** `lines`: [{name, line, solved}]; the first one has the cursor. */
  show(lines, unit) {
    this.#lines = lines;
    this.#unit = unit;
    const shape = JSON.stringify([
      unit,
      lines.map(({ name, solved }) => [name, solved]),
      this.#keys(),
    ]);
    if (shape === this.#shape) this.#plots.forEach((plot) => plot.setData(this.#data(plot.key)));
    else {
      this.#shape = shape;
      this.#make();
    }
  }

  #unit = "mm";

  #keys() {
    return curves(this.#unit).filter(({ key }) =>
      this.#lines.some(({ line }) => line[key]?.some((value) => value !== null)),
    );
  }

  // All results over one axis of arc lengths: a missing node is bridged, a null is a gap.
  #data(key) {
    const joined = this.#lines.map(({ line }) => [line.arc, line[key] ?? line.arc.map(() => null)]);
    return joined.length === 1 ? joined[0] : uPlot.join(joined);
  }

  #make() {
    for (const plot of this.#plots) plot.destroy();
    this.#plots = [];
    const box = byId("plots");
    box.replaceChildren();
    if (this.#lines.length === 0) {
      box.append(make("p", { class: "soft" }, "The curves appear with a prediction."));
      return;
    }
    const [ink, soft, rule] = ["--ink", "--soft", "--line"].map(themeColour);
    const colours = [themeColour("--accent"), themeColour("--second")];
    for (const { key, title } of this.#keys()) {
      const holder = make("div", { class: "plot" });
      box.append(holder);
      const axis = {
        stroke: soft,
        grid: { stroke: rule, width: 1 },
        ticks: { stroke: rule, width: 1 },
        font: "11px system-ui, sans-serif",
      };
      const plot = new uPlot(
        {
          title,
          width: Math.max(200, holder.clientWidth),
          height: plotHeight,
          legend: { show: false },
          scales: { x: { time: false }, y: { range: (_, low, high) => rangeOf(low, high) } },
          axes: [
            { ...axis, size: 26 },
            { ...axis, size: 52 },
          ],
          series: [
            {},
            ...this.#lines.map(({ solved }, k) => ({
              stroke: solved ? colours[k] : soft,
              width: 1.5,
              dash: k ? [5, 3] : [],
              points: { show: false },
            })),
          ],
          cursor: { sync: { key: "along" }, drag: { x: false, y: false }, points: { size: 7 } },
          hooks: { setCursor: [(self) => this.#moved(self)] },
        },
        this.#data(key),
        holder,
      );
      plot.key = key;
      plot.root.querySelector(".u-title").style.color = ink;
      this.#plots.push(plot);
    }
  }

  #moved(plot) {
    if (this.#quiet) return;
    const { left } = plot.cursor;
    if (left === null || left < 0) this.#marked(null);
    else this.#marked(plot.posToVal(left, "x"));
  }

  /** Puts the cursor at an arc length; null takes it away. */
  mark(arc) {
    this.#quiet = true;
    const left = (plot) => (arc === null ? -10 : plot.valToPos(arc, "x"));
    for (const plot of this.#plots)
      plot.setCursor(
        { left: left(plot), top: arc === null ? -10 : plot.over.clientHeight / 2 },
        true,
        false,
      );
    this.#quiet = false;
  }

  #fit() {
    for (const plot of this.#plots) {
      const width = plot.root.parentElement.clientWidth;
      if (width > 0 && width !== plot.width) plot.setSize({ width, height: plotHeight });
    }
  }
}

// A curve without ups and downs must not show its rounding errors.
function rangeOf(low, high) {
  if (low === null || high === null) return [0, 1];
  const middle = (low + high) / 2;
  const half = Math.max((high - low) / 2, 0.01 * Math.abs(middle), 1e-4) * 1.1;
  return [middle - half, middle + half];
}

/** The node of a line at an arc length. */
export function nodeAt(line, arc) {
  let best = 0;
  line.arc.forEach((value, k) => {
    if (Math.abs(value - arc) < Math.abs(line.arc[best] - arc)) best = k;
  });
  return best;
}
