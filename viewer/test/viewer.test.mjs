// Tests of the viewer on invented reports, in a browser.

import assert from "node:assert/strict";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { page } from "./page.mjs";
import { checkReport, launch } from "./report.mjs";
import { report } from "./synthetic.mjs";

const SCRIPT = "<img src=x onerror=\"document.title='run'\"></script><script>document.title='run'</script>";

const GIVEN = {
  "H-ffffff": { severity: "S1", exposure: "F1", avoidance: "P1", measure: "of an older scan", residual: "", decision: "accepted", by: "A. B.", date: "2026-01-02" },
};

const REPORTS = {
  none: { hazards: 0, exhaustive: true },
  "none, not complete, with faults": { hazards: 0, faults: 2 },
  one: { hazards: 1, arm: "none" },
  "one with an arm": { hazards: 1, arm: "all", exhaustive: true },
  many: { hazards: 9, replays: 6, faults: 2, assessments: GIVEN },
  fifty: { hazards: 60, replays: 50, exhaustive: true },
};

let folder;
let browsers;

before(async () => {
  folder = await mkdtemp(path.join(tmpdir(), "viewer-"));
  const [graphics, plain] = await Promise.all([launch(), launch({ graphics: false })]);
  browsers = { graphics, plain };
});

after(async () => {
  await Promise.all([browsers.graphics.close(), browsers.plain.close()]);
  await rm(folder, { recursive: true });
});

async function written(name, options) {
  const file = path.join(folder, `${name.replaceAll(/\W+/g, "-")}.html`);
  await writeFile(file, await page(report(options)));
  return file;
}

for (const [name, options] of Object.entries(REPORTS)) {
  test(`a report with hazards: ${name}`, async (t) => {
    const file = await written(name, options);
    const outcomes = [];
    await checkReport(file, browsers, (check, error) => outcomes.push([check, error]));
    assert.ok(outcomes.length >= 2);
    for (const [check, error] of outcomes) {
      await t.test(check, () => {
        if (error) {
          throw error;
        }
      });
    }
  });
}

test("names from strangers stay text", async () => {
  const file = await written("strange", { hazards: 3, hitting: SCRIPT, name: SCRIPT, assessments: { __proto__: null, "H-a00001": { decision: SCRIPT, measure: SCRIPT } } });
  const tab = await browsers.graphics.newPage();
  await tab.goto(`file://${file}`);
  await tab.locator("#provenance").waitFor();
  assert.equal(await tab.locator("#report img").count(), 0);
  assert.notEqual(await tab.title(), "run");
  assert.equal(await tab.locator("h1").textContent(), SCRIPT);
  assert.ok((await tab.locator('[data-test="row"] td:nth-child(4)').allTextContents()).includes(SCRIPT));
  await tab.close();
});

test("a drawing's scripts are left out", async () => {
  const data = report({ hazards: 1 });
  data.replays[0].top_view = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9" onload="document.title=\'run\'"><script>document.title="run"</script><circle r="4" onclick="1"/></svg>';
  const file = path.join(folder, "drawing.html");
  await writeFile(file, await page(data));
  const tab = await browsers.plain.newPage();
  await tab.goto(`file://${file}`);
  await tab.locator(".flat svg circle").waitFor({ state: "attached" });
  assert.equal(await tab.locator(".flat script, .flat [onload], .flat [onclick]").count(), 0);
  assert.notEqual(await tab.title(), "run");
  await tab.close();
});

test("data of another format is refused in words", async () => {
  const file = path.join(folder, "format.html");
  await writeFile(file, await page({ ...report({ hazards: 1 }), format: 2 }));
  const tab = await browsers.plain.newPage();
  await tab.goto(`file://${file}`);
  assert.match(await tab.locator(".notice").textContent(), /format 2/);
  await tab.close();
});
