// The page of vasorod-plan in a real browser against the real program. By hand as ctest calls it:
//   npm ci --prefix tests/planner/page
//   VASOROD_PLAN=build/bin/vasorod-plan node --test tests/planner/page/run.mjs
// Needs chromium (Debian: chromium; another one by CHROMIUM).
import assert from "node:assert/strict";
import { access, readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { join } from "node:path";
import { test } from "node:test";
import "./cube.mjs";
import "./folders.mjs";
import "./following.mjs";
import { changed, find, middleAt, pixelsOf } from "./pixels.mjs";
import { openPage, startProgram } from "./program.mjs";
import {
  badge,
  browser,
  changedFrom,
  clickStage,
  colouredPixels,
  folder,
  halves,
  isArtery,
  isCutMarker,
  isVein,
  narrow,
  openSource,
  pageTest,
  predicted,
  setNumber,
  value,
  wide,
} from "./steps.mjs";

pageTest("the scene is shown and its plan predicted", wide, async (page) => {
  assert.equal(await page.locator("#scene-name").textContent(), "infant");
  assert.ok(await page.getByText("Research software, not for clinical use.").first().isVisible());
  await predicted(page);
  const picture = await pixelsOf(page, "#stage");
  const [left, right] = await halves(page);
  for (const part of [left, right]) {
    assert.ok(find(picture, part, isVein).length > 500, "the vein is drawn");
    assert.ok(find(picture, part, isArtery).length > 500, "the artery is drawn");
  }
  assert.equal(await page.locator(".badges .badge").first().textContent(), "Status: converged");
  assert.ok((await page.locator("#criteria tbody tr").count()) >= 4, "criteria are listed");
  assert.match(
    await page.locator("#criteria").textContent(),
    /warns below 0\.6, strong below 0\.4/,
  );
});

pageTest(
  "a click on the vein places the cut, one on the artery the incision",
  wide,
  async (page) => {
    await predicted(page);
    const [left] = await halves(page);
    const picture = await pixelsOf(page, "#stage");
    const [cut, along] = [await value(page, "cut-along"), await value(page, "incision-along")];
    // A third from the head down, between the kept end (0 %) and the heart (100 %).
    await clickStage(page, middleAt(find(picture, left, isVein), 0.33));
    await changedFrom(page, "cut-along", cut);
    const placed = await value(page, "cut-along");
    assert.ok(placed > 15 && placed < 55, `the cut is where it was clicked: ${placed} %`);
    assert.equal(await value(page, "incision-along"), along);
    await predicted(page);

    const artery = find(picture, left, isArtery);
    const far = artery.filter(([x]) => x < Math.min(...artery.map(([column]) => column)) + 30);
    await clickStage(page, middleAt(far, 0.5));
    await changedFrom(page, "incision-along", along);
    assert.equal(await value(page, "cut-along"), placed);
  },
);

pageTest("a drag of the camera turns both views and picks nothing", wide, async (page) => {
  await predicted(page);
  const before = [await value(page, "cut-along"), await value(page, "incision-along")];
  const [left, right] = await halves(page);
  const picture = await pixelsOf(page, "#stage");
  const [x, y] = middleAt(find(picture, left, isVein), 0.3);
  const box = await page.locator("#stage").boundingBox();
  await page.mouse.move(box.x + x, box.y + y);
  await page.mouse.down();
  await page.mouse.move(box.x + x + 60, box.y + y + 20, { steps: 5 });
  await page.mouse.up();
  await page.waitForTimeout(300);
  assert.deepEqual([await value(page, "cut-along"), await value(page, "incision-along")], before);
  assert.ok(await page.locator("#undo").isDisabled());
  const turned = await pixelsOf(page, "#stage");
  for (const part of [left, right])
    assert.ok(changed(picture, turned, part) > 0.05, "the view turned");
});

pageTest(
  "a marker is dragged, the prediction follows, and it is one step to undo",
  wide,
  async (page) => {
    await predicted(page);
    const begin = await value(page, "cut-along");
    const [left, right] = await halves(page);
    const picture = await pixelsOf(page, "#stage");
    const marker = middleAt(find(picture, left, isCutMarker), 0.8);
    const vein = find(picture, left, isVein);
    const box = await page.locator("#stage").boundingBox();
    await page.mouse.move(box.x + marker[0], box.y + marker[1]);
    await page.mouse.down();
    for (const share of [0.75, 0.7, 0.65, 0.6]) {
      const [x, y] = middleAt(vein, share);
      await page.mouse.move(box.x + x, box.y + y, { steps: 3 });
      await page.waitForTimeout(150);
    }
    const onTheWay = await value(page, "cut-along");
    assert.ok(onTheWay < begin - 5, `the cut follows the hand: ${begin} to ${onTheWay} %`);
    await predicted(page);
    const followed = await pixelsOf(page, "#stage");
    assert.ok(
      changed(picture, followed, right) > 0.01,
      "the prediction follows before the release",
    );
    await page.mouse.up();
    await page.waitForFunction(() => !document.getElementById("undo").disabled);
    const end = await value(page, "cut-along");

    await page.locator("#undo").click();
    assert.equal(await value(page, "cut-along"), begin);
    assert.ok(await page.locator("#undo").isDisabled(), "the drag was one step");
    await page.locator("#surface").focus();
    await page.keyboard.press("Control+Shift+Z");
    assert.equal(await value(page, "cut-along"), end);
    await page.keyboard.press("Control+z");
    assert.equal(await value(page, "cut-along"), begin);
    await predicted(page);
  },
);

pageTest("a locked plan is not changed", wide, async (page) => {
  await predicted(page);
  await page.locator("#lock").click();
  const before = await value(page, "cut-along");
  const [left] = await halves(page);
  const picture = await pixelsOf(page, "#stage");
  await clickStage(page, middleAt(find(picture, left, isVein), 0.3));
  await page.getByText("The plan is locked; unlock it to change it.").waitFor();
  assert.equal(await value(page, "cut-along"), before);
  assert.ok(await page.locator("#cut-along").isDisabled());
  await page.locator("#lock").click();
  assert.ok(await page.locator("#cut-along").isEnabled());
});

pageTest(
  "what cannot be built is said, and nothing old is shown as its prediction",
  wide,
  async (page) => {
    await predicted(page);
    await setNumber(page, "incision-along", "99.5");
    await page.locator("#problem").waitFor({ state: "visible" });
    assert.ok((await page.locator("#problem").textContent()).length > 10);
    await page.getByText("No prediction for this plan").waitFor();
    assert.match(await badge(page).textContent(), /no prediction/);
    assert.ok(await page.locator("#keep-plan").isDisabled());
    await page.locator("#undo").click();
    await predicted(page);
    await page.locator("#problem").waitFor({ state: "hidden" });
  },
);

pageTest(
  "a detailed prediction shows its progress; another one is cancelled",
  wide,
  async (page) => {
    await predicted(page);
    await page.locator("#solve-paper").click();
    await page.locator("#progress").waitFor({ state: "visible" });
    assert.match(
      await page.locator("#progress-text").textContent(),
      /Paper model: .+, \d+(\.\d)? s/,
    );
    await predicted(page, "Paper model");
    assert.ok(await page.locator("#progress").isHidden());

    await page.locator("#solve-coupled").click();
    await page.locator("#cancel").waitFor({ state: "visible" });
    await page.waitForTimeout(500);
    await page.locator("#cancel").click();
    await page.locator("#progress").waitFor({ state: "hidden" });
    await page.waitForTimeout(500);
    // Either nothing was kept on the way and the earlier prediction of this plan stays, or the
    // state that was kept is said to be interrupted.
    const text = await badge(page).textContent();
    assert.match(text, /Paper model: converged|Full model: interrupted/);
    if (/interrupted/.test(text)) {
      assert.ok(await badge(page).evaluate((one) => one.classList.contains("bad")));
      await page.getByText("Do not rely on this result as it stands").waitFor();
    }
  },
);

pageTest("an interrupted result is grey and its numbers unknown", wide, async (page) => {
  await predicted(page);
  // The true answer of the program, with the status of a solve that was stopped.
  await page.route(/api\/result\/[^/]+$/, async (route) => {
    const answer = await route.fetch();
    const result = await answer.json();
    result.json.status = "interrupted";
    result.json.validity.in_range = null;
    for (const one of result.json.criteria) one.verdict = "unknown";
    await route.fulfill({ response: answer, json: result });
  });
  await page.locator("#solve-skin").click();
  await page.locator("#head-1 .badge", { hasText: "interrupted" }).waitFor();
  await page.selectOption("#colour", "TwistShear");
  await page.waitForTimeout(300);
  assert.match(
    await page.locator("#result").textContent(),
    /Do not rely on this result as it stands/,
  );
  assert.match(await page.locator("#result").textContent(), /No equilibrium was found/);
  assert.equal(await page.locator("#criteria tbody td strong").first().textContent(), "unknown");
  assert.deepEqual(await colouredPixels(page), [], "no colour says anything");
  assert.match(await page.locator("#comparison tbody tr").first().textContent(), /–/);
});

pageTest("walls that pass through each other are never shown as good", wide, async (page) => {
  await predicted(page);
  // The vein is then so short that it is drawn into the aorta.
  await setNumber(page, "cut-along", "70");
  await page.locator("#head-1 .badge", { hasText: "walls pass through each other" }).waitFor();
  assert.ok(await badge(page).evaluate((one) => one.classList.contains("bad")));
  assert.equal(await page.locator(".badges .badge.good").count(), 0);
  await page.getByText("Do not rely on this result as it stands").waitFor();
});

pageTest("plans are kept and compared in two views with one camera", wide, async (page) => {
  await predicted(page);
  await page.locator("#keep-plan").click();
  await setNumber(page, "cut-along", "60");
  await page.waitForFunction(
    () =>
      !document.getElementById("keep-plan").disabled &&
      /stretch/i.test(document.getElementById("comparison").textContent),
  );
  await predicted(page);
  await page.locator("#keep-plan").click();
  const rows = page.locator("#comparison tbody tr");
  assert.equal(await rows.count(), 3);
  const numbers = await rows.evaluateAll((all) =>
    all.map((row) => [...row.querySelectorAll("td.number")].map((cell) => cell.textContent)),
  );
  assert.deepEqual(numbers[0], numbers[2], "the current plan is plan B");
  assert.notDeepEqual(numbers[1], numbers[2], "plan A has other numbers");
  await page.getByRole("button", { name: "Show in the second view Plan A" }).click();
  await page.selectOption("#head-0 select", "B");
  const [left, right] = await halves(page);
  const picture = await pixelsOf(page, "#stage");
  assert.ok(
    changed(
      picture,
      { at: (x, y) => picture.at((x + Math.round(right.x)) % picture.width, y) },
      left,
    ) > 0.005,
    "the two plans differ",
  );
  await page.locator("#surface").focus();
  for (let k = 0; k < 3; k++) await page.keyboard.press("ArrowLeft");
  await page.waitForTimeout(300);
  const turned = await pixelsOf(page, "#stage");
  for (const part of [left, right]) assert.ok(changed(picture, turned, part) > 0.05, "both turned");
  await page.getByRole("button", { name: "Use the plan of Plan A" }).click();
  assert.ok((await value(page, "cut-along")) > 70, "the plan is that of A again");
  await page.getByRole("button", { name: "Remove Plan B" }).click();
  assert.equal(await rows.count(), 2);
});

pageTest(
  "colours, range and transparency change the pixels where they should",
  wide,
  async (page) => {
    await predicted(page);
    const [left, right] = await halves(page);
    const plain = await pixelsOf(page, "#stage");
    await page.selectOption("#colour", "TwistShear");
    await page.waitForTimeout(300);
    const twist = await pixelsOf(page, "#stage");
    assert.equal(changed(plain, twist, left), 0, "the vessels before stay as they were");
    assert.ok(changed(plain, twist, right) > 0.05, "the prediction is coloured");
    assert.match(
      await page.locator("#legend-text").textContent(),
      /Twist shear, from −0\.2 to 0\.2/,
    );
    await page.locator("#range-auto").uncheck();
    await page.locator("#range-low").fill("-0.005");
    await setNumber(page, "range-high", "0.005");
    await page.waitForTimeout(300);
    const narrow = await pixelsOf(page, "#stage");
    assert.ok(changed(twist, narrow, right) > 0.01, "the fixed range shows more");
    assert.match(await page.locator("#legend-text").textContent(), /from −0\.005 to 0\.005/);
    await page.selectOption("#colour", "vessel");
    await page.getByLabel(/Transparency of svc/).fill("85");
    await page.waitForTimeout(300);
    const glass = await pixelsOf(page, "#stage");
    assert.ok(
      find(glass, left, isVein).length < 0.7 * find(plain, left, isVein).length,
      "the vein is seen through",
    );
  },
);

pageTest("the value under the pointer and the curves mark the same place", wide, async (page) => {
  await predicted(page);
  await page.selectOption("#colour", "AxialStretch");
  await page.locator("#tab-curves").click();
  assert.equal(await page.locator(".plot").count(), 4);
  const [left, right] = await halves(page);
  const picture = await pixelsOf(page, "#stage");
  const [x, y] = middleAt(find(picture, left, isVein), 0.25);
  await page.locator("#surface").hover({ position: { x: x + right.x, y } });
  await page.locator("#tip").waitFor({ state: "visible" });
  const tip = await page.locator("#tip").textContent();
  assert.match(tip, /svc \(vein\)/);
  assert.match(tip, /Axial stretch: [01]\.\d+/);
  assert.match(tip, /mm along the axis/);
  const cursors = await page
    .locator(".u-cursor-x")
    .evaluateAll((all) => all.map((one) => getComputedStyle(one).transform));
  assert.equal(cursors.length, 4);
  assert.ok(
    cursors.every((one) => one === cursors[0] && !/, -10, /.test(one)),
    "all curves have the cursor there",
  );
  await page.mouse.move(0, 0);
  await page.waitForTimeout(200);
  const unmarked = await pixelsOf(page, "#stage");
  const plot = page.locator(".plot .u-over").first();
  await plot.hover();
  await page.waitForTimeout(300);
  const marked = await pixelsOf(page, "#stage");
  for (const part of [left, right])
    assert.ok(changed(unmarked, marked, part) > 0.0005, "the place is marked in the view");
});

pageTest("section, ruler and picture", wide, async (page) => {
  await predicted(page);
  await page.locator("#tool-section").click();
  await page.locator("#section-at").fill("10");
  await page.waitForFunction(
    () => document.querySelectorAll("#section-results table").length === 2,
  );
  const area = await page
    .locator("#section-results tr", { hasText: "svc" })
    .first()
    .locator("td")
    .first()
    .textContent();
  // The outer radius of the vein is 3.10 + 0.2 mm there, the surface its outer wall: about pi r^2.
  assert.ok(Number(area) > 25 && Number(area) < 40, `area ${area} mm²`);
  assert.equal((await page.locator("#section-results svg path").count()) > 1, true);
  const [left] = await halves(page);
  const open = await pixelsOf(page, "#stage");
  await page.locator("#section-clip").check();
  await page.waitForTimeout(400);
  assert.ok(
    changed(open, await pixelsOf(page, "#stage"), left) > 0.02,
    "what lies in front is hidden",
  );
  await page.locator("#tool-plan").click();
  await page.waitForTimeout(300);

  await page.locator("#tool-ruler").click();
  const vein = find(await pixelsOf(page, "#stage"), left, isVein);
  await clickStage(page, middleAt(vein, 0.1));
  await clickStage(page, middleAt(vein, 0.5));
  await page.getByText(/mm in a straight line/).waitFor();
  const length = parseFloat(await page.locator("#ruler-text").textContent());
  assert.ok(length > 5 && length < 39, `${length} mm of a vein of 39 mm`);

  const [file] = await Promise.all([
    page.waitForEvent("download"),
    page.locator("#picture").click(),
  ]);
  assert.equal(file.suggestedFilename(), "infant.png");
  const png = await readFile(await file.path());
  const { width, height } = await page.locator("#stage").boundingBox();
  assert.ok(Math.abs(png.readUInt32BE(16) - 2 * width) <= 4, "twice as wide as on the page");
  assert.ok(png.readUInt32BE(20) >= 2 * height - 4);
});

pageTest(
  "the plan is saved, found taken, replaced and opened again; the result is kept",
  wide,
  async (page, { faults }) => {
    await predicted(page);
    await setNumber(page, "cut-along", "65");
    await page.locator("#vein-turn").waitFor({ state: "hidden" });
    await page.getByLabel("By hand").check();
    await setNumber(page, "vein-turn", "20");
    await predicted(page);
    const save = async () => {
      await page.locator("#save").click();
      await page.locator("#name-input").fill("again.yaml");
      await page.locator("#name-save").click();
    };
    await save();
    await page.getByText(/Saved as .*again\.yaml/).waitFor();
    await page.locator("#message-close").click();
    await save();
    await page.getByText("Save again to replace it.").waitFor();
    await page.getByRole("button", { name: "Replace" }).click();
    await page.getByText(/Saved as .*again\.yaml/).waitFor();
    assert.match(await readFile(join(folder, "again.yaml"), "utf8"), /rotation_deg: *20/);

    await page.locator("#keep-result").click();
    await page.locator("#name-input").fill("kept");
    await page.locator("#name-save").click();
    await page.getByText(/Saved in .*kept/).waitFor({ timeout: 60000 });
    await access(join(folder, "kept/report.html"));
    assert.equal(
      JSON.parse(await readFile(join(folder, "kept/result.json"), "utf8")).status,
      "converged",
    );

    await openSource(page, /again/);
    await page.waitForFunction(
      () =>
        document.getElementById("cut-along").value === "65" &&
        document.getElementById("loading").hidden,
    );
    assert.equal(await value(page, "vein-turn"), 20);
    await predicted(page);

    await openSource(page, /kept/);
    await page.waitForFunction(
      () => document.getElementById("result-title").textContent === "Result",
    );
    await predicted(page);
    assert.ok(await page.locator("#save").isDisabled(), "a result has no plan to change");
    await openSource(page, /^infant/);
    await page.waitForFunction(
      () => document.getElementById("result-title").textContent !== "Result",
    );
    // The one refusal of the test, which the browser notes: the name that was taken.
    const refused = faults.splice(0);
    assert.ok(refused.length <= 1 && refused.every((text) => /409/.test(text)), refused.join("\n"));
  },
);

pageTest("everything of a plan works by keyboard alone", wide, async (page) => {
  await predicted(page);
  const reach = async (id) => {
    for (let k = 0; k < 80; k++) {
      await page.keyboard.press("Tab");
      if (await page.evaluate((wanted) => document.activeElement?.id === wanted, id)) return;
    }
    assert.fail(`Tab does not reach ${id}`);
  };
  await reach("surface");
  const before = await pixelsOf(page, "#stage");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("+");
  await page.waitForTimeout(300);
  assert.ok(changed(before, await pixelsOf(page, "#stage"), {}) > 0.02);
  await reach("cut-along");
  await page.keyboard.press("Control+a");
  await page.keyboard.type("62");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  await page.keyboard.press("ArrowRight");
  assert.equal(await value(page, "cut-along"), 62.5);
  await reach("incision-length-slider");
  await page.keyboard.press("ArrowRight");
  assert.equal(await value(page, "incision-length"), 1.05);
  await page.keyboard.press("Control+z");
  assert.equal(await value(page, "incision-length"), 1);
  await page.keyboard.press("Control+Shift+Z");
  assert.equal(await value(page, "incision-length"), 1.05);
  await reach("solve-paper");
  await page.keyboard.press("Enter");
  await predicted(page, "Paper model");
  await page.keyboard.press("k");
  assert.equal(await page.locator("#comparison tbody tr").count(), 2);
  await page.keyboard.press("l");
  assert.ok(await page.locator("#cut-along").isDisabled());
  await page.keyboard.press("l");
  await page.keyboard.press("?");
  assert.ok(await page.locator("#help-dialog").isVisible());
  await page.keyboard.press("Escape");
  assert.ok(await page.locator("#help-dialog").isHidden());
});

pageTest("a narrow page overflows nowhere and works by touch", narrow, async (page) => {
  await predicted(page);
  const overflow = () =>
    page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
  assert.equal(await overflow(), 0);
  const picture = await pixelsOf(page, "#stage");
  const scale = picture.width / (await page.locator("#stage").boundingBox()).width;
  const begin = await value(page, "cut-along");
  // The two views lie above each other.
  const above = { height: picture.height / 2 };
  const [x, y] = middleAt(find(picture, above, isVein), 0.3);
  await page.locator("#surface").tap({ position: { x: x / scale, y: y / scale } });
  await changedFrom(page, "cut-along", begin);
  await predicted(page);
  for (const id of ["tab-curves", "tool-section", "one-view", "keep-plan"]) {
    await page.locator(`#${id}`).click();
    assert.equal(await overflow(), 0, id);
  }
});

pageTest("two fingers zoom and move, and place nothing", narrow, async (page, { context }) => {
  await predicted(page);
  const begin = await value(page, "cut-along");
  const { x, y, width, height } = await page.locator("#surface").boundingBox();
  const touches = await context.newCDPSession(page);
  const touch = (type, apart, aside = 0) => {
    const middle = [x + width / 2 + aside, y + height / 4];
    const touchPoints = [-apart, apart].map((away, id) => ({
      id,
      x: middle[0] + away,
      y: middle[1],
    }));
    return touches.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: type === "touchEnd" ? [] : touchPoints,
    });
  };
  const pinch = async (from, to, aside = 0) => {
    await touch("touchStart", from);
    for (let k = 1; k <= 5; k++)
      await touch("touchMove", from + (k / 5) * (to - from), (k / 5) * aside);
    await touch("touchEnd");
    await page.waitForTimeout(300);
    const upper = { x: 4, y: 4, width: width - 8, height: height / 2 - 8 }; // within the focus ring
    return find(await pixelsOf(page, "#stage"), upper, isVein);
  };
  const middleOf = (found) => found.reduce((sum, [column]) => sum + column, 0) / found.length;
  const asOpened = await pinch(40, 40);
  const nearer = await pinch(40, 60);
  assert.ok(nearer.length > 1.3 * asOpened.length, "apart is nearer");
  const further = await pinch(60, 30);
  assert.ok(further.length < 0.6 * nearer.length, "together is further away");
  const moved = await pinch(40, 40, 50);
  const way = middleOf(moved) - middleOf(further);
  assert.ok(Math.abs(way - 50) < 10, `moved by ${way} of 50 pixels`);
  assert.equal(await value(page, "cut-along"), begin);
});

for (const [name, options] of [
  ["light", { ...wide, colorScheme: "light" }],
  ["dark", { ...wide, colorScheme: "dark" }],
  ["narrow", { width: 390, height: 844 }],
])
  pageTest(`axe finds nothing serious (${name})`, options, async (page) => {
    await page.waitForTimeout(3000);
    const source = await readFile(
      createRequire(import.meta.url).resolve("axe-core/axe.min.js"),
      "utf8",
    );
    await page.evaluate(source);
    const check = async (what) => {
      const { violations } = await page.evaluate(() => globalThis.axe.run());
      const grave = violations.filter(({ impact }) => ["serious", "critical"].includes(impact));
      assert.deepEqual(
        grave.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)]),
        [],
        what,
      );
    };
    await check("as opened");
    for (const id of ["keep-plan", "tab-curves", "tool-section"])
      await page.locator(`#${id}`).click();
    await page.selectOption("#colour", { index: 0 });
    await page.waitForTimeout(500);
    await check("curves and section");
    await page.locator("#save").click();
    await check("save");
    await page.locator("#name-cancel").click();
    await page.locator("#open").click();
    await page.locator("#open-dialog").waitFor();
    await check("open");
  });

test(
  "a program that is gone is said in one sentence and nothing is lost",
  { timeout: 240000 },
  async () => {
    const own = await startProgram(folder);
    const { page, context, faults, close } = await openPage(browser, own.address, wide);
    try {
      await predicted(page);
      await page.locator("#keep-plan").click();
      // For a while only: the page goes on by itself.
      await context.setOffline(true);
      await setNumber(page, "cut-along", "66");
      await page.locator("#lost").waitFor({ state: "visible" });
      assert.match(await page.locator("#lost").textContent(), /The program does not answer\./);
      await context.setOffline(false);
      // Unless the page has gone on by itself before.
      await page
        .locator("#retry")
        .click({ timeout: 2000 })
        .catch(() => {});
      await page.locator("#lost").waitFor({ state: "hidden" });
      await predicted(page);
      assert.equal(await value(page, "cut-along"), 66);
      // For good.
      await own.stop();
      await setNumber(page, "cut-along", "58");
      await page.locator("#lost").waitFor({ state: "visible" });
      assert.equal(await value(page, "cut-along"), 58, "the plan can still be changed");
      await page.locator("#undo").click();
      assert.equal(await value(page, "cut-along"), 66);
      assert.equal(
        await page.locator("#comparison tbody tr").count(),
        2,
        "the kept plan is still there",
      );
      await page.selectOption("#head-1 select", "A");
      const [, right] = await halves(page);
      assert.ok(
        find(await pixelsOf(page, "#stage"), right, isVein).length > 500,
        "and can be seen",
      );
      assert.ok(
        faults.every((text) =>
          /ERR_(INTERNET_DISCONNECTED|CONNECTION_REFUSED|EMPTY_RESPONSE|CONNECTION_RESET)/.test(
            text,
          ),
        ),
        faults.join("\n"),
      );
    } finally {
      await close();
      await own.stop();
    }
  },
);
