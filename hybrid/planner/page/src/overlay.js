// What is drawn over the 3D picture: markers, ruler, scale bar and legend. The same drawing goes into
// saved pictures.
import { cssColour, maps, ticksOf } from "./colours.js";
import { distance } from "./vectors.js";
import { numberText } from "./words.js";

const font = (size, weight = 400) => `${weight} ${size}px system-ui, "DejaVu Sans", sans-serif`;

// Text with a border in the colour of the ground, so that it reads over the vessels.
function label(
  context,
  text,
  x,
  y,
  theme,
  { size = 12, weight = 400, align = "left", colour } = {},
) {
  context.font = font(size, weight);
  context.textAlign = align;
  context.textBaseline = "middle";
  context.lineJoin = "round";
  context.lineWidth = 4;
  context.strokeStyle = theme.ground;
  context.strokeText(text, x, y);
  context.fillStyle = colour ?? theme.ink;
  context.fillText(text, x, y);
}

function line(context, from, to, colour, width) {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.beginPath();
  context.moveTo(from[0], from[1]);
  context.lineTo(to[0], to[1]);
  context.stroke();
}

function disc(context, [x, y], radius, fill, edge, width = 2) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = fill;
  context.fill();
  if (!edge) return;
  context.lineWidth = width;
  context.strokeStyle = edge;
  context.stroke();
}

function drawDot(context, at, { hot, colour }, theme) {
  disc(context, at, hot ? 9 : 7, colour, theme.ground, 4);
  disc(context, at, hot ? 9 : 7, colour, "#1d2126", 1.5);
}

// A marker that a solid wall hides is a ring.
function drawMarker(context, stage, pane, marker, theme) {
  const at = stage.project(pane, marker.point);
  if (!(at[2] > 0)) return;
  const text = marker.label && marker.hidden ? `${marker.label} (behind)` : marker.label;
  if (marker.hidden) disc(context, at, 7, "transparent", marker.colour, 3);
  else drawDot(context, at, marker, theme);
  const [x, align] = marker.left ? [at[0] - 13, "right"] : [at[0] + 13, "left"];
  if (text) label(context, text, x, at[1], theme, { weight: 600, align });
}

function drawRuler(context, stage, pane, points, unit, theme) {
  const places = points.map((point) => stage.project(pane, point));
  if (places.length === 2) {
    line(context, places[0], places[1], theme.ground, 5);
    line(context, places[0], places[1], theme.accent, 2);
  }
  for (const place of places) disc(context, place, 4, theme.accent, theme.ground);
  if (places.length < 2) return;
  const text = `${numberText(distance(points[0], points[1]))} ${unit}`;
  const middle = [(places[0][0] + places[1][0]) / 2, (places[0][1] + places[1][1]) / 2];
  label(context, text, middle[0], middle[1] - 12, theme, {
    size: 13,
    weight: 600,
    align: "center",
  });
}

// Of two markers side by side, the left one has its label on its left.
function putApart(stage, pane, markers) {
  const places = markers.map(({ point }) => stage.project(pane, point));
  markers.forEach((marker, k) => {
    marker.left = places.some(
      ([x, y], i) =>
        i !== k &&
        Math.abs(y - places[k][1]) < 18 &&
        x - places[k][0] >= 0 &&
        x - places[k][0] < 90,
    );
  });
}

// A round length about a fifth of the view's width.
function drawScaleBar(context, pane, camera, unit, theme) {
  const { rect } = pane;
  const step = camera.perPixel(rect.height);
  const wanted = (rect.width / 5) * step;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const length = [5, 2, 1].map((one) => one * power).find((one) => one <= wanted) ?? power;
  const pixels = length / step;
  const [x, y] = [rect.x + 96, rect.y + rect.height - 22];
  line(context, [x, y], [x + pixels, y], theme.ink, 1.5);
  for (const end of [x, x + pixels]) line(context, [end, y - 4], [end, y + 4], theme.ink, 1.5);
  label(context, `${numberText(length)} ${unit}`, x + pixels / 2, y - 13, theme, {
    align: "center",
  });
}

function drawLegend(context, pane, legend, theme) {
  const { rect } = pane;
  const height = Math.min(220, rect.height - 198);
  if (height < 50) return;
  const x = rect.x + rect.width - 62;
  const y = rect.y + 122; // below a badge of two lines
  const colours = maps[legend.map];
  const ramp = context.createLinearGradient(0, y + height, 0, y);
  colours.forEach((rgb, k) => ramp.addColorStop(k / (colours.length - 1), cssColour(rgb)));
  context.fillStyle = ramp;
  context.fillRect(x, y, 14, height);
  context.strokeStyle = theme.ground;
  context.lineWidth = 1;
  context.strokeRect(x - 0.5, y - 0.5, 15, height + 1);
  const [low, high] = legend.range;
  if (legend.map !== "grey")
    for (const { value, text } of ticksOf(low, high)) {
      const at = y + height * (1 - (value - low) / (high - low));
      line(context, [x + 14, at], [x + 18, at], theme.soft, 1);
      label(context, text, x + 22, at, theme);
    }
  legend.lines.forEach((text, k) =>
    label(
      context,
      text,
      rect.x + rect.width - 10,
      y - 14 - 15 * (legend.lines.length - 1 - k),
      theme,
      { align: "right" },
    ),
  );
}

/**
 * Draws everything. `shown` has, for each pane: markers [{point, label, colour, hot}], ruler
 * (points), legend or null; and the unit of length.
 */
export function drawOverlay(context, stage, camera, theme, shown) {
  stage.shown.forEach((pane, k) => {
    const { markers, ruler, legend } = shown.panes[k];
    context.save();
    context.beginPath();
    context.rect(pane.rect.x, pane.rect.y, pane.rect.width, pane.rect.height);
    context.clip();
    drawScaleBar(context, pane, camera, shown.unit, theme);
    if (legend) drawLegend(context, pane, legend, theme);
    putApart(stage, pane, markers);
    for (const marker of markers) drawMarker(context, stage, pane, marker, theme);
    if (ruler.length > 0) drawRuler(context, stage, pane, ruler, shown.unit, theme);
    context.restore();
  });
  if (stage.count === 2) {
    const { rect } = stage.panes[1];
    const beside = rect.x > 0;
    line(
      context,
      [rect.x, rect.y],
      beside ? [rect.x, rect.y + rect.height] : [rect.x + rect.width, rect.y],
      theme.line,
      2,
    );
  }
}
