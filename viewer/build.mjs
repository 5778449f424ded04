// Builds the assets that the Rust side includes: one script and one style sheet, minified, the same bytes each time.

import { mkdir, readFile, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import path from "node:path";
import { build } from "esbuild";

const here = path.dirname(fileURLToPath(import.meta.url));

/** Where the committed assets are. */
export const ASSETS = path.join(here, "..", "crates", "report", "src", "viewer");

/** Names of the assets. */
export const NAMES = ["viewer.js", "viewer.css"];

/** Largest script that a mailed report may carry. */
const MAX_SCRIPT_BYTES = 770_000;

/** uPlot's notice as a comment: its sources carry no legal comment that the bundler would keep. */
async function uplotNotice() {
  const text = await readFile(path.join(here, "node_modules", "uplot", "LICENSE"), "utf8");
  const lines = text.trim().split("\n").map((line) => ` * ${line}`.trimEnd());
  return `/*! uPlot (in this file)\n${lines.join("\n")}\n */`;
}

/** three.js' whole licence text: its own comment names only the licence. */
async function threeNotice() {
  const text = await readFile(path.join(here, "node_modules", "three", "LICENSE"), "utf8");
  const lines = text.trim().split("\n").map((line) => ` * ${line}`.trimEnd());
  return `/*! three.js (in this file)\n${lines.join("\n")}\n */`;
}

/** Writes the assets into a folder and returns their sizes by name. */
export async function buildAssets(folder) {
  const notices = `${await threeNotice()}\n${await uplotNotice()}`;
  const result = await build({
    absWorkingDir: here,
    entryPoints: { viewer: "src/main.js" },
    outdir: folder,
    bundle: true,
    minify: true,
    format: "iife",
    target: "es2022",
    charset: "utf8",
    legalComments: "eof",
    footer: { js: notices },
    write: false,
  });
  await mkdir(folder, { recursive: true });
  const sizes = {};
  for (const file of result.outputFiles) {
    const name = path.basename(file.path);
    if (/<\/(script|style)/i.test(file.text)) {
      throw new Error(`${name} holds an end tag, which would end the element that it is put into`);
    }
    await writeFile(path.join(folder, name), file.contents);
    sizes[name] = file.contents.length;
  }
  if (sizes["viewer.js"] > MAX_SCRIPT_BYTES) {
    throw new Error(`viewer.js has ${sizes["viewer.js"]} bytes, more than ${MAX_SCRIPT_BYTES}`);
  }
  return sizes;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  for (const [name, bytes] of Object.entries(await buildAssets(ASSETS))) {
    console.log(`${name} ${bytes} bytes`);
  }
}
