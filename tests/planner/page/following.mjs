// What follows a change of the plan, in which order, and what is said of it meanwhile.
import assert from "node:assert/strict";
import { find, middleAt, pixelsOf } from "./pixels.mjs";
import {
  badge,
  colouredPixels,
  delay,
  halves,
  isVein,
  pageTest,
  predicted,
  setNumber,
  value,
  wide,
} from "./steps.mjs";

/**
 * Changes the plan with the paper model to follow; the program's jobs answer late. Gives the models
 * that the page asks for, in their order.
 */
async function changeWithDetail(page, milliseconds) {
  const models = [];
  page.on("request", (request) => {
    if (request.url().endsWith("api/solve")) models.push(request.postDataJSON().fidelity);
  });
  await page.selectOption("#follow", { label: "Quick, then Paper model" });
  await delay(page, /api\/job\//, milliseconds);
  await setNumber(page, "cut-along", "72");
  return models;
}

pageTest("a quick prediction is followed by the detailed one", wide, async (page) => {
  await predicted(page);
  const models = await changeWithDetail(page, 1000);
  await page.locator("#progress-text", { hasText: /^Paper model:/ }).waitFor();
  // The quick one is already there.
  assert.match(await page.locator(".badges").textContent(), /Quick \(skin\)/);
  await predicted(page, "Paper model");
  assert.match(await page.locator(".badges").textContent(), /Paper model \(paper\)/);
  assert.deepEqual(models, ["skin", "paper"]);
  // The first plan has its quick prediction; what is known of the second one is not asked again.
  await page.locator("#undo").click();
  await predicted(page, "Paper model");
  await page.locator("#redo").click();
  await predicted(page, "Paper model");
  assert.deepEqual(models, ["skin", "paper", "paper"]);
});

pageTest("Esc during the quick prediction ends the detailed one as well", wide, async (page) => {
  await predicted(page);
  const models = await changeWithDetail(page, 2000);
  await page.locator("#progress").waitFor({ state: "visible" });
  await page.locator("#surface").focus();
  await page.keyboard.press("Escape");
  await page.locator("#progress").waitFor({ state: "hidden" });
  await page.waitForTimeout(1000);
  assert.deepEqual(models, ["skin"]);
});

pageTest(
  "a detailed prediction that fails leaves the quick one",
  wide,
  async (page, { faults }) => {
    await predicted(page);
    const before = await badge(page).textContent();
    await page.route(/api\/solve$/, (route) =>
      route.fulfill({ status: 400, json: { error: "The paper model found no way." } }),
    );
    await page.locator("#solve-paper").click();
    await page.getByText("The last prediction failed").waitFor();
    assert.match(await page.locator("#result").textContent(), /The paper model found no way\./);
    assert.equal(await badge(page).textContent(), before);
    assert.ok(await page.locator("#keep-plan").isEnabled());
    assert.ok(
      faults.splice(0).every((text) => /400/.test(text)),
      "the refusal alone is noted",
    );
  },
);

pageTest("an answer that comes late changes nothing", wide, async (page) => {
  await predicted(page);
  const begin = await value(page, "cut-along");
  await delay(page, /api\/result\/[^/]+$/, 1500);
  const asked = page.waitForRequest(/api\/result\/[^/]+$/);
  await setNumber(page, "cut-along", "72");
  await asked;
  await page.locator("#undo").click();
  assert.equal(await value(page, "cut-along"), begin);
  await page.waitForTimeout(2500);
  assert.match(await badge(page).textContent(), /^Quick: /);
  assert.ok(await page.locator("#keep-plan").isEnabled());
});

pageTest("an old prediction is grey while a detailed one runs", wide, async (page) => {
  await predicted(page);
  await page.selectOption("#follow", { label: "Nothing" });
  await page.selectOption("#colour", "TwistShear");
  await page.waitForTimeout(300);
  assert.ok((await colouredPixels(page)).length > 500);
  await delay(page, /api\/job\//, 4000);
  await setNumber(page, "cut-along", "72");
  await page.locator("#head-1 .badge", { hasText: "earlier plan" }).waitFor();
  await page.locator("#solve-paper").click();
  await page.locator("#head-1 .badge", { hasText: "predicting" }).waitFor();
  await page.waitForTimeout(300);
  assert.deepEqual(await colouredPixels(page), [], "no colour says anything");
  const status = page.locator("#comparison tbody .badge");
  assert.equal(await status.textContent(), "predicting…");
  assert.ok(await status.evaluate((one) => one.classList.contains("plain")));
  const [said, plain] = await page.evaluate(() =>
    ["#result .badge", "#comparison .badge.plain"].map(
      (one) => getComputedStyle(document.querySelector(one)).color,
    ),
  );
  assert.equal(said, plain, "its state is grey");
  await predicted(page, "Paper model");
  await page.waitForTimeout(300);
  assert.ok((await colouredPixels(page)).length > 500);
});

pageTest("the value under the pointer goes when the pointer goes", wide, async (page) => {
  await predicted(page);
  const [left] = await halves(page);
  const place = middleAt(find(await pixelsOf(page, "#stage"), left, isVein), 0.25);
  const stayed = await page.evaluate(async ([x, y]) => {
    const surface = document.getElementById("surface");
    const box = surface.getBoundingClientRect();
    const at = { clientX: box.left + x, clientY: box.top + y, pointerId: 1, pointerType: "mouse" };
    surface.dispatchEvent(new PointerEvent("pointermove", at));
    surface.dispatchEvent(new PointerEvent("pointerleave", at));
    for (let k = 0; k < 3; k++) await new Promise(requestAnimationFrame);
    return !document.getElementById("tip").hidden;
  }, place);
  assert.equal(stayed, false);
});
