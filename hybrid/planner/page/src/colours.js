// Values to colours: the maps and the marks of the legend are those of report.html
// (hybrid/report/colour_scale.cpp).

const parse = (text) => text.split(" ").map((hex) => parseInt(hex, 16));

// Moreland's cool-warm (2009), and the light part of matplotlib's magma (CC0) in reverse order.
export const maps = {
  diverging: parse(
    "3b4cc0 4e68d8 6282ea 779af7 8db0fe a3c2fe b9d0f9 ccd9ed dddcdc " +
      "ecd3c5 f5c4ac f7b093 f4987a eb7d62 dd5f4b ca3b37 b40426",
  ),
  sequential: parse(
    "fcf0b2 fed89a fec185 fea772 fc8e64 f8765c f05f5e e24d66 cf4070 " +
      "ba3878 a5317e 8e2a81 792282 651a80 51127c 3b0f70 251255",
  ),
  // For values that say nothing; its legend has no numbers.
  grey: parse("e4e4e4 8a8a8a"),
};

export const cssColour = (rgb) => "#" + rgb.toString(16).padStart(6, "0");

/** Red, green and blue (0 to 255) of each value; values that are not finite are grey. */
export function colourValues(values, map, [low, high]) {
  const steps = maps[map];
  const last = steps.length - 1;
  const colours = new Uint8Array(3 * values.length);
  for (let i = 0; i < values.length; i++) {
    if (!Number.isFinite(values[i])) {
      colours.fill(128, 3 * i, 3 * i + 3);
      continue;
    }
    const at = Math.min(1, Math.max(0, (values[i] - low) / (high - low))) * last;
    const first = Math.min(Math.floor(at), last - 1);
    for (let k = 0; k < 3; k++) {
      const shift = 16 - 8 * k;
      const a = (steps[first] >> shift) & 255;
      const b = (steps[first + 1] >> shift) & 255;
      colours[3 * i + k] = Math.round(a + (at - first) * (b - a));
    }
  }
  return colours;
}

/** About five round values inside the range, as {value, text}. */
export function ticksOf(low, high) {
  if (!(high > low)) return [];
  const power = 10 ** Math.floor(Math.log10((high - low) / 4));
  const step = [5, 2, 1].map((one) => one * power).find((one) => one <= (high - low) / 4) ?? power;
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const ticks = [];
  const slack = 1e-9 * (high - low);
  for (let k = Math.ceil((low - slack) / step); k * step <= high + slack; k++) {
    const value = k === 0 ? 0 : k * step;
    const text = digits > 4 ? value.toPrecision(3) : value.toFixed(digits);
    ticks.push({ value, text: (value === 0 ? "0" : text).replace("-", "−") });
  }
  return ticks;
}

// The two joined vessels, then what lies beside them, as in report.html.
const veins = [0x6b99d9, 0x9e91d4, 0x6bb3a8, 0xdbb36b, 0x99b876];
const arteries = [0xd9736b, 0xc78f80, 0xcc8094];

/** A colour for every vessel by its name. */
export function vesselColours(vessels) {
  const colours = new Map();
  const joined = vessels.some((vessel) => vessel.part);
  let beside = 0;
  let others = 0;
  for (const { name, part, role } of vessels)
    if (part) colours.set(name, veins[part === "svc" ? 0 : 1]);
    else if (joined || role === "obstacle") colours.set(name, arteries[beside++ % arteries.length]);
    else colours.set(name, veins[others++ % veins.length]);
  return colours;
}

export const parts = (rgb) => [(rgb >> 16) / 255, ((rgb >> 8) & 255) / 255, (rgb & 255) / 255];
