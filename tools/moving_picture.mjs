#!/usr/bin/env node
// Makes a moving picture of a replay for README files: an animated PNG of the worst hazard in a report.
//
//     tools/moving_picture.mjs REPORT.html [OUT.png]
//
// REPORT.html#H-95806f takes another hazard or cause. It needs the packages of the viewer (npm ci --prefix viewer) and
// Chromium: /usr/bin/chromium, or the path in CHROMIUM. The picture shows what the report shows, at half speed: stage, time line
// and legend, without buttons and names. It begins with the contact, rests there, and then shows from the start how it came to it.
// So a program that knows no moving pictures shows the contact.

import { writeFile } from "node:fs/promises";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { deflateSync, gunzipSync } from "node:zlib";
import { launch } from "../viewer/test/report.mjs";

/** The window; in one so narrow the stage takes the whole width. */
const WINDOW = { width: 780, height: 900 };
/** About so many moments are shown, the contact not counted. */
const MOMENTS = 24;
const SLOWER = 2;
const REST_MS = 1500;
/** Only what says something without a mouse, in a corner of the window; the text of the moment always has two lines. */
const STYLE = `.shown-hazard, .views, .events, .transport button, .transport label, .pointed { display: none !important; }
  .picture { position: fixed; left: 0; top: 0; z-index: 9; width: 720px; padding: 6px; background: #ffffff; box-shadow: 0 0 0 2px #ffffff; }
  .instant { min-height: 2.9em; margin: 0; }`;
/** Waits until the page has drawn what it has to draw. */
const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 60)))));

/** Takes a picture of each moment: how long it is shown, and its PNG; the contact first. */
async function take(browser, address) {
  const page = await browser.newPage({ viewport: WINDOW, colorScheme: "light" });
  await page.goto(address);
  await page.locator("#provenance").waitFor();
  const data = JSON.parse(await page.locator("#data").textContent());
  const picture = page.locator(".picture");
  if (data.scan.hazards.length === 0 || !(await picture.locator('[data-test="scene"]').isVisible())) {
    throw new Error("nothing to show: the report has no hazard, or no replay of this one, or the browser no 3-D graphics");
  }
  await page.locator('[data-test="names"]').click();
  await page.addStyleTag({ content: STYLE });
  await settle(page);
  const shown = (await picture.locator(".shown-hazard .id").textContent()).trim();
  const { contact_frame: contact } = JSON.parse(gunzipSync(Buffer.from(data.replays, "base64"))).find(({ id }) => id === shown);
  const step = Math.ceil(contact / MOMENTS);
  const moments = [{ frame: contact, ms: REST_MS }];
  for (let frame = contact % step; frame < contact; frame += step) {
    moments.push({ frame, ms: Math.round(1000 * SLOWER * step * data.cell.step_s) });
  }
  for (const moment of moments) {
    await page.locator('[data-test="scrub"]').evaluate((input, frame) => {
      input.value = frame;
      input.dispatchEvent(new Event("input"));
    }, moment.frame);
    await settle(page);
    moment.png = await picture.screenshot();
  }
  await page.close();
  return moments;
}

/** The colours of a PNG, four bytes a pixel, as the browser reads it in a page without a content policy. */
async function decode(page, png) {
  const { width, height, base64 } = await page.evaluate(async (source) => {
    const image = new Image();
    image.src = `data:image/png;base64,${source}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height).getContext("2d");
    canvas.drawImage(image, 0, 0);
    const reader = new FileReader();
    reader.readAsDataURL(new Blob([canvas.getImageData(0, 0, image.width, image.height).data]));
    await new Promise((done) => (reader.onload = done));
    return { width: image.width, height: image.height, base64: reader.result.split(",")[1] };
  }, png.toString("base64"));
  return { width, height, bytes: Buffer.from(base64, "base64") };
}

/** Colours nearly alike share a drawer: six bits each of red, green and blue. */
const drawer = (bytes, at) => ((bytes[at] >> 2) << 12) | ((bytes[at + 1] >> 2) << 6) | (bytes[at + 2] >> 2);

/**
 * At most `count` colours for all pictures, and for each drawer the number of its colour. All colours begin in one box; the box
 * whose colours differ most, by how often they occur, is cut at its mean across the longest side, until there are enough.
 */
function palette(pictures, count) {
  const drawers = new Map();
  for (const { bytes } of pictures) {
    for (let at = 0; at < bytes.length; at += 4) {
      const key = drawer(bytes, at);
      const found = drawers.get(key) ?? { key, pixels: 0, sum: [0, 0, 0] };
      found.pixels += 1;
      found.sum = found.sum.map((value, i) => value + bytes[at + i]);
      drawers.set(key, found);
    }
  }
  function box(list) {
    const pixels = list.reduce((sum, item) => sum + item.pixels, 0);
    const mean = [0, 1, 2].map((i) => list.reduce((sum, item) => sum + item.sum[i], 0) / pixels);
    const spread = mean.map((m, i) => list.reduce((sum, item) => sum + item.pixels * (item.sum[i] / item.pixels - m) ** 2, 0));
    const side = spread.indexOf(Math.max(...spread));
    // Large plain areas must not take all colours, so frequency counts less than in proportion.
    return { list, mean, side, weight: list.length > 1 ? spread[side] / Math.sqrt(pixels) : 0 };
  }
  const boxes = [box([...drawers.values()])];
  while (boxes.length < count) {
    boxes.sort((a, b) => b.weight - a.weight);
    if (boxes[0].weight === 0) {
      break;
    }
    const { list, mean, side } = boxes.shift();
    const low = list.filter((item) => item.sum[side] / item.pixels <= mean[side]);
    boxes.push(box(low), box(list.filter((item) => !low.includes(item))));
  }
  const numbers = new Map(boxes.flatMap(({ list }, number) => list.map(({ key }) => [key, number])));
  return { colours: boxes.map(({ mean }) => mean.map(Math.round)), numbers };
}

/** The smallest rectangle in which a picture differs from the one before; in it, what is equal is transparent. */
function difference(now, before, width, height, transparent) {
  let [left, right, top, bottom] = [width, -1, height, -1];
  now.forEach((value, at) => {
    if (value !== before[at]) {
      const [x, y] = [at % width, Math.floor(at / width)];
      [left, right, top, bottom] = [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)];
    }
  });
  if (right < 0) {
    return { x: 0, y: 0, width: 1, height: 1, pixels: Uint8Array.of(transparent) };
  }
  const size = { width: right - left + 1, height: bottom - top + 1 };
  const pixels = Uint8Array.from({ length: size.width * size.height }, (_, i) => {
    const at = (top + Math.floor(i / size.width)) * width + left + (i % size.width);
    return now[at] === before[at] ? transparent : now[at];
  });
  return { x: left, y: top, ...size, pixels };
}

const CRC = Uint32Array.from({ length: 256 }, (_, n) => Array.from({ length: 8 }).reduce((c) => (c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1), n));
const crc32 = (bytes) => ~bytes.reduce((crc, byte) => CRC[(crc ^ byte) & 255] ^ (crc >>> 8), ~0) >>> 0;
const numbers32 = (...values) => Buffer.concat(values.map((value) => Buffer.from(Uint32Array.of(value).buffer).swap32()));

/** A piece of a PNG file: length, name, content, check sum. */
function chunk(name, ...parts) {
  const body = Buffer.concat([Buffer.from(name, "latin1"), ...parts]);
  return Buffer.concat([numbers32(body.length - 4), body, numbers32(crc32(body))]);
}

/** Rows of numbers of colours, each behind a zero for "as they are", compressed. */
function compressed({ width, height, pixels }) {
  const rows = Array.from({ length: height }, (_, y) => [Buffer.of(0), Buffer.from(pixels.subarray(y * width, (y + 1) * width))]);
  return deflateSync(Buffer.concat(rows.flat()), { level: 9, memLevel: 9 });
}

/** The animated PNG of pictures of the same size, each shown for its milliseconds, again and again. */
function animated(pictures, { colours, numbers }) {
  const { width, height } = pictures[0];
  const transparent = colours.length;
  const indexed = pictures.map(({ bytes }) => Uint8Array.from({ length: width * height }, (_, i) => numbers.get(drawer(bytes, 4 * i))));
  const head = Buffer.concat([numbers32(width, height), Buffer.of(8, 3, 0, 0, 0)]);
  const alpha = Buffer.from(colours.map(() => 255).concat(0));
  const chunks = [chunk("IHDR", head), chunk("acTL", numbers32(pictures.length, 0)), chunk("PLTE", Buffer.from([...colours, [0, 0, 0]].flat())), chunk("tRNS", alpha)];
  let sequence = 0;
  indexed.forEach((pixels, i) => {
    const part = i === 0 ? { x: 0, y: 0, width, height, pixels } : difference(pixels, indexed[i - 1], width, height, transparent);
    // Shown for so many thousandths of a second; what was there stays (0), the new is drawn over it (1).
    const { ms } = pictures[i];
    const timing = Buffer.of(ms >> 8, ms & 255, 1000 >> 8, 1000 & 255, 0, i === 0 ? 0 : 1);
    chunks.push(chunk("fcTL", numbers32(sequence++, part.width, part.height, part.x, part.y), timing));
    chunks.push(i === 0 ? chunk("IDAT", compressed(part)) : chunk("fdAT", numbers32(sequence++), compressed(part)));
  });
  return Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), ...chunks, chunk("IEND")]);
}

const [report, out = "replay.png"] = process.argv.slice(2);
if (!report) {
  console.error("usage: tools/moving_picture.mjs REPORT.html [OUT.png]");
  process.exit(2);
}
const [file, hash] = report.split("#");
const browser = await launch();
try {
  const moments = await take(browser, pathToFileURL(path.resolve(file)).href + (hash ? `#${hash}` : ""));
  const page = await browser.newPage();
  const pictures = [];
  for (const { png, ms } of moments) {
    pictures.push({ ms, ...(await decode(page, png)) });
  }
  const bytes = animated(pictures, palette(pictures, 255));
  await writeFile(out, bytes);
  const [{ width, height }] = pictures;
  console.log(`${out}: ${pictures.length} pictures of ${width} x ${height}, ${Math.round(bytes.length / 1000)} kB`);
} catch (error) {
  console.error(error.message);
  process.exitCode = 1;
} finally {
  await browser.close();
}
