// Makes the page: `node build.mjs OUTPUT_FOLDER` after `npm ci`. Writes index.html, app.js and
// app.css.
import { build } from "esbuild";
import { copyFile, mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2];
if (!folder) {
  console.error("usage: node build.mjs OUTPUT_FOLDER");
  process.exit(2);
}

const built = await build({
  absWorkingDir: here,
  entryPoints: [{ in: "src/main.js", out: "app" }],
  outdir: "out",
  write: false,
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  legalComments: "none",
  metafile: true,
  // vtk.js asks for these names of node.js in branches that a browser never takes.
  define: { global: "globalThis", "process.env.NODE_ENV": '"production"' },
  logLevel: "warning",
});

// The licences of the packages that came into the bundle stand at its head, as they demand.
const packages = new Set();
for (const file of Object.keys(built.metafile.inputs)) {
  const found = /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(file);
  if (found) packages.add(found[1]);
}
async function licenceOf(name) {
  const root = join(here, "node_modules", name);
  const about = JSON.parse(await readFile(join(root, "package.json"), "utf8"));
  const licence = typeof about.license === "string" ? about.license : (about.license?.type ?? "");
  const title = `${name} ${about.version}, ${licence}`;
  const files = ["LICENSE", "LICENSE.md", "LICENSE.txt", "license", "LICENCE", "Copyright.txt"];
  for (const file of files) {
    const text = await readFile(join(root, file), "utf8").catch(() => null);
    if (text) return `${title}\n\n${text.trim()}`;
  }
  return title;
}
const licences = await Promise.all([...packages].sort().map(licenceOf));
const head = `/*!\nThis file contains these packages.\n\n${licences
  .map((text) => text.replaceAll("*/", "* /"))
  .join("\n\n----\n\n")}\n*/\n`;

await mkdir(folder, { recursive: true });
for (const file of built.outputFiles) {
  const script = file.path.endsWith(".js");
  const name = script ? "app.js" : "app.css";
  await writeFile(join(folder, name), script ? head + file.text : file.text);
}
await copyFile(join(here, "index.html"), join(folder, "index.html"));
