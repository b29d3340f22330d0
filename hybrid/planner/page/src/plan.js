// The plan of the operation with undo and redo. A drag changes the plan many times and is one step.

const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

/** Emits "change" after every change of the plan, the history or the lock. */
export class PlanState extends EventTarget {
  #steps = [];
  #at = -1;
  #shown = null;
  locked = false;

  /** Begins a new history. */
  start(plan) {
    this.#steps = plan ? [plan] : [];
    this.#at = this.#steps.length - 1;
    this.#shown = plan;
    this.locked = false;
    this.#tell();
  }

  get plan() {
    return this.#shown;
  }

  get canUndo() {
    return this.#at > 0 && !this.locked;
  }

  get canRedo() {
    return this.#at < this.#steps.length - 1 && !this.locked;
  }

  /** Shows a plan that becomes a step with commit(): a marker or slider on its way. */
  preview(changes) {
    if (this.locked || !this.#shown) return;
    const plan = { ...this.#shown, ...changes };
    if (same(plan, this.#shown)) return;
    this.#shown = plan;
    this.#tell();
  }

  commit() {
    if (!this.#shown || same(this.#shown, this.#steps[this.#at])) return false;
    this.#steps = [...this.#steps.slice(0, this.#at + 1), this.#shown];
    this.#at = this.#steps.length - 1;
    this.#tell(true);
    return true;
  }

  set(changes) {
    this.preview(changes);
    return this.commit();
  }

  undo() {
    if (!this.canUndo) return;
    this.#shown = this.#steps[--this.#at];
    this.#tell(true);
  }

  redo() {
    if (!this.canRedo) return;
    this.#shown = this.#steps[++this.#at];
    this.#tell(true);
  }

  lock(locked) {
    this.locked = locked;
    this.#tell();
  }

  // settled: a step was made or taken back, not a marker on its way.
  #tell(settled = false) {
    this.dispatchEvent(new CustomEvent("change", { detail: { settled } }));
  }
}
