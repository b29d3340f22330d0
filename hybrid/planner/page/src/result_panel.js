// What a prediction says of itself: status, validity, warnings and criteria, as report.html does.
import { byId, columnHead, make, scrolling, tableOf } from "./dom.js";
import {
  criterionText,
  fidelityText,
  isFit,
  isSolution,
  numberText,
  plainName,
  statusMark,
  statusText,
  thresholdText,
  verdictMark,
  whyUnknown,
} from "./words.js";

const badge = (kind, text) => make("span", { class: `badge ${kind}` }, text);

function headline({ status, certificate, self_intersections: crossings }) {
  const unfinished = ["iteration_limit", "interrupted"].includes(status);
  const left = unfinished ? `, relative residual ${numberText(certificate.relative_residual)}` : "";
  const crossed = status === "converged" && crossings?.length > 0 ? ", but walls cross" : "";
  return `Status: ${statusText(status)}${left}${crossed}`;
}

function validityBadge(status, { in_range: inRange }) {
  if (inRange === null || !isSolution(status)) return badge("warn", "Validity: unknown");
  if (inRange) return badge("good", "Validity: within the model's range");
  return badge("bad", "Validity: outside the model's range");
}

// Where the warnings of the result do not name them already.
function crossings({ self_intersections: found, validity }, unit) {
  if (validity.warnings.some((text) => /pass(es)? through/.test(text))) return [];
  return (found ?? []).map(({ a, b, depth }) => {
    const other = a === b ? "itself" : `the ${plainName(b)}`;
    const deep = `${numberText(depth)} ${unit} deep`;
    return `The wall of the ${plainName(a)} passes through ${other}, ${deep}.`;
  });
}

function notice(json) {
  const warnings = [
    whyUnknown(json.status),
    ...crossings(json, json.units.length),
    ...json.validity.warnings,
  ].filter(Boolean);
  if (warnings.length === 0) return "";
  const fine =
    isSolution(json.status) &&
    !json.self_intersections?.length &&
    (isFit(json) || json.validity.in_range);
  return make(
    "div",
    { class: `notice ${fine ? "warn" : "bad"}` },
    make(
      "strong",
      {},
      fine ? "Check before you rely on it" : "Do not rely on this result as it stands",
    ),
    make(
      "ul",
      {},
      warnings.map((text) => make("li", {}, text)),
    ),
  );
}

function criteriaTable({ criteria, status, self_intersections: crossed }) {
  if (!criteria?.length) return "";
  const rows = criteria.map((one) => {
    const unknown = one.verdict === "unknown" || !isSolution(status);
    const value = unknown ? "unknown" : `${numberText(one.value)}${one.unit ? ` ${one.unit}` : ""}`;
    const threshold = thresholdText(one);
    return make(
      "tr",
      {},
      make(
        "th",
        { scope: "row" },
        criterionText(one.name),
        make(
          "span",
          { class: "note" },
          plainName(one.vessel),
          threshold === "–" ? "" : `; warns ${threshold}`,
        ),
      ),
      make(
        "td",
        { class: "number" },
        make("strong", {}, value),
        badge(
          // Nothing is good about walls that cross.
          unknown || (crossed?.length > 0 && one.verdict === "fine")
            ? "plain"
            : verdictMark(one.verdict),
          unknown ? "unknown" : plainName(one.verdict),
        ),
      ),
    );
  });
  const sources = [
    ...new Set(
      criteria
        .filter((one) => one.threshold !== null)
        .map((one) => `${criterionText(one.name)}: ${one.source}.`),
    ),
  ];
  return [
    scrolling(
      "Criteria",
      { class: `scroll${isSolution(status) ? "" : " unsolved"}`, id: "criteria" },
      tableOf([columnHead("Criterion"), columnHead("Value and verdict", true)], rows),
    ),
    sources.length > 0
      ? make(
          "details",
          {},
          make("summary", {}, "Where the thresholds come from"),
          make(
            "ul",
            {},
            sources.map((text) => make("li", {}, text)),
          ),
        )
      : "",
  ];
}

function facts({ json }) {
  const solved = isSolution(json.status);
  const { glenn, units, seconds } = json;
  const list = [];
  const add = (name, value, unit = "") =>
    list.push(
      make(
        "div",
        {},
        make("dt", {}, name),
        make("dd", {}, value, unit ? make("small", {}, ` ${unit}`) : ""),
      ),
    );
  if (glenn?.mouth) {
    add(
      "Opening of the join",
      solved ? numberText(glenn.mouth.lumen) : "unknown",
      solved ? `${units.length}²` : "",
    );
    add(
      "Of the vein's lumen",
      solved ? numberText(100 * glenn.mouth.area_ratio) : "unknown",
      solved ? "%" : "",
    );
  }
  if (glenn?.join) add("Turn of the vein", numberText(glenn.join.rotation_deg), "°");
  if (seconds?.total) add("Computed in", numberText(seconds.total, 2), "s");
  return list.length > 0 ? make("dl", { class: "facts" }, list) : "";
}

function badges(json) {
  if (isFit(json)) return [badge("plain", "Fitted at rest, nothing solved")];
  // No vessel can be so, whatever the solver found.
  const crossed = json.self_intersections?.length > 0;
  return [
    badge(crossed ? "bad" : statusMark(json.status), headline(json)),
    validityBadge(json.status, json.validity),
    badge("plain", `${fidelityText(json.fidelity)} (${json.fidelity})`),
  ];
}

/** Shows a prediction, or the sentence why there is none. */
export function showResult({ subject, title, stale, sentence, busy }) {
  const box = byId("result");
  box.classList.toggle("earlier", stale);
  byId("result-title").textContent = title;
  const parts = [];
  if (sentence)
    parts.push(
      make(
        "div",
        { class: "notice bad", role: "alert" },
        make(
          "strong",
          {},
          subject && !stale ? "The last prediction failed" : "No prediction for this plan",
        ),
        sentence,
      ),
    );
  if (subject && stale && !busy)
    parts.push(
      make(
        "div",
        { class: "notice warn" },
        make("strong", {}, "Of an earlier plan"),
        "What is shown belongs to the plan before the last change.",
      ),
    );
  if (subject) {
    const { json } = subject;
    parts.push(
      make("div", { class: "badges" }, badges(json)),
      notice(json),
      facts(subject),
      ...[criteriaTable(json)].flat(),
    );
  } else if (!sentence)
    parts.push(make("p", { class: "soft" }, busy ? "Predicting…" : "No prediction yet."));
  box.replaceChildren(...parts.filter(Boolean));
}
