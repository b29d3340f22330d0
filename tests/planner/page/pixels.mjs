// Pixels of the page as they are on the screen.

/** The picture of an element: {width, height, at(x, y) -> [r, g, b]}, in pixels of the page. */
export async function pixelsOf(page, selector) {
  const png = await page.locator(selector).screenshot();
  const { width, height, data } = await decode(page, png);
  const bytes = Buffer.from(data, "base64");
  const at = (x, y) => [...bytes.subarray(4 * (y * width + x), 4 * (y * width + x) + 3)];
  return { width, height, at };
}

// The browser reads its own PNG. A page without a content policy does it: the tested one stays as
// it is.
async function decode(page, png) {
  const reader = await page.context().newPage();
  try {
    return await reader.evaluate(async (text) => {
      const image = new Image();
      image.src = `data:image/png;base64,${text}`;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      let bytes = "";
      for (let i = 0; i < data.length; i += 8192)
        bytes += String.fromCharCode(...data.subarray(i, i + 8192));
      return { width: image.width, height: image.height, data: btoa(bytes) };
    }, png.toString("base64"));
  } finally {
    await reader.close();
  }
}

/** All pixels of a part {x, y, width, height} that `is` takes, as [x, y]. */
export function find(picture, part, is) {
  const found = [];
  const { x = 0, y = 0, width = picture.width, height = picture.height } = part;
  for (let j = Math.ceil(y); j < y + height - 1; j++)
    for (let i = Math.ceil(x); i < x + width - 1; i++)
      if (is(...picture.at(i, j))) found.push([i, j]);
  return found;
}

/** The share of pixels of a part that differ by more than `step` in some colour. */
export function changed(before, after, part, step = 12) {
  let count = 0;
  let all = 0;
  const { x = 0, y = 0, width = before.width, height = before.height } = part;
  for (let j = Math.ceil(y); j < y + height - 1; j++)
    for (let i = Math.ceil(x); i < x + width - 1; i++) {
      const [a, b] = [before.at(i, j), after.at(i, j)];
      all++;
      if (a.some((value, k) => Math.abs(value - b[k]) > step)) count++;
    }
  return count / all;
}

/** The pixel in the middle of those found at one height: `share` 0 is the top, 1 the bottom. */
export function middleAt(found, share) {
  const rows = [...new Set(found.map(([, y]) => y))].sort((a, b) => a - b);
  const row = rows[Math.round(share * (rows.length - 1))];
  const columns = found.filter(([, y]) => y === row).map(([x]) => x);
  return [columns[Math.floor(columns.length / 2)], row];
}

// Whether there is ink at 24 x 24 places of the box around what was found, and how slim the box is.
function shapeOf(found) {
  const low = [0, 1].map((k) => Math.min(...found.map((one) => one[k])));
  const size = [0, 1].map((k) => Math.max(...found.map((one) => one[k])) + 1 - low[k]);
  const ink = new Set(found.map(String));
  const places = Array.from({ length: 576 }, (_, i) => [i % 24, Math.floor(i / 24)]);
  return {
    ink: places.map((at) =>
      ink.has(String(at.map((one, k) => low[k] + Math.floor(((one + 0.5) / 24) * size[k])))),
    ),
    slim: size[0] / size[1],
  };
}

/** Which of the words is written where a picture was found to have ink: bold, upright. */
export async function wordOf(page, found, words) {
  const reader = await page.context().newPage();
  try {
    const style = "font: bold 40px Arial; color: black; background: white; padding: 4px";
    await reader.setContent(
      "<meta name=viewport content=width=device-width><body style=background:white>" +
        words.map((word, k) => `<span id="w${k}" style="${style}">${word}</span>`).join(" "),
    );
    const seen = shapeOf(found);
    const unlike = [];
    for (const k of words.keys()) {
      const written = shapeOf(find(await pixelsOf(reader, `#w${k}`), {}, (r) => r < 128));
      unlike[k] =
        written.ink.filter((ink, i) => ink !== seen.ink[i]).length +
        300 * Math.abs(written.slim - seen.slim);
    }
    return words[unlike.indexOf(Math.min(...unlike))];
  } finally {
    await reader.close();
  }
}
