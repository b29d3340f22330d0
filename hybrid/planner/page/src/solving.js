// Predictions: one at a time. While a quick one runs, only the newest plan waits; a long one is
// given up for a newer plan.
import { Refused, Unreachable } from "./api.js";

export const quick = ["rod", "skin"];

/**
 * Emits "progress" with {fidelity, stage, seconds}, "done" with {plan, fidelity, result}, "failed"
 * with {sentence, plan, cancelled} and "idle".
 */
export class Solving extends EventTarget {
  #api;
  #waiting = null;
  #current = null;
  #loop = null;

  constructor(api) {
    super();
    this.#api = api;
  }

  get running() {
    return this.#current;
  }

  /** Asks for a prediction of the plan; what waited before is forgotten. */
  ask(plan, fidelity) {
    const asked = JSON.stringify([plan, fidelity]);
    const current = this.#current;
    if (current && !current.stale && !current.stopped && current.asked === asked) {
      this.#waiting = null;
      return;
    }
    this.#waiting = { plan, fidelity, asked, begun: performance.now() };
    const long = current && !quick.includes(current.fidelity);
    if (long || (current && fidelity !== "skin")) this.#giveUp(current);
    this.#loop ??= this.#run();
  }

  /** What the user stops: a state that was kept on the way is still shown. */
  async cancel() {
    this.#waiting = null;
    const current = this.#current;
    if (!current) return;
    current.stopped = true;
    if (current.job) await this.#api.post("api/cancel", { job: current.job }).catch(() => {});
  }

  /** Forgets everything, as when another scene is opened. */
  async clear() {
    this.#waiting = null;
    if (this.#current) this.#giveUp(this.#current);
    await this.#loop;
  }

  #giveUp(current) {
    current.stale = true;
    if (current.job) this.#api.post("api/cancel", { job: current.job }).catch(() => {});
  }

  #tell(kind, detail) {
    this.dispatchEvent(new CustomEvent(kind, { detail }));
  }

  async #run() {
    // Also after an answer that nobody expected the next plan is predicted.
    try {
      while (this.#waiting) await this.#attempt();
    } finally {
      this.#loop = null;
      this.#tell("idle");
    }
  }

  async #attempt() {
    const task = this.#waiting;
    this.#waiting = null;
    this.#current = task;
    try {
      await this.#solve(task);
    } catch (error) {
      if (!task.stale) this.#tell("failed", { ...task, sentence: error.message });
      if (!(error instanceof Unreachable || error instanceof Refused)) throw error;
    } finally {
      this.#current = null;
    }
  }

  async #solve(task) {
    const { plan, fidelity } = task;
    this.#tell("progress", { ...task, stage: "starting", seconds: 0 });
    task.job = (await this.#api.post("api/solve", { plan, fidelity })).job;
    // Stopped before the job had its number.
    if (task.stale || task.stopped)
      await this.#api.post("api/cancel", { job: task.job }).catch(() => {});
    let job;
    do {
      job = await this.#api.get(`api/job/${task.job}?wait=1000`);
      if (job.state === "running" && !task.stale) this.#tell("progress", { ...task, ...job });
    } while (job.state === "running");
    if (task.stale) return;
    if (job.result) this.#tell("done", { ...task, result: job.result });
    else {
      const cancelled = "The prediction was cancelled before there was anything to show.";
      const sentence =
        job.state === "cancelled" ? cancelled : (job.error ?? "The prediction failed.");
      this.#tell("failed", { ...task, sentence, cancelled: job.state === "cancelled" });
    }
  }
}
