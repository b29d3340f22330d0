// The camera of all views: turned about a middle point, moved and brought nearer. Rays through
// pixels and places of points on the screen come from the same numbers as the picture.
import { add, cross, dot, sub, times, unit } from "./vectors.js";

export const viewAngle = 30; // degrees, of the height
const slope = Math.tan((viewAngle / 2) * (Math.PI / 180));

export class Camera {
  focal = [0, 0, 0];
  right = [1, 0, 0];
  up = [0, 0, 1];
  eye = [0, -1, 0]; // from the middle towards the viewer
  distance = 100;
  reach = 100; // radius about the middle of the scene that holds everything
  centre = [0, 0, 0];

  get position() {
    return add(this.focal, times(this.distance, this.eye));
  }

  /** Looks from `eye`; `up` need not be at right angles to it. */
  look(eye, up) {
    this.eye = unit(eye);
    this.right = unit(cross(up, this.eye));
    this.up = cross(this.eye, this.right);
  }

  turn(dx, dy) {
    const rotate = (a, b, angle) => {
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      return [add(times(c, a), times(s, b)), add(times(c, b), times(-s, a))];
    };
    [this.eye, this.right] = rotate(this.eye, this.right, -dx);
    [this.eye, this.up] = rotate(this.eye, this.up, dy);
    this.look(this.eye, this.up);
  }

  /** By pixels of a view of that height. */
  pan(dx, dy, height) {
    const step = (2 * slope * this.distance) / height;
    this.focal = add(this.focal, add(times(-dx * step, this.right), times(dy * step, this.up)));
  }

  zoom(factor) {
    const distance = this.distance * factor;
    this.distance = Math.min(20 * this.reach, Math.max(0.05 * this.reach, distance));
  }

  /** All points in a view of that shape (width over height), with a margin. */
  fit(points, aspect) {
    if (points.length === 0) return;
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    const axes = [this.right, this.up, this.eye];
    for (const point of points)
      axes.forEach((axis, k) => {
        const at = dot(point, axis);
        low[k] = Math.min(low[k], at);
        high[k] = Math.max(high[k], at);
      });
    this.focal = axes.reduce(
      (sum, axis, k) => add(sum, times((low[k] + high[k]) / 2, axis)),
      [0, 0, 0],
    );
    this.distance = 0;
    for (const point of points) {
      const from = sub(point, this.focal);
      const wide = Math.abs(dot(from, this.right)) / (slope * aspect);
      const tall = Math.abs(dot(from, this.up)) / slope;
      this.distance = Math.max(this.distance, dot(from, this.eye) + 1.12 * Math.max(wide, tall));
    }
  }

  /** Near and far enough for everything, wherever the camera is. */
  clipping() {
    const depth = dot(sub(this.position, this.centre), this.eye);
    return [
      Math.max(depth - this.reach, 0.01 * this.reach),
      Math.max(depth + this.reach, 0.1 * this.reach),
    ];
  }

  /** The ray through the pixel (x, y) of a view of that size. */
  ray(x, y, width, height) {
    const across = ((2 * x) / width - 1) * slope * (width / height);
    const upwards = (1 - (2 * y) / height) * slope;
    const towards = add(times(across, this.right), times(upwards, this.up));
    return { origin: this.position, direction: unit(sub(towards, this.eye)) };
  }

  /** Pixel of a point and its depth in front of the camera. */
  project(point, width, height) {
    const from = sub(point, this.position);
    const depth = -dot(from, this.eye);
    const step = height / (2 * slope * depth);
    return [
      width / 2 + step * dot(from, this.right),
      height / 2 - step * dot(from, this.up),
      depth,
    ];
  }

  /** Length of the scene that a pixel shows at the middle. */
  perPixel(height) {
    return (2 * slope * this.distance) / height;
  }
}
