// Opening scenes and results, and the two kinds of saving: the plan as a scene, the result as a
// folder.
import { Refused } from "./api.js";
import { byId, make } from "./dom.js";
import { fidelityText } from "./words.js";

/** The last part of a path: scenes of one name lie in different files. */
export const fileOf = ({ path }) => path?.split(/[\\/]/).filter(Boolean).at(-1) ?? "";

/** Lists what can be opened; `open(source)` gets the chosen one. `problem`: why nothing is open. */
export function showSources(session, current, open, problem = "") {
  const dialog = byId("open-dialog");
  byId("open-problem").hidden = !problem;
  byId("open-problem").textContent = problem;
  byId("open-folder").textContent = session.folder ?? "";
  const groups = new Map();
  for (const source of session.sources) {
    const title = source.group || (source.kind === "scene" ? "Scenes" : "Results");
    groups.set(title, [...(groups.get(title) ?? []), source]);
  }
  const parts = [...groups].flatMap(([title, sources]) => [
    make("h3", {}, title),
    ...sources.map((source) =>
      make(
        "button",
        {
          type: "button",
          title: source.path,
          "aria-current": source.id === current ? "true" : null,
          click: () => {
            dialog.close();
            open(source);
          },
        },
        make("strong", {}, source.name),
        make("span", {}, fileOf(source), source.id === current ? ", open" : ""),
      ),
    ),
  ]);
  byId("sources").replaceChildren(
    ...(parts.length > 0
      ? parts
      : [make("p", { class: "soft" }, "Nothing to open in this folder.")]),
  );
  dialog.showModal();
}

/**
 * Asks for a name and calls `save(name, fidelity, overwrite)`; a sentence of the program is shown
 * and the dialog stays. Where the name is taken, a second press overwrites if `mayOverwrite`.
 */
export function askName({ title, label, name, fidelities, fidelity, mayOverwrite, save }) {
  const dialog = byId("name-dialog");
  const [input, error, button, model] = [
    "name-input",
    "name-error",
    "name-save",
    "name-fidelity",
  ].map(byId);
  byId("name-title").textContent = title;
  byId("name-label").firstElementChild.textContent = label;
  input.value = name;
  byId("name-fidelity-label").hidden = !fidelities;
  model.replaceChildren(
    ...(fidelities ?? []).map((one) =>
      make(
        "option",
        { value: one.name, selected: one.name === fidelity },
        `${fidelityText(one.name)} (${one.name})`,
      ),
    ),
  );
  let overwrite = false;
  const reset = () => {
    overwrite = false;
    error.hidden = true;
    button.textContent = "Save";
  };
  reset();
  input.oninput = reset;
  byId("name-cancel").onclick = () => dialog.close();
  byId("name-form").onsubmit = async (event) => {
    event.preventDefault();
    button.disabled = true;
    try {
      await save(input.value.trim(), model.value, overwrite);
      dialog.close();
    } catch (problem) {
      error.hidden = false;
      error.textContent = problem.message;
      if (problem instanceof Refused && problem.status === 409 && mayOverwrite) {
        overwrite = true;
        error.textContent = `${problem.message} Save again to replace it.`;
        button.textContent = "Replace";
      }
    } finally {
      button.disabled = false;
    }
  };
  dialog.showModal();
  input.focus();
  input.setSelectionRange(0, input.value.replace(/\.yaml$/, "").length);
}
