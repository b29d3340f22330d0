// The small cube in the corner of a view. Its faces are named after the patient's sides, or after
// the axes where the surfaces name no space.
import vtkAnnotatedCubeActor from "@kitware/vtk.js/Rendering/Core/AnnotatedCubeActor.js";
import vtkOrientationMarkerWidget from "@kitware/vtk.js/Interaction/Widgets/OrientationMarkerWidget.js";

const size = 84; // pixels of the page

const faces = ["XPlus", "XMinus", "YPlus", "YMinus", "ZPlus", "ZMinus"];
const names = {
  LPS: ["L", "R", "P", "A", "S", "I"],
  RAS: ["R", "L", "A", "P", "S", "I"],
  "": ["+X", "−X", "+Y", "−Y", "+Z", "−Z"],
};

// Degrees that put the names upright: z is up at the sides; from the top and from below y is down
// in LPS and up elsewhere, as the views of the buttons have it.
const rotations = (space) => [90, -90, 180, 0, ...(space === "LPS" ? [180, 0] : [0, 180])];

export class Cube {
  #actor = vtkAnnotatedCubeActor.newInstance();
  #marker;

  constructor(interactor, renderer) {
    this.#actor.getProperty().setAmbient(0.5);
    this.#actor.getProperty().setDiffuse(0.5);
    this.#marker = vtkOrientationMarkerWidget.newInstance({
      actor: this.#actor,
      interactor,
      parentRenderer: renderer,
    });
    this.#marker.setEnabled(true);
  }

  /** `paper`, `ink` and `edge` are colours of the style sheet. */
  name(space, { paper, ink, edge }) {
    this.#actor.setDefaultStyle({
      faceColor: paper,
      fontColor: ink,
      fontStyle: "bold",
      fontSizeScale: (resolution) => resolution / (space ? 1.4 : 1.8),
      edgeColor: edge,
      edgeThickness: 0.06,
    });
    faces.forEach((face, k) =>
      this.#actor[`set${face}FaceProperty`]({
        text: names[space][k],
        faceRotation: rotations(space)[k],
      }),
    );
  }

  /** Follows its view in place and size. */
  place(shown, ratio) {
    this.#marker.getRenderer().setDraw(shown);
    this.#marker.set({ minPixelSize: size * ratio, maxPixelSize: size * ratio });
    this.#marker.updateViewport();
  }
}
