// Makes the same page from data that the Rust side writes, with the committed assets.

import { readFile } from "node:fs/promises";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { ASSETS } from "../build.mjs";

const escaped = (text) => text.replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]);

/** The page as text. */
export async function page(data) {
  const [script, style] = await Promise.all(["viewer.js", "viewer.css"].map((name) => readFile(path.join(ASSETS, name), "utf8")));
  const packed = (list) => gzipSync(JSON.stringify(list)).toString("base64");
  const { looks, ...cell } = data.cell;
  const json = JSON.stringify({ ...data, replays: packed(data.replays), cell: looks?.length > 0 ? { ...cell, looks: packed(looks) } : cell }).replaceAll("<", "\\u003c");
  return `<!doctype html><html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:">
<meta name="viewport" content="width=device-width, initial-scale=1"><title>${escaped(data.cell.name)}: hazard report</title><style>${style}</style></head>
<body><noscript>This report needs JavaScript; scan.json beside it holds the same results.</noscript><main id="report"></main>
<script type="application/json" id="data">${json}</script><script>${script}</script></body></html>
`;
}
