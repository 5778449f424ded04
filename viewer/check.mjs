// Tells whether the committed assets are what the sources give: builds them anew elsewhere and compares the bytes.

import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { ASSETS, NAMES, buildAssets } from "./build.mjs";

const folder = await mkdtemp(path.join(tmpdir(), "viewer-"));
try {
  await buildAssets(folder);
  const differing = [];
  for (const name of NAMES) {
    const fresh = await readFile(path.join(folder, name));
    const committed = await readFile(path.join(ASSETS, name)).catch(() => null);
    if (!committed || !fresh.equals(committed)) {
      differing.push(name);
    }
  }
  if (differing.length > 0) {
    console.error(`Not what the sources give: crates/report/src/viewer/${differing.join(", ")}. Run "npm run build" in viewer/.`);
    process.exitCode = 1;
  } else {
    console.log(`crates/report/src/viewer/${NAMES.join(" and ")} are what the sources give.`);
  }
} finally {
  await rm(folder, { recursive: true });
}
