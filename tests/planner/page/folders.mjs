// Folders that other commands wrote, opened in the page.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { readFile, writeFile } from "node:fs/promises";
import { join, resolve } from "node:path";
import { promisify } from "node:util";
import { root } from "./program.mjs";
import {
  badge,
  folder,
  halves,
  isVein,
  openSource,
  predicted,
  programTest,
  wide,
  withPage,
} from "./steps.mjs";
import { find, pixelsOf } from "./pixels.mjs";

const vasorod = (...words) =>
  promisify(execFile)(resolve(process.env.VASOROD_PROGRAM), words, { cwd: folder });

async function explore() {
  const scene = await readFile(join(folder, "infant.yaml"), "utf8");
  const options = "explore: {cut_along: [0.74, 0.78], stages: [skin]}\n";
  await writeFile(join(folder, "options.yaml"), scene + options);
  await vasorod("explore", "options.yaml", "-o", "explored", "--no-report", "-q");
}

programTest(
  "the options of an exploration are listed together, looked at and compared",
  ["explored"],
  explore,
  async (address) => {
    await withPage(address, wide, async (page) => {
      await predicted(page);
      assert.equal(await page.locator("#result-title").textContent(), "Result");
      await page.locator("#open").click();
      await page.locator("#sources h3", { hasText: "explored" }).waitFor();
      const options = page.locator("#sources h3:text-is('explored') ~ button", { hasText: "skin" });
      assert.equal(await options.count(), 2);
      const other = options.and(page.locator(":not([aria-current])")).locator("strong");
      const name = await other.textContent();
      await page.getByRole("button", { name: "Close", exact: true }).click();

      await page.locator("#keep-plan").click();
      await openSource(page, name);
      await page.locator("#scene-file", { hasText: name }).waitFor();
      await predicted(page);
      assert.match(await badge(page, 0).textContent(), /^Quick: /);
      const rows = page.locator("#comparison tbody tr");
      assert.equal(await rows.count(), 2);
      const numbers = await rows.evaluateAll((all) =>
        all.map((row) => [...row.querySelectorAll("td.number")].map((cell) => cell.textContent)),
      );
      assert.notDeepEqual(numbers[0], numbers[1], "the options have other numbers");
      for (const id of ["save", "undo", "lock"])
        assert.ok(await page.locator(`#${id}`).isDisabled(), "a result has no plan to change");
      assert.ok(await page.locator("#predict").isHidden());
      await page.getByRole("button", { name: "Show in the second view Plan A" }).click();
      const picture = await pixelsOf(page, "#stage");
      for (const part of await halves(page))
        assert.ok(find(picture, part, isVein).length > 500, "both options are drawn");
    });
  },
);

programTest(
  "a fitted vessel is not said to be solved",
  ["fitted"],
  () => vasorod("fit", join(root, "meshes/infant/svc.vtp"), "-o", "fitted", "-q"),
  async (address) => {
    await withPage(address, wide, async (page) => {
      await predicted(page, "Fitted");
      assert.equal(await badge(page, 0).textContent(), "Fitted: nothing solved");
      assert.deepEqual(await page.locator(".badges .badge").allTextContents(), [
        "Fitted at rest, nothing solved",
      ]);
      assert.equal(await page.locator(".badge.good").count(), 0);
    });
  },
);
