// One surface in a view, drawn by vtk.js: smooth, in one colour or a colour for every vertex.
import vtkActor from "@kitware/vtk.js/Rendering/Core/Actor.js";
import vtkCellArray from "@kitware/vtk.js/Common/Core/CellArray.js";
import vtkDataArray from "@kitware/vtk.js/Common/Core/DataArray.js";
import vtkMapper from "@kitware/vtk.js/Rendering/Core/Mapper.js";
import vtkPolyData from "@kitware/vtk.js/Common/DataModel/PolyData.js";
import { borderEdges, vertexNormals } from "./geometry.js";

function actorOf(data) {
  const mapper = vtkMapper.newInstance();
  mapper.setInputData(data);
  mapper.setColorModeToDirectScalars();
  mapper.setScalarVisibility(false);
  const actor = vtkActor.newInstance();
  actor.setMapper(mapper);
  return actor;
}

function cellsOf(flat, size) {
  const count = flat.length / size;
  const cells = new Uint32Array(count * (size + 1));
  for (let i = 0; i < count; i++) {
    cells[i * (size + 1)] = size;
    for (let k = 0; k < size; k++) cells[i * (size + 1) + k + 1] = flat[size * i + k];
  }
  return vtkCellArray.newInstance({ values: cells });
}

/** A surface with the dark lines of its open borders, as in report.html. */
export class Body {
  #renderer;
  #data = vtkPolyData.newInstance();
  #surface;
  #border = null;

  constructor(renderer, { points, triangles }, { borders = false, plain = false } = {}) {
    this.#renderer = renderer;
    this.#data.getPoints().setData(points, 3);
    this.#data.setPolys(cellsOf(triangles, 3));
    const normals = vertexNormals(points, triangles);
    this.#data
      .getPointData()
      .setNormals(
        vtkDataArray.newInstance({ name: "Normals", values: normals, numberOfComponents: 3 }),
      );
    this.#surface = actorOf(this.#data);
    const look = this.#surface.getProperty();
    look.setInterpolationToPhong();
    look.setAmbient(plain ? 0.75 : 0.3);
    look.setDiffuse(plain ? 0.3 : 0.68);
    look.setSpecular(plain ? 0 : 0.1);
    look.setSpecularPower(32);
    renderer.addActor(this.#surface);
    if (borders) this.#addBorder(points, triangles);
  }

  #addBorder(points, triangles) {
    const edges = borderEdges(triangles).flat();
    if (edges.length === 0) return;
    const data = vtkPolyData.newInstance();
    data.getPoints().setData(points, 3);
    data.setLines(cellsOf(edges, 2));
    this.#border = actorOf(data);
    this.#border.getMapper().setResolveCoincidentTopologyToPolygonOffset();
    this.#border.getMapper().setRelativeCoincidentTopologyLineOffsetParameters(-2, -2);
    this.#border.getProperty().setColor(0.1, 0.1, 0.12);
    this.#border.getProperty().setLighting(false);
    this.#renderer.addActor(this.#border);
  }

  /** One colour (three numbers from 0 to 1). */
  paint(colour) {
    this.#surface.getMapper().setScalarVisibility(false);
    this.#surface.getProperty().setColor(...colour);
  }

  /** Three bytes for every vertex. */
  paintVertices(bytes) {
    const colours = vtkDataArray.newInstance({
      name: "Colours",
      values: bytes,
      numberOfComponents: 3,
    });
    this.#data.getPointData().setScalars(colours);
    this.#surface.getMapper().setScalarVisibility(true);
    this.#data.modified();
  }

  show(visible, opacity) {
    const seen = visible && opacity > 0;
    this.#surface.setVisibility(seen);
    this.#surface.getProperty().setOpacity(opacity);
    this.#border?.setVisibility(seen && opacity > 0.6);
  }

  /** Hides what lies on the side of the planes to which their normals do not point. */
  clip(planes) {
    for (const actor of [this.#surface, this.#border]) {
      if (!actor) continue;
      actor.getMapper().removeAllClippingPlanes();
      for (const plane of planes) actor.getMapper().addClippingPlane(plane);
    }
  }

  remove() {
    for (const actor of [this.#surface, this.#border]) {
      if (!actor) continue;
      this.#renderer.removeActor(actor);
      actor.getMapper().delete();
      actor.delete();
    }
    this.#data.delete();
  }
}
