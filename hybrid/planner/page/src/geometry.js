// Work on triangles and polylines: normals, borders, the nearest triangle on a ray or node.
import { cross, dot, sub } from "./vectors.js";

export const at = (array, i) => [array[3 * i], array[3 * i + 1], array[3 * i + 2]];

/** A unit normal for every vertex, weighted by the areas of its triangles. */
export function vertexNormals(points, triangles) {
  const sum = new Float32Array(points.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const ux = points[b] - points[a],
      uy = points[b + 1] - points[a + 1],
      uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a],
      vy = points[c + 1] - points[a + 1],
      vz = points[c + 2] - points[a + 2];
    const nx = uy * vz - uz * vy,
      ny = uz * vx - ux * vz,
      nz = ux * vy - uy * vx;
    for (const k of [a, b, c]) {
      sum[k] += nx;
      sum[k + 1] += ny;
      sum[k + 2] += nz;
    }
  }
  for (let k = 0; k < sum.length; k += 3) {
    const length = Math.hypot(sum[k], sum[k + 1], sum[k + 2]) || 1;
    sum[k] /= length;
    sum[k + 1] /= length;
    sum[k + 2] /= length;
  }
  return sum;
}

/** Edges of one triangle only, as pairs of vertices: open ends, slits and seams. */
export function borderEdges(triangles) {
  const alone = new Map();
  for (let t = 0; t < triangles.length; t++) {
    const a = triangles[t];
    const b = triangles[t % 3 === 2 ? t - 2 : t + 1];
    const key = Math.min(a, b) * 4294967296 + Math.max(a, b);
    if (!alone.delete(key)) alone.set(key, [a, b]);
  }
  return [...alone.values()];
}

/** The nearest triangle in front (Moeller, Trumbore 1997): {distance, triangle, weights, point}. */
export function hitOfRay({ origin, direction }, { points, triangles }) {
  const [ox, oy, oz] = origin;
  const [dx, dy, dz] = direction;
  let best = null;
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t],
      b = 3 * triangles[t + 1],
      c = 3 * triangles[t + 2];
    const ax = points[a],
      ay = points[a + 1],
      az = points[a + 2];
    const ux = points[b] - ax,
      uy = points[b + 1] - ay,
      uz = points[b + 2] - az;
    const vx = points[c] - ax,
      vy = points[c + 1] - ay,
      vz = points[c + 2] - az;
    const px = dy * vz - dz * vy,
      py = dz * vx - dx * vz,
      pz = dx * vy - dy * vx;
    const size = ux * px + uy * py + uz * pz;
    if (size === 0) continue;
    const sx = ox - ax,
      sy = oy - ay,
      sz = oz - az;
    const v = (sx * px + sy * py + sz * pz) / size;
    if (v < 0 || v > 1) continue;
    const qx = sy * uz - sz * uy,
      qy = sz * ux - sx * uz,
      qz = sx * uy - sy * ux;
    const w = (dx * qx + dy * qy + dz * qz) / size;
    if (w < 0 || v + w > 1) continue;
    const distance = (vx * qx + vy * qy + vz * qz) / size;
    if (distance > 0 && (!best || distance < best.distance))
      best = { distance, triangle: t / 3, weights: [1 - v - w, v, w] };
  }
  if (best)
    best.point = [ox + best.distance * dx, oy + best.distance * dy, oz + best.distance * dz];
  return best;
}

/** The value of a vertex field inside a triangle. */
export function valueAt(values, triangles, { triangle, weights }) {
  return weights.reduce((sum, weight, k) => sum + weight * values[triangles[3 * triangle + k]], 0);
}

/** The nearest node of lines: {line, node}; `which` is "point" or "rest". */
export function nearestNode(lines, which, point) {
  let best = null;
  let least = Infinity;
  for (const line of lines)
    line[which].forEach((node, k) => {
      const away = sub(node, point);
      const square = dot(away, away);
      if (square < least) {
        least = square;
        best = { line, node: k };
      }
    });
  return best;
}

/** A tube about a polyline, for lines that are thicker than a pixel: {points, triangles}. */
export function tubeAbout(path, radius, closed = false) {
  const around = 8;
  const count = path.length;
  const points = new Float32Array(3 * around * count);
  let side = null;
  for (let i = 0; i < count; i++) {
    const before = path[closed ? (i + count - 1) % count : Math.max(i - 1, 0)];
    const after = path[closed ? (i + 1) % count : Math.min(i + 1, count - 1)];
    let along = sub(after, before);
    const length = Math.hypot(...along) || 1;
    along = along.map((x) => x / length);
    // The side is carried along, so that the tube does not twist.
    side ??= Math.abs(along[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
    const lean = dot(side, along);
    side = side.map((x, k) => x - lean * along[k]);
    const size = Math.hypot(...side) || 1;
    side = side.map((x) => x / size);
    const other = cross(along, side);
    for (let j = 0; j < around; j++) {
      const angle = (2 * Math.PI * j) / around;
      for (let k = 0; k < 3; k++)
        points[3 * (around * i + j) + k] =
          path[i][k] + radius * (Math.cos(angle) * side[k] + Math.sin(angle) * other[k]);
    }
  }
  const triangles = [];
  for (let i = 0; i < (closed ? count : count - 1); i++)
    for (let j = 0; j < around; j++) {
      const next = (i + 1) % count;
      const k = (j + 1) % around;
      const [a, b] = [around * i + j, around * i + k];
      const [c, d] = [around * next + j, around * next + k];
      triangles.push(a, c, b, b, c, d);
    }
  return { points, triangles: Uint32Array.from(triangles) };
}

/** A ball: {points, triangles}. */
export function ballAbout(middle, radius) {
  const [rings, around] = [10, 16];
  const points = [];
  for (let i = 0; i <= rings; i++)
    for (let j = 0; j < around; j++) {
      const [polar, turn] = [(Math.PI * i) / rings, (2 * Math.PI * j) / around];
      points.push(
        middle[0] + radius * Math.sin(polar) * Math.cos(turn),
        middle[1] + radius * Math.sin(polar) * Math.sin(turn),
        middle[2] + radius * Math.cos(polar),
      );
    }
  const triangles = [];
  for (let i = 0; i < rings; i++)
    for (let j = 0; j < around; j++) {
      const [a, b] = [around * i + j, around * i + ((j + 1) % around)];
      triangles.push(a, a + around, b, b, a + around, b + around);
    }
  return { points: Float32Array.from(points), triangles: Uint32Array.from(triangles) };
}
