// What a view can show: the vessels before the operation, or a prediction with its fields.
import { at } from "./geometry.js";

/** The vessels at rest. */
export async function loadRest(api, scene) {
  const meshes = new Map();
  await Promise.all(
    scene.vessels.map(async ({ name }) => {
      meshes.set(name, await api.mesh(`api/mesh/${encodeURIComponent(name)}`));
    }),
  );
  return { kind: "rest", meshes: inOrder(meshes, scene.vessels) };
}

/** A prediction: its numbers and its deformed vessels. */
export async function loadResult(api, id, scene, rest) {
  const result = await api.get(`api/result/${id}`);
  const meshes = new Map();
  await Promise.all(
    result.vessels.map(async ({ name }) => {
      meshes.set(name, await api.mesh(`api/result/${id}/mesh/${encodeURIComponent(name)}`));
    }),
  );
  // A vessel that the prediction leaves out stays where it was.
  for (const { name, role } of scene.vessels)
    if (!meshes.has(name) && role === "obstacle" && rest.meshes.has(name))
      meshes.set(name, rest.meshes.get(name));
  const subject = {
    ...result,
    kind: "result",
    meshes: inOrder(meshes, result.vessels),
    fields: new Map(),
  };
  for (const { name, fields } of result.vessels)
    for (const field of fields ?? []) addField(subject, name, field, meshes.get(name)[field.name]);
  addLumen(subject, scene.units.length);
  return subject;
}

function inOrder(meshes, vessels) {
  const order = new Map(vessels.map(({ name }, k) => [name, k]));
  return new Map([...meshes].sort(([a], [b]) => (order.get(a) ?? 99) - (order.get(b) ?? 99)));
}

function addField(subject, vessel, { name, title, unit, map, range }, values) {
  if (!values) return;
  const known = subject.fields.get(name) ?? {
    name,
    title,
    unit,
    map,
    range: [...range],
    values: new Map(),
  };
  known.range = [Math.min(known.range[0], range[0]), Math.max(known.range[1], range[1])];
  known.values.set(vessel, values);
  subject.fields.set(name, known);
}

// The lumen's area belongs to sections: a vertex has that of the node of the axis nearest at rest.
// It is worked out when it is first shown.
function addLumen(subject, unit) {
  if (subject.fields.has("LumenArea")) return;
  const known = (line) => line.lumen_area?.some((area) => area !== null);
  const lines = subject.lines.filter(known);
  const areas = lines.flatMap((line) => line.lumen_area.filter((area) => area !== null));
  if (areas.length === 0) return;
  const range = [Math.min(...areas), Math.max(...areas)];
  if (range[1] <= range[0]) range[1] = range[0] + 1;
  let made = null;
  subject.fields.set("LumenArea", {
    name: "LumenArea",
    title: "lumen area",
    unit: `${unit}²`,
    map: "sequential",
    range,
    get values() {
      made ??= lumenValues(subject, new Set(lines.map((line) => line.vessel)));
      return made;
    },
  });
}

function lumenValues(subject, names) {
  const values = new Map();
  for (const name of names) {
    const rest = subject.meshes.get(name)?.rest;
    if (!rest) continue;
    const lines = subject.lines.filter((line) => line.vessel === name);
    const nodes = Float32Array.from(lines.flatMap((line) => line.rest.flat()));
    const areas = lines.flatMap((line) => line.lumen_area ?? line.rest.map(() => null));
    const of = new Float32Array(rest.length / 3);
    for (let i = 0; i < of.length; i++) {
      let least = Infinity;
      let nearest = 0;
      for (let k = 0; k < nodes.length; k += 3) {
        const x = nodes[k] - rest[3 * i],
          y = nodes[k + 1] - rest[3 * i + 1],
          z = nodes[k + 2] - rest[3 * i + 2];
        const square = x * x + y * y + z * z;
        if (square < least) [least, nearest] = [square, k / 3];
      }
      of[i] = areas[nearest] ?? NaN;
    }
    values.set(name, of);
  }
  return values;
}

/** Every so many points of all vessels, to fit the camera. */
export function somePoints(subject, names) {
  const points = [];
  for (const [name, mesh] of subject.meshes) {
    if (names && !names.has(name)) continue;
    const count = mesh.points.length / 3;
    for (let i = 0; i < count; i += Math.max(1, Math.floor(count / 400)))
      points.push(at(mesh.points, i));
  }
  return points;
}
