// The drawing area: one or two views of the scene with one camera, drawn into one canvas.
import "@kitware/vtk.js/Rendering/OpenGL/Profiles/Geometry.js";
import vtkOpenGLRenderWindow from "@kitware/vtk.js/Rendering/OpenGL/RenderWindow.js";
import vtkPlane from "@kitware/vtk.js/Common/DataModel/Plane.js";
import vtkInteractor from "@kitware/vtk.js/Rendering/Core/RenderWindowInteractor.js";
import vtkRenderWindow from "@kitware/vtk.js/Rendering/Core/RenderWindow.js";
import vtkRenderer from "@kitware/vtk.js/Rendering/Core/Renderer.js";
import { Body } from "./body.js";
import { viewAngle } from "./camera.js";
import { Cube } from "./cube.js";
import { hitOfRay } from "./geometry.js";

/** One view: what it shows, the surfaces of its vessels and the lines drawn over them. */
export class Pane {
  renderer = vtkRenderer.newInstance();
  subject = null;
  rect = { x: 0, y: 0, width: 1, height: 1 }; // in pixels of the page, from the stage's corner
  #bodies = new Map();
  #extras = new Map();
  #clip = null;

  /** Shows a subject: {meshes: name -> {points, triangles}}. */
  setSubject(subject) {
    if (subject === this.subject) return;
    for (const body of this.#bodies.values()) body.remove();
    this.#bodies.clear();
    this.subject = subject;
    for (const [name, mesh] of subject?.meshes ?? [])
      this.#bodies.set(name, new Body(this.renderer, mesh, { borders: true }));
    this.#applyClip();
  }

  get bodies() {
    return this.#bodies;
  }

  /** Lines and balls over the vessels: {mesh, colour}, or null to take them away. */
  setExtra(name, parts) {
    for (const body of this.#extras.get(name) ?? []) body.remove();
    this.#extras.set(
      name,
      (parts ?? []).map(({ mesh, colour }) => {
        const body = new Body(this.renderer, mesh, { plain: true });
        body.paint(colour);
        return body;
      }),
    );
  }

  /** Hides what lies behind the plane, seen along its normal; null shows everything. */
  setClip(plane) {
    this.#clip = plane && vtkPlane.newInstance({ origin: plane.point, normal: plane.normal });
    this.#applyClip();
  }

  #applyClip() {
    for (const body of this.#bodies.values()) body.clip(this.#clip ? [this.#clip] : []);
  }

  /** The nearest wall on a ray among the named vessels: vessel, mesh, point, triangle, weights. */
  hit(ray, names) {
    let best = null;
    for (const [vessel, mesh] of this.subject?.meshes ?? []) {
      if (!names.has(vessel)) continue;
      const hit = hitOfRay(ray, mesh);
      if (hit && (!best || hit.distance < best.distance)) best = { ...hit, vessel, mesh };
    }
    return best;
  }
}

/** Calls `drawOver(stage)` after every drawing. */
export class Stage {
  panes = [new Pane(), new Pane()];
  count = 1;
  #window = vtkRenderWindow.newInstance();
  #view;
  #cubes;
  #container;
  #camera;
  #drawOver;
  #asked = false;

  constructor(container, camera, drawOver) {
    this.#container = container;
    this.#camera = camera;
    this.#drawOver = drawOver;
    this.#view = vtkOpenGLRenderWindow.newInstance();
    this.#window.addView(this.#view);
    this.#view.setContainer(container);
    for (const { renderer } of this.panes) {
      this.#window.addRenderer(renderer);
      renderer.setActiveCamera(this.panes[0].renderer.getActiveCamera());
    }
    // The cubes ask it for the view; the pointers are followed by the page itself.
    const interactor = vtkInteractor.newInstance();
    interactor.setView(this.#view);
    interactor.initialize();
    this.#cubes = this.panes.map(({ renderer }) => new Cube(interactor, renderer));
    this.#view.getCanvas().setAttribute("aria-hidden", "true");
    new ResizeObserver(() => this.resize()).observe(container);
  }

  get width() {
    return this.#container.clientWidth;
  }

  get height() {
    return this.#container.clientHeight;
  }

  get shown() {
    return this.panes.slice(0, this.count);
  }

  resize() {
    const ratio = window.devicePixelRatio || 1;
    this.#view.setSize(
      Math.max(1, Math.round(this.width * ratio)),
      Math.max(1, Math.round(this.height * ratio)),
    );
    this.layout(this.count);
  }

  /** Two views lie beside each other, in a narrow page above each other. */
  layout(count) {
    this.count = count;
    const { width, height } = this;
    const above = width < 560;
    this.panes.forEach((pane, k) => {
      const shown = k < count;
      pane.renderer.setDraw(shown);
      if (!shown) return;
      const [columns, rows] = count === 1 ? [1, 1] : above ? [1, 2] : [2, 1];
      const [column, row] = above ? [0, k] : [k, 0];
      pane.rect = {
        x: (column * width) / columns,
        y: (row * height) / rows,
        width: width / columns,
        height: height / rows,
      };
      pane.renderer.setViewport(
        column / columns,
        1 - (row + 1) / rows,
        (column + 1) / columns,
        1 - row / rows,
      );
    });
    this.#cubes.forEach((cube, k) => cube.place(k < count, window.devicePixelRatio || 1));
    this.draw();
  }

  paneAt(x, y) {
    return this.shown.find(
      ({ rect }) =>
        x >= rect.x && x < rect.x + rect.width && y >= rect.y && y < rect.y + rect.height,
    );
  }

  rayAt(pane, x, y) {
    const { rect } = pane;
    return this.#camera.ray(x - rect.x, y - rect.y, rect.width, rect.height);
  }

  /** Pixel of a point in a pane, from the stage's corner, with its depth. */
  project(pane, point) {
    const { rect } = pane;
    const [x, y, depth] = this.#camera.project(point, rect.width, rect.height);
    return [x + rect.x, y + rect.y, depth];
  }

  setBackground(colour) {
    for (const { renderer } of this.panes) renderer.setBackground(...colour);
  }

  /** The cubes' names and colours. */
  setCubes(space, colours) {
    for (const cube of this.#cubes) cube.name(space, colours);
  }

  draw() {
    if (this.#asked) return;
    this.#asked = true;
    requestAnimationFrame(() => {
      this.#asked = false;
      this.#render();
      this.#drawOver(this);
    });
  }

  #render() {
    const camera = this.panes[0].renderer.getActiveCamera();
    camera.setViewAngle(viewAngle);
    camera.setPosition(...this.#camera.position);
    camera.setFocalPoint(...this.#camera.focal);
    camera.setViewUp(...this.#camera.up);
    camera.setClippingRange(...this.#camera.clipping());
    this.#window.render();
  }

  /** The picture alone, `scale` times as large as on the page, given to `use` as a canvas. */
  capture(scale, use) {
    const size = this.#view.getSize();
    this.#view.setSize(Math.round(this.width * scale), Math.round(this.height * scale));
    this.#render();
    // Read in the same turn: the canvas keeps its pixels only until the next frame.
    const made = use(this.#view.getCanvas());
    this.#view.setSize(...size);
    this.#render();
    return made;
  }
}
