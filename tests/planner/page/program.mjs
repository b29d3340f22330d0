// vasorod-plan and a browser for the tests: the program that VASOROD_PLAN names, started on a copy
// of the bundled infant scene, and Debian's chromium, which draws WebGL without a graphics card.
import { spawn } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

export const root = resolve(dirname(fileURLToPath(import.meta.url)), "../../..");

/** A folder with the bundled Glenn shunt, which the program may write into. */
export async function sceneFolder() {
  const folder = await mkdtemp(join(tmpdir(), "vasorod-page-"));
  const text = await readFile(join(root, "benchmarks/cases/glenn/infant.yaml"), "utf8");
  await writeFile(
    join(folder, "infant.yaml"),
    text.replaceAll("../../../meshes", join(root, "meshes")),
  );
  return folder;
}

/** A scene SPACE.yaml of the vein alone, whose surface names LPS, RAS or no space (""). */
export async function writeVein(folder, space) {
  const name = space || "no_space";
  const text = await readFile(join(root, "meshes/infant/svc.vtp"), "utf8");
  const codes = [...space, "\0"].map((letter) => letter.charCodeAt(0)).join(" ");
  const data =
    '<PolyData>\n<FieldData><Array type="String" Name="SPACE" NumberOfTuples="1" format="ascii">' +
    `${codes}</Array></FieldData>`;
  await writeFile(join(folder, `${name}.vtp`), space ? text.replace("<PolyData>", data) : text);
  await writeFile(
    join(folder, `${name}.yaml`),
    `scene: ${name}
fidelity: skin
units: {length: mm, stress: MPa}
vessels:
  - {name: svc, surface: ${name}.vtp, wall: {thickness: 0.4, young: 0.5, poisson: 0.45}}
ends:
  - {vessel: svc, end: {near: [-9.2, 2.7, 31]}, hold: true}
  - {vessel: svc, end: {near: [-8.9, 1.9, -8]}, hold: true}
`,
  );
}

/** The program on sources; {address, stop()}. */
export async function startProgram(folder, sources = ["infant.yaml"]) {
  const program = process.env.VASOROD_PLAN;
  if (!program) throw new Error("VASOROD_PLAN: found nothing, expected the path of vasorod-plan");
  const child = spawn(resolve(program), sources, {
    cwd: folder,
    stdio: ["ignore", "pipe", "inherit"],
  });
  const ended = new Promise((end) => child.once("exit", end));
  const address = await new Promise((give, fail) => {
    let said = "";
    child.stdout.on("data", (data) => {
      said += data;
      const found = /http:\/\/127\.0\.0\.1:\d+\/[0-9a-f]{32}\//.exec(said);
      if (found) give(found[0]);
    });
    child.once("error", fail);
    child.once("exit", () => fail(new Error(`vasorod-plan ended and gave no address: ${said}`)));
  });
  return {
    address,
    async stop() {
      child.kill("SIGTERM");
      await ended;
    },
  };
}

export const removeFolder = (folder) => rm(folder, { recursive: true, force: true });

export function startBrowser() {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: [
      "--use-gl=angle",
      "--use-angle=swiftshader",
      "--enable-unsafe-swiftshader",
      "--no-sandbox",
    ],
  });
}

/**
 * The page in a window of its own: {page, faults, close()}. `faults` gathers what must stay empty:
 * console errors, uncaught errors and requests outside the program's own prefix.
 */
export async function openPage(browser, address, { width = 1400, height = 900, ...more } = {}) {
  const context = await browser.newContext({
    viewport: { width, height },
    acceptDownloads: true,
    ...more,
  });
  const page = await context.newPage();
  const faults = [];
  page.on("console", (message) => {
    if (message.type() === "error") faults.push(`${message.text()} ${message.location().url}`);
  });
  page.on("pageerror", (error) => faults.push(error.stack ?? String(error)));
  page.on("request", (request) => {
    const url = request.url();
    if (!url.startsWith(address) && !/^(data|blob):/.test(url))
      faults.push(`left the prefix: ${url}`);
  });
  await page.goto(address);
  await page.locator("#loading").waitFor({ state: "hidden", timeout: 60000 });
  return { page, context, faults, close: () => context.close() };
}
