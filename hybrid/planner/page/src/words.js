// What the page calls things, in the words of report.html.

/** Names of vessels, stages and verdicts as words. */
export const plainName = (name) => String(name).replaceAll("_", " ");

/** Whether the vessels would stay in the state: the rule of report.html. */
export const isSolution = (status) =>
  !["iteration_limit", "interrupted", "unstable"].includes(status);

// A function from a name to its words; a name that is not listed stands for itself.
const wordsFrom = (words) => (name) => words[name] ?? plainName(name);

export const statusText = wordsFrom({
  converged: "converged",
  equilibrium_only: "in equilibrium, minimum not certified",
  unstable: "unstable: an equilibrium that does not last",
  buckled: "buckled",
  not_unique: "the minimum is not unique",
  self_intersecting: "walls pass through themselves or each other",
  iteration_limit: "stopped at the iteration limit",
  interrupted: "interrupted: the best state so far",
});

/** "good", "warn" or "bad": only a converged result is shown as good. */
export function statusMark(status) {
  if (status === "converged") return "good";
  return status === "equilibrium_only" ? "warn" : "bad";
}

/** The shortest form, for the head of a view. */
const statusShort = wordsFrom({
  equilibrium_only: "not certified",
  self_intersecting: "walls cross",
  iteration_limit: "unfinished",
});

/** Whether a result is that of `vasorod fit`: a vessel at rest. */
export const isFit = ({ fidelity }) => fidelity === "fit";

/** The state of a prediction in a few words, with its mark: nothing with a warning is "good". */
export function stateOf(json) {
  const { status, validity, criteria, self_intersections: crossings } = json;
  const [mark, words] = [statusMark(status), statusShort(status)];
  if (isFit(json)) return ["plain", "nothing solved"];
  if (!isSolution(status)) return [mark, words];
  if (crossings?.length > 0) return ["bad", "walls pass through each other"];
  if (!validity.in_range) return ["bad", `${words}, outside the model's range`];
  const warned =
    validity.warnings.length > 0 ||
    criteria?.some(({ verdict }) => verdict === "warning" || verdict === "strong_warning");
  return warned ? [mark === "good" ? "warn" : mark, `${words}, with warnings`] : [mark, words];
}

export const fidelityText = wordsFrom({
  rod: "Axes only",
  skin: "Quick",
  paper: "Paper model",
  coupled: "Full model",
  fit: "Fitted",
  solid: "Solid elements",
  shell: "Shell elements",
});

export const criterionText = wordsFrom({
  lumen: "Smallest lumen, of that at rest",
  mouth: "Opening of the join, of the cut vein's lumen",
  twist: "Largest twist along a vessel",
  twist_shear: "Largest twist shear",
  stretch: "Stretch furthest from 1",
  contact_pressure: "Largest contact pressure",
});

export const verdictMark = (verdict) =>
  ({ fine: "good", warning: "warn", strong_warning: "bad" })[verdict] ?? "plain";

/** A number with three digits that matter; a dash where there is none. */
export function numberText(value, digits = 3) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) return value.toExponential(digits - 1).replace("-", "−");
  return String(Number(value.toPrecision(digits))).replace("-", "−");
}

/** Which side of a threshold warns follows from the order of the two thresholds. */
export function thresholdText({ threshold, strong_threshold: strong, unit }) {
  if (threshold === null || threshold === undefined) return "–";
  const hasStrong = strong !== null && strong !== undefined;
  const side = !hasStrong || strong > threshold ? "from " : "below ";
  const text =
    side + numberText(threshold) + (hasStrong ? `, strong ${side}${numberText(strong)}` : "");
  return unit ? `${text} ${unit}` : text;
}

export function whyUnknown(status) {
  if (isSolution(status)) return null;
  const shown = "the numbers and colours are those of a state that is no solution";
  if (status === "unstable")
    return `The equilibrium is unstable, the vessels would leave it: ${shown}.`;
  return `No equilibrium was found (${plainName(status)}): ${shown}.`;
}
