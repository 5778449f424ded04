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
/** A common screen of an office, and one of a phone. */
const OFFICE = { width: 1440, height: 900 };
const PHONE = { width: 390, height: 844 };

/** Starts a browser, with or without 3-D graphics. */
export function launch({ graphics = true } = {}) {
  const args = ["--headless", "--no-sandbox", ...(graphics ? SOFTWARE_GL : ["--disable-3d-apis"])];
  return chromium.launch({ executablePath: EXECUTABLE, args });
}

const test = (name) => `[data-test="${name}"]`;

/** Opens a report and keeps what it says on the console and which requests it makes. */
async function open(browser, file, { hash = "", deviceScaleFactor = 1 } = {}) {
  const context = await browser.newContext({ viewport: VIEWPORT, deviceScaleFactor, acceptDownloads: true });
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
/** Pages of a PDF that Chromium wrote. */
const pagesOf = (pdf) => (pdf.toString("latin1").match(/\/Type\s*\/Page\b(?!s)/g) ?? []).length;

/** Opens the folded table. */
const unfold = (page) => page.locator(test("ways")).evaluate((details) => (details.open = true));

/** What the scene says that it draws. */
const drawn = async (page) => JSON.parse(await page.locator(test("scene")).getAttribute("data-drawn"));

const card = (page, id) => page.locator(`${test("cause")}[data-id="${id}"]`);
const chosenCard = (page) => page.locator(`${test("cause")}[aria-current]`).getAttribute("data-id");
const causeOf = (data, id) => data.scan.causes.find((cause) => cause.hazards.includes(id));

const rows = (page) => page.locator(test("row"));
const selected = (page) => page.locator(`${test("row")}[aria-selected="true"]`).getAttribute("data-id");
const replayed = (data) => data.scan.hazards.map((z) => z.id).filter((id) => data.replays.some((replay) => replay.id === id));

/** Needs that a check has of a report. */
const any = () => true;
const withFloor = (data) => data.whole !== undefined;
const hazards = (number) => (data) => data.scan.hazards.length >= number;
const replays = (number) => (data) => replayed(data).length >= number;

/** The checks: what they show, what a report needs for them, and the browser they run in; `flat` ones need no 3-D graphics, without which
 * a page opens much sooner, and `bare` ones nothing but a report. */
export const CHECKS = [
  {
    name: "says what was found, and what that is worth",
    flat: true,
    bare: true,
    needs: any,
    async run({ page, data }) {
      assert.equal(await page.locator("h1").textContent(), data.cell.name);
      assert.match(await page.locator(test("verdict")).textContent(), /\.$/);
      assert.equal(await page.locator(test("verdict")).textContent(), data.scan.headline.says);
      assert.equal(await page.locator(test("scope")).textContent(), data.scan.headline.covers);
      assert.equal(await page.locator(`${test("rests-on")} tbody tr`).count(), data.scan.obligations.length);
      const accepts = data.scan.obligations.filter(({ accept }) => accept);
      assert.equal(await page.locator(test("accept")).count(), accepts.length > 0 ? 1 : 0);
      assert.equal(await page.locator(`${test("assumptions")} li`).count(), data.assumptions.length);
      assert.ok(!(await page.locator("#report").textContent()).includes("undefined"), "nothing is left unsaid");
      const text = await page.locator("#report").textContent();
      data.cell.sensors.forEach((name, index) => {
        assert.ok(text.includes(`${name} in ${data.scan.coverage.sensor_actions[index].toLocaleString("en")} action`), name);
      });
      assert.ok(!text.includes("[object"), "everything is in words");
      const again = data.scan.certificate?.run_again;
      assert.equal(text.includes("FMU transitions run again from the start"), again?.compared > 0);
    },
  },
  {
    name: "puts nothing of the data into the page as markup",
    flat: true,
    bare: true,
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
    flat: true,
    bare: true,
    needs: (data) => data.scan.hazards.length === 0,
    async run({ page }) {
      await page.locator(test("none")).waitFor();
      assert.equal(await page.locator(test("scene")).count(), 0);
      assert.equal(await rows(page).count(), 0);
    },
  },
  {
    name: "has a row for each hazard, and the filter leaves some out",
    flat: true,
    needs: hazards(1),
    async run({ page, data }) {
      assert.equal(await page.locator(test("ways")).evaluate((details) => details.open), false);
      assert.equal(await rows(page).count(), data.scan.hazards.length);
      await unfold(page);
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
    flat: true,
    needs: hazards(2),
    async run({ page }) {
      await unfold(page);
      const buttons = page.locator("[data-test^=sort-]");
      for (let index = 0; index < (await buttons.count()); index++) {
        await buttons.nth(index).click();
        const head = page.locator(".hazards th").nth(index);
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
      await unfold(page);
      await page.locator(`${test("row")}[data-id="${id}"] a`).click();
      assert.equal(await selected(page), id);
      assert.equal(await chosenCard(page), causeOf(data, id).id);
      assert.equal(await page.evaluate(() => location.hash), `#${id}`);
      assert.equal(await page.evaluate(() => history.length), length);
      assert.match(await page.locator("#replay-title").textContent(), new RegExp(id));
      assert.ok((await compare(browser, before, await picture(page))).differing > 0.0005);
    },
  },
  {
    name: "tells how to get a replay that it does not carry",
    flat: true,
    needs: (data) => data.scan.hazards.length > replayed(data).length,
    async run({ page, data }) {
      const missing = data.scan.hazards.find((z) => !replayed(data).includes(z.id));
      await unfold(page);
      await page.locator(`${test("row")}[data-id="${missing.id}"] a`).click();
      assert.match(await page.locator(test("no-replay")).textContent(), new RegExp(`fmi-hazard report \\. --hazard ${missing.id}`));
      assert.match(await page.locator(test("facts")).textContent(), /F = v/);
    },
  },
  {
    name: "a link with an id selects it, and a change of the address is followed",
    flat: true,
    main: true,
    needs: hazards(1),
    async run({ browser, file, data }) {
      const id = data.scan.hazards.at(-1).id;
      const linked = await open(browser, file, { hash: `#${id}` });
      assert.equal(await selected(linked.page), id);
      assert.equal(await linked.page.locator(test("ways")).evaluate((details) => details.open), true);
      const first = data.scan.hazards[0].id;
      await linked.page.evaluate((to) => (location.hash = to), first);
      await settle(linked.page);
      assert.equal(await selected(linked.page), first);
      await linked.page.evaluate(() => (location.hash = "H-none"));
      await linked.page.locator(test("unknown-id")).waitFor();
      assert.equal(await selected(linked.page), first);
      const cause = data.scan.causes.at(-1);
      await linked.page.evaluate((to) => (location.hash = to), cause.id);
      await settle(linked.page);
      assert.equal(await chosenCard(linked.page), cause.id);
      assert.equal(await selected(linked.page), cause.worst);
      assert.deepEqual(linked.said, []);
      await linked.close();
    },
  },
  {
    name: "plays on to the last frame and stops there",
    flat: true,
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
    flat: true,
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
    flat: true,
    needs: hazards(1),
    async run({ page, data }) {
      const bin = page.locator(test("map-bin")).first();
      await bin.focus();
      const told = await page.locator(test("bin")).textContent();
      const number = Number(told.match(/: (\d+) hazard/)[1]);
      await page.keyboard.press("Enter");
      assert.equal(await rows(page).count(), number);
      assert.equal(await page.locator(test("ways")).evaluate((details) => details.open), true);
      await page.locator(test("clear-bin")).click();
      assert.equal(await rows(page).count(), data.scan.hazards.length);
    },
  },
  {
    name: "the form saves what was edited together with what was given",
    flat: true,
    main: true,
    needs: hazards(1),
    async run({ page, data }) {
      const [cause] = data.scan.causes;
      const { id } = cause;
      const rowDecision = (hazard) => page.locator(`${test("row")}[data-id="${hazard}"] td`).last();
      const measure = 'close the gap, "check" it <again>';
      await page.locator(test("assess-task")).fill("clears jams");
      await page.locator(test("assess-severity")).selectOption("S2");
      await page.locator(test("assess-exposure")).selectOption("F1");
      assert.doesNotMatch(await page.locator(test("plr")).textContent(), /PL r: [a-e]$/);
      await page.locator(test("assess-avoidance")).selectOption("P2");
      assert.match(await page.locator(test("plr")).textContent(), /PL r: d$/);
      await page.locator(test("assess-measure")).fill(measure);
      await page.locator(test("assess-decision")).selectOption("reduce");
      assert.match(await page.locator(test("unsaved")).textContent(), /1 cause\./);
      assert.match(await card(page, id).locator(test("cause-decision")).textContent(), /reduce · PL r: d/);
      for (const hazard of cause.hazards.slice(0, 3)) {
        const own = data.assessments[hazard]?.decision;
        assert.equal(await rowDecision(hazard).textContent(), own || "reduce");
      }
      // One row by itself: its own decision goes before that of the cause.
      await page.locator(test("assess-scope")).check();
      await page.locator(test("assess-decision")).selectOption("accepted");
      assert.match(await page.locator(test("unsaved")).textContent(), /1 cause and 1 single way\./);
      assert.equal(await rowDecision(cause.worst).textContent(), "accepted");
      await page.locator(test("assess-scope")).uncheck();
      assert.equal(await page.locator(test("assess-decision")).inputValue(), "reduce");
      await unfold(page);
      await page.locator(test("filter-decision")).selectOption("accepted");
      assert.ok((await rows(page).count()) >= 1);
      await page.locator(test("filter-decision")).selectOption("");
      const [download] = await Promise.all([page.waitForEvent("download"), page.locator(test("save")).click()]);
      assert.equal(download.suggestedFilename(), "assessments.json");
      const text = await readFile(await download.path(), "utf8");
      const saved = JSON.parse(text);
      assert.equal(saved.format, 1);
      assert.equal(saved.cell, data.cell.name);
      const edited = saved.assessments[id];
      assert.deepEqual([edited.task, edited.severity, edited.measure, edited.decision], ["clears jams", "S2", measure, "reduce"]);
      assert.equal(saved.assessments[cause.worst].decision, "accepted");
      for (const [other, fields] of Object.entries(data.assessments)) {
        if (other !== id && other !== cause.worst) {
          assert.deepEqual(saved.assessments[other], fields);
        }
      }
      const keys = Object.keys(saved.assessments);
      assert.deepEqual(keys, [...keys].sort());
      assert.equal(await page.locator(test("unsaved")).textContent(), "");
    },
  },
  {
    name: "prints a page to sign and a page for each cause, and few others",
    flat: true,
    needs: hazards(1),
    async run({ page, data }) {
      const number = data.scan.causes.length;
      const pages = pagesOf(await page.pdf({ preferCSSPageSize: true }));
      assert.ok(pages > number && pages <= 4 + number, `${pages} pages for ${number} causes`);
      assert.equal(await page.locator("#print > *").count(), 0, "nothing is left of the printed part");
      await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
      const first = await page.locator(test("print-first")).textContent();
      for (const text of [data.cell.name, "Signature", ...data.scan.causes.map((cause) => cause.sentence)]) {
        assert.ok(first.includes(text), text);
      }
      assert.equal(await page.locator(test("print-cause")).count(), number);
      const worst = new Set(data.scan.causes.map((cause) => cause.worst));
      const drawings = data.replays.filter(({ id, top_view: view }) => worst.has(id) && view).length;
      assert.equal(await page.locator(".print-pictures > svg").count(), drawings);
    },
  },
  {
    name: "shows verdict, worst cause, its picture and its remedy on the first screen",
    main: true,
    needs: (data) => replays(1)(data) && !withFloor(data),
    async run({ page, data }) {
      await page.setViewportSize(OFFICE);
      await settle(page);
      const [cause] = data.scan.causes;
      assert.equal(await chosenCard(page), cause.id);
      const worst = card(page, cause.id);
      assert.equal(await worst.locator(test("cause-sentence")).textContent(), cause.sentence);
      const changes = cause.advice?.changes.length ?? 0;
      assert.equal(await worst.locator(test("change")).count(), changes);
      const parts = [page.locator(test("verdict")), worst.locator(test("cause-sentence")), page.locator(test("scene"))];
      const remedy = changes > 0 ? worst.locator(test("change")).first() : worst.locator(".remedy");
      for (const part of [...parts, remedy, worst.locator(test("body-outline"))]) {
        const { x, y, width, height } = await part.boundingBox();
        assert.ok(x >= 0 && y >= 0 && x + width <= OFFICE.width && y + height <= OFFICE.height, `${await part.evaluate((e) => e.outerHTML.slice(0, 80))}: ${y + height}`);
      }
    },
  },
  {
    name: "has a card for each cause, its ways folded, and selects them",
    flat: true,
    main: true,
    needs: hazards(1),
    async run({ page, data }) {
      const { causes } = data.scan;
      assert.equal(await page.locator(test("cause")).count(), causes.length);
      for (const cause of causes.slice(-2)) {
        await card(page, cause.id).locator(`${test("cause-sentence")} a`).click();
        assert.equal(await chosenCard(page), cause.id);
        assert.equal(await selected(page), cause.worst);
        assert.equal(await page.evaluate(() => location.hash), `#${cause.id}`);
        const text = await card(page, cause.id).textContent();
        assert.doesNotMatch(text.replaceAll(/[CH]-[0-9a-f]+/g, ""), /\de[-+]\d/, "a number in a notation to decode");
        if (typeof cause.share === "number") {
          assert.match(text, /% of all sequences/);
        }
        const size = await card(page, cause.id).locator(".severity").textContent();
        assert.equal(size, data.words.causes[cause.id].severity.join(" "));
        assert.equal(size.includes("a moving robot may not touch it"), ["head_contact", "moving_contact"].includes(cause.class));
        assert.equal(await card(page, cause.id).locator(test("way")).count(), cause.hazards.length);
        assert.equal(await card(page, cause.id).locator(test("way")).first().isVisible(), false);
        const { body_region: region } = data.scan.hazards.find((z) => z.id === cause.worst);
        assert.ok((await card(page, cause.id).locator(`${test("body-outline")} .hit.selected[data-region="${region}"]`).count()) > 0, region);
        const label = await card(page, cause.id).locator(`${test("body-outline")} svg`).getAttribute("aria-label");
        assert.match(label, /Hit: .*x/);
        const id = cause.hazards.at(-1);
        await card(page, cause.id).locator(`${test("lines")} > summary`).click();
        const line = card(page, cause.id).locator(test("line")).filter({ has: page.locator(`[data-id="${id}"]`) });
        await line.locator("summary").click();
        await line.locator(`[data-id="${id}"]`).click();
        assert.equal(await selected(page), id);
        assert.equal(await chosenCard(page), cause.id);
      }
    },
  },
  {
    name: "draws the person with arms of the model's size, in the picture from the first frame on",
    needs: replays(1),
    async run({ page, data }) {
      await page.setViewportSize(OFFICE);
      await settle(page);
      for (const id of replayed(data).slice(0, 4)) {
        await page.evaluate((to) => (location.hash = to), id);
        await settle(page);
        const { arm, contact_frame: contact } = data.replays.find((replay) => replay.id === id);
        const { body_region: region } = data.scan.hazards.find((z) => z.id === id);
        const now = await drawn(page);
        assert.equal(now.upper_arm_radius_m, data.cell.arm.upper_arm_radius_m);
        assert.equal(now.forearm_radius_m, data.cell.arm.forearm_radius_m);
        assert.equal(now.hand_sphere_m, arm && region === "hand" ? data.cell.arm.hand_radius_m : null);
        assert.equal(now.touched === "body", arm === null);
        assert.equal(now.outside, 0, "what must be seen is in the picture");
        await setScrub(page, 0);
        const { outside, hand_sphere_m: sphere } = await drawn(page);
        assert.equal(outside, 0);
        assert.equal(sphere, contact === 0 ? now.hand_sphere_m : null);
      }
    },
  },
  {
    name: "names link, obstacles and zones over the scene, until they are switched off",
    needs: replays(1),
    async run({ page, data }) {
      const names = page.locator(test("labels"));
      const text = await names.textContent();
      const { robot_link: link } = data.scan.hazards.find((z) => z.id === replayed(data)[0]);
      for (const name of [link.split("/").at(-1), ...data.cell.zones.map((zone) => zone.name)]) {
        assert.ok(text.includes(name), name);
      }
      assert.equal(await names.locator(".hitting").isVisible(), true);
      await page.locator(test("names")).click();
      assert.equal(await names.isVisible(), false);
      await page.locator(test("names")).click();
      assert.equal(await names.isVisible(), true);
    },
  },
  {
    name: "tells both forces, which of them decides, and what happens when",
    flat: true,
    needs: replays(1),
    async run({ page, data }) {
      const hazard = data.scan.hazards.find((z) => z.id === replayed(data)[0]);
      const forces = await page.locator(test("forces")).textContent();
      for (const text of ["with the robot's own speed", "with the speed of approach", `${hazard.force_n.toFixed(0)} N`, `${hazard.directed_force_n.toFixed(0)} N`, "(decides)"]) {
        assert.ok(forces.includes(text), text);
      }
      const own = hazard.force_n / hazard.limit_n;
      const apart = Math.max(own, hazard.directed_ratio) > 2 * Math.min(own, hazard.directed_ratio);
      assert.equal(await page.locator(`${test("forces")} ${test("apart")}`).count(), apart ? 1 : 0);
      const replay = data.replays.find((item) => item.id === hazard.id);
      const events = page.locator(`${test("events")} button`);
      const reports = replay.sensors.filter((sensor) => sensor.detected.includes("1")).length;
      assert.ok((await events.count()) >= 1 + reports);
      await setScrub(page, 0);
      await page.locator(`${test("events")} .contact`).click();
      assert.equal(await frameOf(page), replay.contact_frame);
    },
  },
  {
    name: "fits a phone",
    flat: true,
    main: true,
    needs: any,
    async run({ page }) {
      await page.setViewportSize(PHONE);
      await settle(page);
      const width = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(width <= PHONE.width, `${width} px wide`);
    },
  },
  {
    name: "shows the floor at once, and reads it by pointer and by key",
    main: true,
    needs: withFloor,
    async run({ page, data: { whole } }) {
      await page.setViewportSize(OFFICE);
      await settle(page);
      assert.equal(await page.locator(test("whole-head")).textContent(), whole.said);
      assert.equal(await page.locator(test("whole-square")).count(), whole.floor.length);
      const map = page.locator(test("whole-map"));
      const { y, height } = await map.boundingBox();
      assert.ok(y >= 0 && y + height <= OFFICE.height, `the map ends at ${y + height} px`);
      const told = page.locator(test("whole-told"));
      await map.focus();
      await page.keyboard.press("ArrowRight");
      const worst = Math.max(...whole.floor.map(({ ratio }) => ratio));
      assert.match(await told.textContent(), whole.floor.length > 0 ? new RegExp(`up to ${worst.toFixed(2)}x, first at [0-9.]+ s`) : /(not known|no hit found|not looked at to the end)$/);
      const before = await told.textContent();
      await page.keyboard.press("ArrowUp");
      assert.notEqual(await told.textContent(), before);
      const unclear = page.locator(`${test("whole-map")} .open rect`);
      if ((await unclear.count()) > 0) {
        await unclear.first().hover({ force: true });
        assert.match(await told.textContent(), /: not known$/);
      }
      const key = await page.locator(test("whole-key")).textContent();
      assert.deepEqual([key.includes("no hit found"), key.includes("not looked at to the end")], [whole.looked_at, !whole.looked_at]);
    },
  },
  {
    name: "colours the floor by how hard, how early, and at one moment",
    needs: (data) => withFloor(data) && data.whole.floor.length > 0,
    async run({ page, data: { whole } }) {
      const fills = () => page.locator(test("whole-square")).evaluateAll((all) => all.map((square) => square.style.fill));
      const hard = await fills();
      assert.ok(hard.every((fill) => fill !== ""));
      await page.locator(test("whole-earliest")).check();
      const early = await fills();
      const of = (least) => early[whole.floor.reduce((a, b, index) => (least(b.earliest_s, whole.floor[a].earliest_s) ? index : a), 0)];
      const [first, last] = [of((a, b) => a < b), of((a, b) => a > b)];
      assert.equal(first === last, new Set(whole.floor.map(({ earliest_s: at }) => at)).size === 1);
      assert.equal(await page.locator(test("whole-moment")).count(), whole.followed ? 1 : 0);
      if (!whole.followed) {
        return;
      }
      const [span] = whole.floor[0].spans[0];
      await page.locator(test("whole-slider")).fill(String(span));
      assert.ok(await page.locator(test("whole-moment")).isChecked());
      const now = await fills();
      whole.floor.forEach((square, index) => assert.equal(now[index] !== "", square.spans.some(([at]) => at === span), `${square.xy_m}`));
      assert.match(await page.locator(test("whole-now")).textContent(), /hits on [0-9.]+ m²$/);
    },
  },
  {
    name: "numbers the worst places, and prints the floor",
    needs: (data) => withFloor(data) && hazards(1)(data),
    async run({ page, data: { whole } }) {
      const number = Math.min(6, whole.places.length);
      assert.equal(await page.locator(test("whole-place")).count(), number);
      assert.equal(await page.locator("#whole .whole-places li").count(), number);
      await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
      assert.equal(await page.locator(`${test("print-whole")} ${test("whole-square")}`).count(), whole.floor.length);
      await page.evaluate(() => dispatchEvent(new Event("afterprint")));
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
      const { bottom } = await page.locator(".flat svg").evaluate((drawing) => drawing.getBoundingClientRect());
      // The floor comes before it.
      assert.ok(withFloor(data) || bottom <= OFFICE.height, `the drawing ends at ${bottom} px`);
      const id = replayed(data).at(-1);
      await unfold(page);
      await page.locator(`${test("row")}[data-id="${id}"] a`).click();
      assert.equal(await selected(page), id);
      assert.equal(await page.locator(`${test("plots")} canvas`).count(), 3);
    },
  },
];

/**
 * Runs every check that the report is fit for and that is wanted; hears of each with its outcome, null being a pass. Quickly: pictures of
 * a quarter of the size, and none for checks that need none.
 */
export async function checkReport(file, browsers, hear, { wanted = () => true, quick = false } = {}) {
  const looked = await open(browsers.plain, file);
  const { data } = looked;
  await looked.close();
  for (const check of CHECKS) {
    const { name, needs, run, flat = false, graphics = true } = check;
    if (needs(data) && wanted(check)) {
      const browser = graphics && !(quick && flat) ? browsers.graphics : browsers.plain;
      const opened = await open(browser, file, { deviceScaleFactor: quick ? 0.25 : 1 });
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
