// The way from a changed plan to a shown prediction.
import { Unreachable } from "./api.js";
import { announce, byId, make } from "./dom.js";
import { newest } from "./newest.js";
import { quick } from "./solving.js";
import { loadResult } from "./subjects.js";
import { fidelityText, plainName, statusText } from "./words.js";

const order = ["rod", "skin", "paper", "coupled"];
const most = 12; // predictions that stay in memory, for undo and redo

export const keyOf = (plan) => JSON.stringify(plan ?? null);

export class Predicting {
  #app;
  #known = new Map(); // plan -> the most detailed prediction of it
  #shownPlan = null; // the plan of what is shown
  #seen = null; // the plan that was last placed and asked for
  #detail = null; // {plan, fidelity}: what follows the quick prediction of a plan
  #loading = false;
  #told = false; // whether the page was last told that what it shows is outdated
  #clock = 0;

  constructor(app) {
    this.#app = app;
    const { solving, state } = app;
    const load = newest((detail) => this.#load(detail));
    solving.addEventListener("progress", ({ detail }) => this.#progress(detail));
    solving.addEventListener("done", ({ detail }) => {
      this.#loading = true;
      load(detail).finally(() => {
        this.#loading = false;
        this.#showBusy();
      });
    });
    solving.addEventListener("failed", ({ detail }) => this.#failed(detail));
    solving.addEventListener("idle", () => this.#showBusy());
    state.addEventListener("change", ({ detail }) => this.#planChanged(detail.settled));
    byId("cancel").addEventListener("click", () => this.cancel());
    this.place = newest((plan) => this.#place(plan));
  }

  /** The buttons and the choice of what follows a change. */
  list(fidelities) {
    byId("fidelities").replaceChildren(
      ...fidelities.map(({ name, sentence }) =>
        make(
          "button",
          { type: "button", id: `solve-${name}`, title: sentence, click: () => this.solve(name) },
          fidelityText(name),
        ),
      ),
    );
    byId("models").replaceChildren(
      ...fidelities.map(({ name, sentence }) =>
        make("li", {}, make("strong", {}, `${fidelityText(name)} (${name}): `), sentence),
      ),
    );
    const names = fidelities.map(({ name }) => name).filter((name) => name !== "rod");
    byId("follow").replaceChildren(
      ...names.map((name) =>
        make(
          "option",
          { value: name, selected: name === "skin" },
          name === "skin" ? "Quick" : `Quick, then ${fidelityText(name)}`,
        ),
      ),
      make("option", { value: "" }, "Nothing"),
    );
  }

  /** Another scene: nothing is known of its plans. */
  start() {
    this.#known.clear();
    this.#shownPlan = this.#seen = this.#detail = null;
  }

  /** A result that was opened, not predicted. */
  opened(subject) {
    this.#app.current = subject;
    this.#app.noResult = null;
    this.#shownPlan = keyOf(this.#app.state.plan);
  }

  get stale() {
    const { state, current } = this.#app;
    return Boolean(current) && this.#shownPlan !== keyOf(state.plan);
  }

  get busy() {
    return this.#loading || Boolean(this.#app.solving.running);
  }

  /**
   * What is shown is of an earlier plan, and no quick prediction is about to replace it: a marker
   * that is dragged would else make the colours flicker.
   */
  get outdated() {
    const { fidelity } = this.#app.solving.running ?? {};
    return this.stale && !this.#loading && !quick.includes(fidelity);
  }

  /** Ends the running prediction and what would have followed it. */
  cancel() {
    this.#detail = null;
    this.#app.solving.cancel();
  }

  solve(fidelity) {
    const { solving, state } = this.#app;
    this.#app.noResult = null;
    this.#detail = null;
    solving.ask(state.plan, fidelity);
  }

  #planChanged(settled) {
    const { state, scene } = this.#app;
    this.#app.planChanged();
    if (!state.plan || !scene?.editable) return;
    const fresh = keyOf(state.plan) !== this.#seen;
    this.#seen = keyOf(state.plan);
    if (fresh) this.place(state.plan);
    if (fresh || settled) this.follow(settled);
  }

  /** Shows what is known of the plan, or asks for it. */
  follow(settled) {
    const { state, solving } = this.#app;
    const key = keyOf(state.plan);
    const known = this.#known.get(key);
    this.#app.noResult = null;
    if (known) {
      this.#app.current = known;
      this.#shownPlan = key;
      if (solving.running) solving.clear();
    }
    const wanted = byId("follow").value;
    const level = known ? order.indexOf(known.fidelity) : -1;
    const missing = (fidelity) => level < order.indexOf(fidelity);
    this.#detail =
      settled && wanted && wanted !== "skin" && missing(wanted) ? { key, fidelity: wanted } : null;
    if (wanted && missing("skin")) solving.ask(state.plan, "skin");
    else if (this.#detail) this.solve(wanted);
    this.#app.resultChanged();
  }

  async #place(plan) {
    try {
      this.#app.placed = await this.#app.api.post("api/place", { plan });
    } catch (error) {
      if (error instanceof Unreachable) return;
      this.#app.placed = { ...this.#app.placed, problem: error.message };
    }
    this.#app.placeChanged();
  }

  /** After the program answers again: what was asked for in the meantime. */
  resume() {
    const { state, scene, current } = this.#app;
    if (!state.plan || !scene?.editable) return;
    this.place(state.plan);
    if (this.stale || !current || this.#app.noResult) this.follow(false);
  }

  #progress({ fidelity, stage, seconds, begun }) {
    byId("progress").hidden = false;
    const show = () => {
      const elapsed = Math.max(seconds ?? 0, (performance.now() - begun) / 1000);
      byId("progress-text").textContent =
        `${fidelityText(fidelity)}: ${plainName(stage || "running")}, ` +
        `${elapsed.toFixed(elapsed < 10 ? 1 : 0)} s`;
    };
    clearInterval(this.#clock);
    this.#clock = setInterval(show, 200);
    show();
    this.#showBusy();
  }

  #showBusy() {
    const { busy, outdated } = this;
    if (!this.#app.solving.running) {
      clearInterval(this.#clock);
      byId("progress").hidden = true;
    }
    if (busy === this.#app.busy && outdated === this.#told) return;
    this.#app.busy = busy;
    this.#told = outdated;
    this.#app.resultChanged();
  }

  async #load({ plan, result, fidelity }) {
    const { api, scene, rest } = this.#app;
    let subject;
    try {
      subject = await loadResult(api, result, scene, rest);
    } catch (error) {
      this.#app.complain(error);
      return;
    }
    if (scene !== this.#app.scene) return; // another one was opened meanwhile
    const key = keyOf(plan);
    this.#remember(key, subject);
    // The plan went back to one whose prediction is shown while this one was on its way.
    if (key !== keyOf(this.#app.state.plan) && this.#app.current && !this.stale) return;
    this.#app.current = subject;
    this.#app.noResult = null;
    this.#shownPlan = key;
    this.#app.resultChanged();
    if (!this.#app.dragging)
      announce(`${fidelityText(subject.fidelity)}: ${statusText(subject.json.status)}.`);
    const next = this.#detail;
    if (fidelity === "skin" && next?.key === key && key === keyOf(this.#app.state.plan))
      this.solve(next.fidelity);
  }

  #remember(key, subject) {
    if (["interrupted", "iteration_limit"].includes(subject.json.status)) return;
    const known = this.#known.get(key);
    if (known && order.indexOf(subject.fidelity) < order.indexOf(known.fidelity)) return;
    this.#known.delete(key);
    this.#known.set(key, subject);
    if (this.#known.size > most) this.#known.delete(this.#known.keys().next().value);
  }

  #failed({ sentence, plan, cancelled }) {
    if (keyOf(plan) !== keyOf(this.#app.state.plan)) return;
    // A cancelled prediction takes nothing from the one that is shown for the same plan.
    if (cancelled && this.#app.current && !this.stale) return;
    this.#app.noResult = sentence;
    this.#app.resultChanged();
  }
}
