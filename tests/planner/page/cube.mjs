// The cube in the corner names the side of the patient that the viewer sees.
import assert from "node:assert/strict";
import { find, pixelsOf, wordOf } from "./pixels.mjs";
import { writeVein } from "./program.mjs";
import { folder, halves, narrow, pageTest, programTest, wide, withPage } from "./steps.mjs";

const sides = ["A", "P", "L", "R", "S", "I"];
const axes = ["+X", "−X", "+Y", "−Y", "+Z", "−Z"];
const isInk = { light: (r) => r < 100, dark: (r) => r > 150 };

/** The word on the face towards the viewer in the lower left corner of a part of the stage. */
async function faceIn(page, { x, y, height }, scheme, words) {
  const face = { x: x + 20, y: y + height - 64, width: 44, height: 44 };
  return wordOf(page, find(await pixelsOf(page, "#stage"), face, isInk[scheme]), words);
}

async function viewFrom(page, key) {
  await page.locator("#surface").focus();
  await page.keyboard.press(key);
  await page.waitForTimeout(300);
}

// Half a turn, as 0.008 radians are a pixel.
async function turnAround(page, dx, dy) {
  const { x, y, width, height } = await page.locator("#stage").boundingBox();
  const [from, to] = [-1, 1].map((way) => [
    x + width / 2 + (way * dx) / 2,
    y + height / 2 + (way * dy) / 2,
  ]);
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: 8 });
  await page.mouse.up();
  await page.waitForTimeout(300);
}

for (const [space, front, left, top, around] of [
  ["LPS", "A", "L", "S", ["P", "R", "I"]],
  ["RAS", "A", "L", "S", ["P", "R", "I"]],
  ["", "+X", "−Y", "+Z", ["−X", "+Y"]],
])
  programTest(
    `the cube names the sides: ${space || "no space"}`,
    [`${space || "no_space"}.yaml`],
    () => writeVein(folder, space),
    async (address) => {
      const words = space ? sides : axes;
      await withPage(address, { ...wide, colorScheme: "light" }, async (page) => {
        for (const [k, side] of [front, left, top].entries()) {
          await viewFrom(page, String(k + 1));
          for (const part of await halves(page))
            assert.equal(await faceIn(page, part, "light", words), side);
          if (!around[k]) continue;
          await turnAround(page, k < 2 ? 393 : 0, k < 2 ? 0 : 393);
          const [part] = await halves(page);
          assert.equal(await faceIn(page, part, "light", words), around[k]);
        }
      });
      await withPage(address, { ...narrow, colorScheme: "dark" }, async (page) => {
        const { height } = await page.locator("#stage").boundingBox();
        const [upper, lower] = [0, 1].map((k) => ({
          x: 0,
          y: (k * height) / 2,
          height: height / 2,
        }));
        await viewFrom(page, "1");
        for (const part of [upper, lower])
          assert.equal(await faceIn(page, part, "dark", words), front);
        await page.locator("#one-view").click();
        await viewFrom(page, "2");
        assert.equal(await faceIn(page, { x: 0, y: 0, height }, "dark", words), left);
      });
    },
  );

pageTest("the cube follows light and dark", { ...wide, colorScheme: "light" }, async (page) => {
  await viewFrom(page, "3");
  const [part] = await halves(page);
  assert.equal(await faceIn(page, part, "light", axes), "+Z");
  await page.emulateMedia({ colorScheme: "dark" });
  await page.waitForTimeout(300);
  assert.equal(await faceIn(page, part, "dark", axes), "+Z");
});
