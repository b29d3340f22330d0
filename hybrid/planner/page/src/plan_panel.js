// The controls of the plan. Every place that can be dragged can be set by a slider or a number.
import { byId, make } from "./dom.js";
import { numberText } from "./words.js";

const wrap = (degrees) => ((((degrees + 180) % 360) + 360) % 360) - 180;

// A slider and a number for the same value; both carry the same label.
function both({ id, title, unit, limits: [min, max], step, live, done }) {
  const range = make("input", {
    type: "range",
    id: `${id}-slider`,
    min,
    max,
    step,
    "aria-labelledby": `${id}-title`,
  });
  const number = make("input", {
    type: "number",
    id,
    min,
    max,
    step: "any",
    "aria-labelledby": `${id}-title ${id}-unit`,
  });
  const read = (input) => {
    const value = input.valueAsNumber;
    return Number.isFinite(value) ? Math.min(max, Math.max(min, value)) : null;
  };
  for (const input of [range, number]) {
    input.addEventListener("input", () => {
      const value = read(input);
      if (value !== null) live(value);
    });
    input.addEventListener("change", () => {
      const value = read(number);
      if (value !== null && input === number) number.value = String(value); // within the limits
      done();
    });
  }
  const note = make("span", { class: "note", id: `${id}-note` });
  const node = make(
    "div",
    { class: "control" },
    make("span", { class: "name", id: `${id}-title` }, title),
    make(
      "span",
      { class: "value" },
      number,
      make("span", { id: `${id}-unit`, class: "unit" }, unit),
    ),
    range,
    note,
  );
  return {
    node,
    show(value, text = "") {
      const rounded = String(Number(value.toFixed(2)));
      range.value = rounded;
      // The number is left alone while it is being typed.
      if (document.activeElement !== number) number.value = rounded;
      note.textContent = text;
    },
    enable(on) {
      range.disabled = number.disabled = !on;
    },
  };
}

/** Fills the panel; `state` is the PlanState. Returns show(plan, place, veinLength). */
export function planPanel(state, { limits, units, vessels }) {
  const unit = units.length;
  const box = byId("plan-controls");
  const [flattest, roundest] = limits.ellipse_ratio;
  let ratio = Math.min(roundest, Math.max(flattest, 0.5)); // of the ellipse, while a slit is chosen

  const share = { unit: "%", limits: [0, 100], step: 0.5 };
  const angle = { unit: "°", limits: [-180, 180], step: 1 };
  const control = (id, title, kind, change) =>
    both({
      id,
      title,
      ...kind,
      live: (value) => state.preview(change(value, state.plan)),
      done: () => state.commit(),
    });
  const cut = control("cut-along", "Place on the vein", share, (value, plan) => ({
    cut: { ...plan.cut, along: value / 100 },
  }));
  const tilt = control(
    "cut-tilt",
    "Tilt of the cut",
    { ...angle, limits: limits.cut_tilt_deg },
    (value) => ({ cut_tilt_deg: value }),
  );
  const along = control("incision-along", "Place on the artery", share, (value, plan) => ({
    incision: { ...plan.incision, along: value / 100 },
  }));
  const around = control("incision-around", "Around the artery", angle, (value, plan) => ({
    incision: { ...plan.incision, around_deg: value },
  }));
  const length = control(
    "incision-length",
    "Length",
    { unit: "× fit", limits: limits.incision_length, step: 0.05 },
    (value) => ({ incision_length: value }),
  );
  const ellipse = control(
    "ellipse-ratio",
    "Width of the ellipse",
    { unit: "× length", limits: limits.ellipse_ratio, step: 0.05 },
    (value) => ({ shape: { ellipse: (ratio = value) } }),
  );
  const turn = control("vein-turn", "Turn added", angle, (value) => ({ rotation_deg: value }));
  const artery = vessels.find(({ part }) => part === "rpa");
  const ways = artery?.routes ?? [];
  const branch = make(
    "select",
    {
      id: "incision-branch",
      change: () => {
        const { route, ...incision } = state.plan.incision;
        const chosen = ways[branch.selectedIndex].route;
        const other = JSON.stringify(chosen) !== JSON.stringify(artery.route);
        state.set({ incision: other ? { ...incision, route: chosen } : incision });
      },
    },
    ways.map((_, k) => make("option", {}, String(k + 1))),
  );
  const choice = (name, id, title, pick) =>
    make(
      "label",
      { class: "choice" },
      make("input", { type: "radio", name, id, change: pick }),
      title,
    );
  const slit = choice("shape", "shape-slit", "Slit", () => state.set({ shape: "slit" }));
  const oval = choice("shape", "shape-ellipse", "Ellipse", () =>
    state.set({ shape: { ellipse: ratio } }),
  );
  const automatic = choice("turn", "turn-automatic", "Automatic", () =>
    state.set({ rotation_deg: null }),
  );
  const byHand = choice("turn", "turn-by-hand", "By hand", () => state.set({ rotation_deg: 0 }));

  const group = (title, dot, ...children) =>
    make(
      "fieldset",
      {},
      make("legend", {}, dot ? make("span", { class: `dot ${dot}` }) : "", title),
      ...children,
    );
  box.replaceChildren(
    group("Cut of the vein", "cut", cut.node, tilt.node),
    group(
      "Incision in the artery",
      "incision",
      ways.length > 1 ? make("label", { class: "wide" }, "Branch of the artery", branch) : "",
      along.node,
      around.node,
      length.node,
      make(
        "div",
        { class: "choices", role: "group", "aria-label": "Shape of the incision" },
        slit,
        oval,
      ),
      ellipse.node,
    ),
    group(
      "Turn of the vein",
      "",
      make(
        "div",
        { class: "choices", role: "group", "aria-label": "Turn of the vein" },
        automatic,
        byHand,
      ),
      turn.node,
    ),
  );

  return (plan, place, veinLength) => {
    const editable = Boolean(plan) && !state.locked;
    for (const one of [cut, tilt, along, around, length]) one.enable(editable);
    for (const input of box.querySelectorAll("input[type=radio], select"))
      input.disabled = !editable;
    if (!plan) return;
    const isEllipse = plan.shape !== "slit";
    const ofPlace = place?.incision?.length;
    cut.show(
      100 * plan.cut.along,
      veinLength ? `${numberText(plan.cut.along * veinLength)} ${unit} from the kept end` : "",
    );
    tilt.show(plan.cut_tilt_deg);
    along.show(100 * plan.incision.along);
    const way = JSON.stringify(plan.incision.route ?? artery?.route);
    branch.selectedIndex = Math.max(
      0,
      ways.findIndex(({ route }) => JSON.stringify(route) === way),
    );
    around.show(wrap(plan.incision.around_deg));
    const fits = plan.incision_length === 1 ? "fits the vein's rim" : "";
    const long = ofPlace ? `${numberText(ofPlace)} ${unit}` : "";
    length.show(plan.incision_length, [long, fits].filter(Boolean).join(", "));
    if (isEllipse) ratio = plan.shape.ellipse ?? ratio;
    ellipse.node.hidden = !isEllipse;
    ellipse.enable(editable);
    ellipse.show(ratio);
    byId("shape-slit").checked = !isEllipse;
    byId("shape-ellipse").checked = isEllipse;
    const hand = plan.rotation_deg !== null;
    byId("turn-automatic").checked = !hand;
    byId("turn-by-hand").checked = hand;
    turn.node.hidden = !hand;
    turn.enable(editable);
    if (hand) turn.show(wrap(plan.rotation_deg), "to the automatic turn");
  };
}
