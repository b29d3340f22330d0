// Plans that are kept beside the current one, with their main numbers.
import { byId, columnHead, make, scrolling, tableOf } from "./dom.js";
import { fidelityText, isSolution, numberText, stateOf } from "./words.js";

const criterion = (json, name) => json.criteria?.find((one) => one.name === name);

function numbersOf(json) {
  if (!isSolution(json.status)) return ["–", "–", "–", "–", "–"];
  const value = (name) => numberText(criterion(json, name)?.value);
  const ratio = json.glenn?.mouth?.area_ratio;
  return [
    numberText(ratio),
    value("twist_shear"),
    value("stretch"),
    value("contact_pressure"),
    value("lumen"),
  ];
}

export const letterOf = (count) => {
  const name = String.fromCharCode(65 + (count % 26));
  return count < 26 ? name : name + (Math.floor(count / 26) + 1);
};

/**
 * `rows`: [{name, subject, kept, instead}], the words `instead` of its state where given. `on` has
 * use(row): its plan becomes the current one, drop(row), beside(row): it is shown in the second
 * view.
 */
export function showComparison(rows, on) {
  const heads = [
    "Plan",
    "Model",
    "Status",
    "Opening ratio",
    "Twist shear",
    "Stretch",
    "Pressure, mmHg",
    "Lumen ratio",
    "",
  ];
  const lines = rows.map((row) => {
    const { json, plan } = row.subject;
    const [mark, words] = stateOf(json);
    const button = (text, label, click, disabled) =>
      make(
        "button",
        { type: "button", "aria-label": `${label} ${row.name}`, click, disabled },
        text,
      );
    return make(
      "tr",
      { class: isSolution(json.status) && !row.instead ? "" : "unsolved" },
      make("th", { scope: "row" }, row.name),
      make("td", {}, fidelityText(json.fidelity)),
      make(
        "td",
        {},
        make("span", { class: `badge ${row.instead ? "plain" : mark}` }, row.instead ?? words),
      ),
      numbersOf(json).map((text) => make("td", { class: "number" }, text)),
      make(
        "td",
        { class: "actions" },
        button("Show", "Show in the second view", () => on.beside(row)),
        row.kept
          ? button(
              "Use",
              "Use the plan of",
              () => on.use(row),
              !plan || on.locked || row.sceneId !== on.sceneId,
            )
          : "",
        row.kept ? button("Remove", "Remove", () => on.drop(row)) : "",
      ),
    );
  });
  byId("comparison").replaceChildren(
    lines.length === 0
      ? make(
          "p",
          { class: "soft" },
          "Nothing to compare yet. “Keep this plan” puts the current one here as A, B, C…",
        )
      : scrolling(
          "Plans side by side",
          {},
          tableOf(
            heads.map((text, k) => columnHead(text, k > 2)),
            lines,
          ),
        ),
  );
}
