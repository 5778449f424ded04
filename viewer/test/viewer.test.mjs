// Tests of the viewer on invented reports, in a browser.

import assert from "node:assert/strict";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { requiredLevel } from "../src/assessments.js";
import { count } from "../src/words.js";
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
  "none, with a floor": { hazards: 0, floor: true },
  "nine, with a floor": { hazards: 9, replays: 3, floor: true },
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
  assert.ok((await tab.locator('[data-test="row"] td:nth-child(5)').allTextContents()).includes(SCRIPT));
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

test("a hazard that is in no cause is never passed over", async () => {
  const data = report({ hazards: 2, arm: "none" });
  data.scan.causes = [];
  const file = path.join(folder, "no-cause.html");
  await writeFile(file, await page(data));
  const tab = await browsers.plain.newPage();
  await tab.goto(`file://${file}`);
  assert.match(await tab.locator(".notice").textContent(), /in no cause/);
  assert.equal(await tab.locator('[data-test="none"]').count(), 0);
  await tab.close();
});

test("counts have their thousands set apart", () => {
  assert.deepEqual([1, 0, 12, 1234, 1234567].map((number) => count(number, "way")), ["1 way", "0 ways", "12 ways", "1,234 ways", "1,234,567 ways"]);
});

test("equal actions in a row are told once", async () => {
  const data = report({ hazards: 1, arm: "none" });
  const [hazard] = data.scan.hazards;
  hazard.actions = ["a", "a", "a", "b", "a"];
  data.words.actions = { ...data.words.actions, a: "walks", b: "bends" };
  const file = path.join(folder, "sequence.html");
  await writeFile(file, await page(data));
  const tab = await browsers.plain.newPage();
  await tab.goto(`file://${file}`);
  const lines = await tab.locator('[data-test="facts"] .sequence').first().locator("li").allTextContents();
  assert.deepEqual(lines, ["3 x walks, 0.6 s", "bends, 0.2 s", "walks, 0.2 s"]);
  await tab.close();
});

test("the required performance level follows the risk graph of ISO 13849-1", () => {
  const levels = ["S1", "S2"].flatMap((severity) => ["F1", "F2"].flatMap((exposure) => ["P1", "P2"].map((avoidance) => requiredLevel({ severity, exposure, avoidance }))));
  assert.equal(levels.join(""), "abbccdde");
  assert.equal(requiredLevel({ severity: "S2", exposure: "", avoidance: "P1" }), null);
});

test("a robot that stands high on nothing gets a pedestal, one on its table does not", async () => {
  for (const [pedestal, number] of [[true, 1], [false, 0]]) {
    const file = await written(`pedestal ${number}`, { hazards: 1, pedestal });
    const tab = await browsers.graphics.newPage();
    await tab.goto(`file://${file}`);
    await tab.locator("[data-drawn]").waitFor();
    assert.equal(JSON.parse(await tab.locator("[data-drawn]").getAttribute("data-drawn")).pedestals, number);
    await tab.close();
  }
});

test("what a link looks like moves with its shape, which stays in the picture", async () => {
  const gripper = 5;
  const looks = [{ link: gripper, points_m: [[0, 0, 0], [0.05, 0, 0], [0, 0.05, 0.05]], triangles: [[0, 1, 2]] }];
  const file = await written("looks", { hazards: 1, looks });
  const tab = await browsers.graphics.newPage();
  await tab.goto(`file://${file}`);
  await tab.locator("[data-drawn]").waitFor();
  const read = async () => JSON.parse(await tab.locator("[data-drawn]").getAttribute("data-drawn")).looks;
  const places = [];
  for (const key of ["Home", "End"]) {
    await tab.locator('[data-test="scrub"]').focus();
    await tab.keyboard.press(key);
    const [{ at, shape, clear }] = await read();
    assert.deepEqual(at, shape);
    assert.ok(clear);
    places.push(at);
  }
  assert.notDeepEqual(places[0], places[1]);
  assert.match(await tab.locator(".legend").textContent(), /shapes that are judged/);
  await tab.close();
});
