// What the tests of the page share: one program, one browser, and what one looks at in the page.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { find, pixelsOf } from "./pixels.mjs";
import { openPage, removeFolder, sceneFolder, startBrowser, startProgram } from "./program.mjs";

export const wide = { width: 1400, height: 900 };
export const narrow = { width: 390, height: 844, hasTouch: true, isMobile: true };
export let folder, browser;
let program;

before(async () => {
  folder = await sceneFolder();
  program = await startProgram(folder);
  browser = await startBrowser();
});

after(async () => {
  await browser?.close();
  await program?.stop();
  if (folder) await removeFolder(folder);
});

/** A test with a page of its own, which must not have left a fault behind. */
export function pageTest(name, options, work) {
  test(name, { timeout: 240000 }, async () => {
    await withPage(program.address, options, work);
  });
}

/** The same with a program of its own on other sources; `prepare` writes them into the folder. */
export function programTest(name, sources, prepare, work) {
  test(name, { timeout: 240000 }, async () => {
    await prepare();
    const own = await startProgram(folder, sources);
    try {
      await work(own.address);
    } finally {
      await own.stop();
    }
  });
}

export async function withPage(address, options, work) {
  const opened = await openPage(browser, address, options);
  try {
    await work(opened.page, opened);
    assert.deepEqual(opened.faults, []);
  } finally {
    await opened.close();
  }
}

export const value = async (page, id) => Number(await page.locator(`#${id}`).inputValue());
export const badge = (page, view = 1) => page.locator(`#head-${view} .badge`);

/** Types a number and leaves its field. */
export async function setNumber(page, id, text) {
  await page.locator(`#${id}`).fill(text);
  await page.locator(`#${id}`).press("Tab");
}

/** Waits until a number is another one. */
export const changedFrom = (page, id, was) =>
  page.waitForFunction(([id, was]) => document.getElementById(id).value !== was, [id, String(was)]);

/** Waits until the prediction of the present plan is shown. */
export async function predicted(page, model = "Quick") {
  await page.waitForFunction(
    (words) =>
      [...document.querySelectorAll(".head .badge")].some(
        (one) => !one.hidden && one.textContent.startsWith(words),
      ),
    `${model}:`,
    { timeout: 120000 },
  );
}

/** The vessels before the operation are in the first view, the prediction in the second. */
export async function halves(page) {
  const { width, height } = await page.locator("#stage").boundingBox();
  return [
    { x: 0, y: 0, width: width / 2, height },
    { x: width / 2, y: 0, width: width / 2, height },
  ];
}

export const isVein = (r, g, b) => g > r + 15 && b > g + 25;
export const isArtery = (r, g, b) => r > g + 2 && b > r + 22 && b > 90;
export const isCutMarker = (r, g, b) => r > 240 && g > 160 && g < 190 && b < 30;

/** Pixels of the second view, below its head, whose colour is far from grey. */
export async function colouredPixels(page) {
  const [, right] = await halves(page);
  return find(
    await pixelsOf(page, "#stage"),
    { ...right, y: 70, height: right.height - 70 },
    (r, g, b) => Math.max(r, g, b) - Math.min(r, g, b) > 40,
  );
}

export async function clickStage(page, [x, y]) {
  await page.locator("#surface").click({ position: { x, y } });
}

/** Chooses a source in the dialog by its name. */
export async function openSource(page, name) {
  await page.locator("#open").click();
  await page.locator("#sources button", { hasText: name }).first().click();
}

/** Lets the program answer late to what matches. */
export const delay = (page, pattern, milliseconds) =>
  page.route(pattern, async (route) => {
    await new Promise((go) => setTimeout(go, milliseconds));
    await route.continue().catch(() => {}); // the page may be closed by now
  });
