// Mouse, pen and fingers over the views. A press that moves turns the camera or drags a marker; one
// that does not is a click.

const still = 4; // pixels that a click may wander

/**
 * `on` has grab(pane, x, y, touch) -> what is grabbed or null, drag(grabbed, pane, x, y),
 * drop(grabbed), click(pane, x, y), hover(pane, x, y) and leave().
 */
export function followPointers(surface, stage, camera, on) {
  const pressed = new Map();
  let grabbed = null;
  let start = null; // of the first pointer, until it has moved
  let pane = null;

  const place = (event) => {
    const box = surface.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };

  surface.addEventListener("pointerdown", (event) => {
    const [x, y] = place(event);
    surface.focus({ preventScroll: true });
    surface.setPointerCapture(event.pointerId);
    pressed.set(event.pointerId, [x, y]);
    if (pressed.size > 1) {
      start = null; // two fingers never click
      if (grabbed) on.drop(grabbed);
      grabbed = null;
      return;
    }
    pane = stage.paneAt(x, y);
    start = event.button === 0 ? [x, y] : null;
    if (pane && event.button === 0) grabbed = on.grab(pane, x, y, event.pointerType === "touch");
  });

  const lift = (event) => {
    if (!pressed.delete(event.pointerId)) return;
    const [x, y] = place(event);
    if (grabbed) on.drop(grabbed);
    else if (start && pane && event.type === "pointerup") on.click(pane, x, y);
    grabbed = null;
    start = null;
  };
  surface.addEventListener("pointerup", lift);
  surface.addEventListener("pointercancel", lift);

  surface.addEventListener("pointermove", (event) => {
    const now = place(event);
    const before = pressed.get(event.pointerId);
    if (!before) {
      const over = stage.paneAt(...now);
      if (over && event.pointerType !== "touch") on.hover(over, ...now);
      return;
    }
    if (start && Math.hypot(now[0] - start[0], now[1] - start[1]) > still) start = null;
    if (grabbed) {
      if (!start) on.drag(grabbed, pane, ...now);
    } else if (!start && pane) {
      const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
      if (pressed.size === 1) {
        if (event.buttons & 6 || event.shiftKey) camera.pan(dx, dy, pane.rect.height);
        else camera.turn(0.008 * dx, 0.008 * dy);
      } else {
        const other = [...pressed].find(([id]) => id !== event.pointerId)[1];
        const apart = (at) => Math.max(1, Math.hypot(at[0] - other[0], at[1] - other[1]));
        camera.zoom(apart(before) / apart(now));
        camera.pan(dx / 2, dy / 2, pane.rect.height);
      }
      on.leave();
      stage.draw();
    } else return; // not yet a drag: the way so far still counts for the camera
    pressed.set(event.pointerId, now);
  });

  surface.addEventListener("pointerleave", () => on.leave());
  surface.addEventListener("contextmenu", (event) => event.preventDefault());
  surface.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      camera.zoom(Math.exp(0.0012 * event.deltaY));
      stage.draw();
    },
    { passive: false },
  );
  surface.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[
      event.key
    ];
    if (way && event.shiftKey) camera.pan(20 * way[0], 20 * way[1], stage.height);
    else if (way) camera.turn(0.1 * way[0], 0.1 * way[1]);
    else if (event.key === "+" || event.key === "=") camera.zoom(0.9);
    else if (event.key === "-") camera.zoom(1.1);
    else return;
    event.preventDefault();
    stage.draw();
  });
}
