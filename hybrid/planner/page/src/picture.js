// The views as a PNG file, twice as large as on the page, with what is drawn over them and what the
// heads of the views say.
import { drawOverlay } from "./overlay.js";

const scale = 2;
const foot = 26;

/** `heads`: the text over each view; `note`: the line below. Gives the file's bytes as a blob. */
export async function pictureOf(stage, camera, theme, shown, heads, note) {
  const sheet = document.createElement("canvas");
  sheet.width = Math.round(stage.width * scale);
  sheet.height = Math.round((stage.height + foot) * scale);
  const context = sheet.getContext("2d");
  context.fillStyle = theme.ground;
  context.fillRect(0, 0, sheet.width, sheet.height);
  stage.capture(scale, (canvas) => context.drawImage(canvas, 0, 0));
  context.scale(scale, scale);
  drawOverlay(context, stage, camera, theme, shown);
  context.textBaseline = "middle";
  context.textAlign = "left";
  stage.shown.forEach(({ rect }, k) => {
    context.font = '600 14px system-ui, "DejaVu Sans", sans-serif';
    context.fillStyle = theme.ink;
    context.fillText(heads[k], rect.x + 12, rect.y + 20);
  });
  context.font = '400 12px system-ui, "DejaVu Sans", sans-serif';
  context.fillStyle = theme.soft;
  context.fillText(note, 12, stage.height + foot / 2);
  return new Promise((give) => sheet.toBlob(give, "image/png"));
}

export function download(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
