// Checks of a report that hold for any cell; each takes the path of a report.html.

import { gunzipSync } from "node:zlib";
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { pathToFileURL } from "node:url";
import path from "node:path";
import { chromium } from "playwright-core";

const EXECUTABLE = process.env.CHROMIUM ?? "/usr/bin/chromium";
const SOFTWARE_GL = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const VIEWPORT = { width: 1400, height: 1000 };

/** Starts a browser, with or without 3-D graphics. */
export function launch({ graphics = true } = {}) {
  const args = ["--headless", "--no-sandbox", ...(graphics ? SOFTWARE_GL : ["--disable-3d-apis"])];
  return chromium.launch({ executablePath: EXECUTABLE, args });
}

const test = (name) => `[data-test="${name}"]`;

/** Opens a report and keeps what it says on the console and which requests it makes. */
async function open(browser, file, hash = "") {
  const context = await browser.newContext({ viewport: VIEWPORT, acceptDownloads: true });
  const page = await context.newPage();
  const address = pathToFileURL(path.resolve(file)).href;
  const said = [];
  page.on("console", (message) => {
    // The graphics driver of the test browser speaks for itself.
    if (["error", "warning"].includes(message.type()) && !message.text().startsWith("[.WebGL")) {
      said.push(message.text());
    }
  });
  page.on("pageerror", (error) => said.push(String(error)));
  page.on("request", (request) => {
    if (request.url().split("#")[0] !== address && !request.url().startsWith("blob:")) {
      said.push(`request: ${request.url()}`);
    }
  });
  await page.goto(address + hash);
  await page.locator("#provenance").waitFor();
  const data = JSON.parse(await page.locator("#data").textContent());
  data.replays = JSON.parse(gunzipSync(Buffer.from(data.replays, "base64")));
  return { page, data, said, close: () => context.close() };
}

/** Lets the page draw what it has to draw. */
const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 60)))));

/** Picture of the scene; pixels are compared in a page without a content policy. */
async function picture(page) {
  await settle(page);
  return (await page.locator(test("scene")).screenshot()).toString("base64");
}

/** Distinct colours of the first picture, share of its commonest one, share of pixels that differ from the second. */
async function compare(browser, first, second = first) {
  const page = await browser.newPage();
  const result = await page.evaluate(
    async (pictures) => {
      const pixels = await Promise.all(
        pictures.map(async (base64) => {
          const image = new Image();
          image.src = `data:image/png;base64,${base64}`;
          await image.decode();
          const canvas = new OffscreenCanvas(image.width, image.height).getContext("2d");
          canvas.drawImage(image, 0, 0);
          return new Uint32Array(canvas.getImageData(0, 0, image.width, image.height).data.buffer);
        }),
      );
      const counts = new Map();
      pixels[0].forEach((pixel) => counts.set(pixel, (counts.get(pixel) ?? 0) + 1));
      const total = pixels[0].length;
      const differing = pixels[0].reduce((sum, pixel, index) => sum + (pixel !== pixels[1][index]), 0);
      return { colours: counts.size, commonest: Math.max(...counts.values()) / total, differing: differing / total };
    },
    [first, second],
  );
  await page.close();
  return result;
}

const setScrub = (page, frame) =>
  page.locator(test("scrub")).evaluate((input, value) => {
    input.value = value;
    input.dispatchEvent(new Event("input"));
  }, frame);

const frameOf = async (page) => Number(await page.locator(test("scrub")).inputValue());
const rows = (page) => page.locator(test("row"));
const selected = (page) => page.locator(`${test("row")}[aria-selected="true"]`).getAttribute("data-id");
const replayed = (data) => data.scan.hazards.map((z) => z.id).filter((id) => data.replays.some((replay) => replay.id === id));

/** Needs that a check has of a report. */
const any = () => true;
const hazards = (number) => (data) => data.scan.hazards.length >= number;
const replays = (number) => (data) => replayed(data).length >= number;

/** The checks: what they show, what a report needs for them, and the browser they run in. */
export const CHECKS = [
  {
    name: "says what was found, and what that is worth",
    needs: any,
    async run({ page, data }) {
      assert.equal(await page.locator("h1").textContent(), data.cell.name);
      assert.match(await page.locator(test("verdict")).textContent(), /\.$/);
      assert.match(await page.locator(test("scope")).textContent(), data.scan.certificate?.complete ? /^Complete\./ : /^Not complete\./);
      assert.equal(await page.locator(`${test("assumptions")} li`).count(), data.assumptions.length);
      const text = await page.locator("#report").textContent();
      data.cell.sensors.forEach((name, index) => {
        assert.ok(text.includes(`${name} in ${data.scan.coverage.sensor_actions[index].toLocaleString("en")} action`), name);
      });
      const again = data.scan.certificate?.run_again;
      assert.equal(text.includes("FMU transitions, by fresh instances from the start"), again?.compared > 0);
    },
  },
  {
    name: "puts nothing of the data into the page as markup",
    needs: any,
    async run({ page }) {
      const strange = await page.evaluate(() => {
        const inside = [...document.querySelectorAll("#report *")];
        return inside.filter((e) => ["IMG", "SCRIPT", "IFRAME", "OBJECT"].includes(e.tagName) || [...e.attributes].some((a) => a.name.startsWith("on"))).length;
      });
      assert.equal(strange, 0);
    },
  },
  {
    name: "works without a hazard",
    needs: (data) => data.scan.hazards.length === 0,
    async run({ page }) {
      await page.locator(test("none")).waitFor();
      assert.equal(await page.locator(test("scene")).count(), 0);
      assert.equal(await rows(page).count(), 0);
    },
  },
  {
    name: "has a row for each hazard, and the filter leaves some out",
    needs: hazards(1),
    async run({ page, data }) {
      assert.equal(await rows(page).count(), data.scan.hazards.length);
      const { id } = data.scan.hazards.at(-1);
      await page.locator(test("filter")).fill(id);
      assert.equal(await rows(page).count(), 1);
      await page.locator(test("filter")).fill("no row has this text");
      assert.equal(await rows(page).count(), 0);
      await page.locator(test("filter")).fill("");
      assert.equal(await rows(page).count(), data.scan.hazards.length);
    },
  },
  {
    name: "sorts by each column, both ways",
    needs: hazards(2),
    async run({ page }) {
      const buttons = page.locator("[data-test^=sort-]");
      for (let index = 0; index < (await buttons.count()); index++) {
        await buttons.nth(index).click();
        const head = page.locator("th").nth(index);
        const first = await head.getAttribute("aria-sort");
        await buttons.nth(index).click();
        assert.deepEqual([first, await head.getAttribute("aria-sort")].sort(), ["ascending", "descending"]);
      }
    },
  },
  {
    name: "draws a scene that is not blank",
    main: true,
    needs: replays(1),
    async run({ page, browser }) {
      const { colours, commonest } = await compare(browser, await picture(page));
      assert.ok(colours > 100, `${colours} colours`);
      assert.ok(commonest < 0.97, `one colour has ${commonest} of the picture`);
    },
  },
  {
    name: "scrubbing changes the picture",
    main: true,
    needs: replays(1),
    async run({ page, browser, data }) {
      const replay = data.replays.find((item) => item.id === replayed(data)[0]);
      const before = await picture(page);
      await setScrub(page, replay.contact_frame > 0 ? 0 : replay.frames - 1);
      const { differing } = await compare(browser, before, await picture(page));
      assert.ok(differing > 0.001, `${differing} of the picture differs`);
    },
  },
  {
    name: "each view shows another picture",
    needs: replays(1),
    async run({ page, browser }) {
      let before = await picture(page);
      for (const view of ["top", "front", "side", "eye", "contact", "overview"]) {
        await page.locator(test(`view-${view}`)).click();
        const after = await picture(page);
        assert.ok((await compare(browser, before, after)).differing > 0.01, view);
        before = after;
      }
    },
  },
  {
    name: "selecting another row changes picture and address, not the history",
    main: true,
    needs: replays(2),
    async run({ page, browser, data }) {
      const before = await picture(page);
      const length = await page.evaluate(() => history.length);
      const id = replayed(data).at(-1);
      await page.locator(`${test("row")}[data-id="${id}"] a`).click();
      assert.equal(await selected(page), id);
      assert.equal(await page.evaluate(() => location.hash), `#${id}`);
      assert.equal(await page.evaluate(() => history.length), length);
      assert.match(await page.locator("#replay-title").textContent(), new RegExp(id));
      assert.ok((await compare(browser, before, await picture(page))).differing > 0.0005);
    },
  },
  {
    name: "tells how to get a replay that it does not carry",
    needs: (data) => data.scan.hazards.length > replayed(data).length,
    async run({ page, data }) {
      const missing = data.scan.hazards.find((z) => !replayed(data).includes(z.id));
      await page.locator(`${test("row")}[data-id="${missing.id}"] a`).click();
      assert.match(await page.locator(test("no-replay")).textContent(), new RegExp(`fmi-hazard replay scan.json ${missing.id}`));
      assert.match(await page.locator(test("facts")).textContent(), /F = v/);
    },
  },
  {
    name: "a link with an id selects it, and a change of the address is followed",
    main: true,
    needs: hazards(1),
    async run({ browser, file, data }) {
      const id = data.scan.hazards.at(-1).id;
      const linked = await open(browser, file, `#${id}`);
      assert.equal(await selected(linked.page), id);
      const first = data.scan.hazards[0].id;
      await linked.page.evaluate((to) => (location.hash = to), first);
      await settle(linked.page);
      assert.equal(await selected(linked.page), first);
      await linked.page.evaluate(() => (location.hash = "H-none"));
      await linked.page.locator(test("unknown-id")).waitFor();
      assert.equal(await selected(linked.page), first);
      assert.deepEqual(linked.said, []);
      await linked.close();
    },
  },
  {
    name: "plays on to the last frame and stops there",
    needs: replays(1),
    async run({ page, data }) {
      const { frames } = data.replays.find((item) => item.id === replayed(data)[0]);
      await setScrub(page, Math.max(0, frames - 6));
      await page.locator(test("speed")).selectOption("1");
      await page.locator(test("play")).click();
      await page.waitForFunction((last) => document.querySelector("[data-test=scrub]").value === String(last), frames - 1);
      await page.locator(test("play")).filter({ hasText: "Play" }).waitFor();
      assert.equal(await frameOf(page), frames - 1);
    },
  },
  {
    name: "keys move the replay, but not out of a form field",
    needs: (data) => replays(1)(data) && data.replays[0].frames > 2,
    async run({ page, data }) {
      const { frames } = data.replays.find((item) => item.id === replayed(data)[0]);
      await page.locator(test("scene")).scrollIntoViewIfNeeded();
      await settle(page);
      await page.keyboard.press("Home");
      assert.equal(await frameOf(page), 0);
      await page.keyboard.press("ArrowRight");
      assert.equal(await frameOf(page), 1);
      await page.keyboard.press("End");
      assert.equal(await frameOf(page), frames - 1);
      await page.keyboard.press("ArrowLeft");
      assert.equal(await frameOf(page), frames - 2);
      await page.locator(test("assess-by")).focus();
      await page.keyboard.press("Home");
      assert.equal(await frameOf(page), frames - 2);
    },
  },
  {
    name: "a click into a plot goes to its time",
    needs: replays(1),
    async run({ page, data }) {
      const { frames } = data.replays.find((item) => item.id === replayed(data)[0]);
      const over = page.locator(`${test("plots")} .u-over`);
      for (let index = 0; index < (await over.count()); index++) {
        const { width } = await over.nth(index).boundingBox();
        await over.nth(index).click({ position: { x: width * 0.25 * (index + 1), y: 20 } });
        assert.ok(Math.abs((await frameOf(page)) - 0.25 * (index + 1) * (frames - 1)) <= 1);
      }
    },
  },
  {
    name: "a bin of the map filters the table",
    needs: hazards(1),
    async run({ page, data }) {
      const bin = page.locator(test("map-bin")).first();
      await bin.focus();
      const told = await page.locator(test("bin")).textContent();
      const number = Number(told.match(/: (\d+) hazard/)[1]);
      await page.keyboard.press("Enter");
      assert.equal(await rows(page).count(), number);
      await page.locator(test("clear-bin")).click();
      assert.equal(await rows(page).count(), data.scan.hazards.length);
    },
  },
  {
    name: "the form saves what was edited together with what was given",
    main: true,
    needs: hazards(1),
    async run({ page, data }) {
      const { id } = data.scan.hazards[0];
      const measure = 'close the gap, "check" it <again>';
      await page.locator(test("assess-severity")).selectOption("S2");
      await page.locator(test("assess-measure")).fill(measure);
      await page.locator(test("assess-decision")).selectOption("reduce");
      assert.match(await page.locator(test("unsaved")).textContent(), /1 hazard/);
      assert.equal(await page.locator(`${test("row")}[data-id="${id}"] td`).last().textContent(), "reduce");
      const [download] = await Promise.all([page.waitForEvent("download"), page.locator(test("save")).click()]);
      assert.equal(download.suggestedFilename(), "assessments.json");
      const text = await readFile(await download.path(), "utf8");
      const saved = JSON.parse(text);
      assert.equal(saved.format, 1);
      assert.equal(saved.cell, data.cell.name);
      const edited = saved.assessments[id];
      assert.deepEqual([edited.severity, edited.measure, edited.decision], ["S2", measure, "reduce"]);
      for (const [other, fields] of Object.entries(data.assessments)) {
        if (other !== id) {
          assert.deepEqual(saved.assessments[other], fields);
        }
      }
      const keys = Object.keys(saved.assessments);
      assert.deepEqual(keys, [...keys].sort());
      assert.equal(await page.locator(test("unsaved")).textContent(), "");
    },
  },
  {
    name: "prints a drawing and the facts for each replayed hazard",
    needs: replays(1),
    async run({ page, data }) {
      const pdf = await page.pdf({ format: "A4" });
      assert.ok(pdf.length > 10_000);
      await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
      assert.equal(await page.locator("#print article").count(), data.replays.length);
      const drawings = data.replays.filter((replay) => replay.top_view).length;
      assert.equal(await page.locator("#print article > svg").count(), drawings);
    },
  },
  {
    name: "works without 3-D graphics",
    graphics: false,
    needs: replays(1),
    async run({ page, data }) {
      await page.locator(test("no-webgl")).waitFor();
      await page.locator(".flat svg").waitFor();
      await setScrub(page, 0);
      assert.match(await page.locator(test("instant")).textContent(), /^0\.00 s/);
      const id = replayed(data).at(-1);
      await page.locator(`${test("row")}[data-id="${id}"] a`).click();
      assert.equal(await selected(page), id);
      assert.equal(await page.locator(`${test("plots")} canvas`).count(), 3);
    },
  },
];

/** Runs every check that the report is fit for, or the main ones; hears of each with its outcome, null being a pass. */
export async function checkReport(file, browsers, hear, onlyMain = false) {
  const looked = await open(browsers.plain, file);
  const { data } = looked;
  await looked.close();
  for (const { name, needs, run, main = false, graphics = true } of CHECKS) {
    if (needs(data) && (main || !onlyMain)) {
      const browser = graphics ? browsers.graphics : browsers.plain;
      const opened = await open(browser, file);
      let outcome = null;
      try {
        await settle(opened.page);
        await run({ ...opened, browser, file });
        await settle(opened.page);
        assert.deepEqual(opened.said, [], "errors, warnings or requests");
      } catch (error) {
        outcome = error;
      }
      await opened.close();
      hear(name, outcome);
    }
  }
}

/** Both browsers for as long as `work` needs them. */
export async function withBrowsers(work) {
  const [graphics, plain] = await Promise.all([launch(), launch({ graphics: false })]);
  try {
    return await work({ graphics, plain });
  } finally {
    await Promise.all([graphics.close(), plain.close()]);
  }
}
