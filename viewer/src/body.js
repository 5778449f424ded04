// A person drawn front and back, with the regions of ISO/TS 15066 as areas of which those that are hit are marked.

import { h, svg } from "./dom.js";

/** Width of one figure, and where its middle is. */
const WIDTH = 100;
const HEIGHT = 212;

/** No region that is hit is paler than this part of the darkest. */
const PALEST = 0.3;

/** Areas on the person's one side, which are mirrored to the other. */
const LIMBS = [
  ["upper_arm", "M27.4 46.5 C25 54 21.4 70 20 82 L28.2 84.2 C29.6 74 32.6 62 34 52.5 L34 46 C31.6 43.2 29 43.6 27.4 46.5 Z"],
  ["lower_arm", "M19.8 83.6 C17.4 92 15.6 103 14.8 112 L21.2 113.6 C23.6 105 26.9 95 28 85.8 Z"],
  ["hand", "M14.6 113.6 C11.8 118 11.2 124 12.8 129.5 C14.8 132.5 18 131.8 19 128.4 L22.6 124.2 C23.4 121 21.6 118 21 115.2 Z"],
  ["thigh", "M32.2 104.8 C31.4 118 33 134 35.2 149 L46.2 149 C47.8 136 48.9 122 48.9 108.6 Z"],
  ["lower_leg", "M35.3 150.6 C33.8 160 34.6 174 37 190 C36.6 195 33.6 199.4 32.6 203.4 C34.6 206.6 43.4 206.6 45.2 203.4 C45.2 198 44.3 195 44.5 190 C46.4 176 47.5 162 46.2 150.6 Z"],
];

const PELVIS = ["pelvis", "M35 86.2 C33.4 91 32.5 97 32.2 103.2 L48.6 107.2 L50 104.4 L51.4 107.2 L67.8 103.2 C67.5 97 66.6 91 65 86.2 Z"];
const NECK = "M45 28.4 C47.5 31 52.5 31 55 28.4 L55.8 35.4 L44.2 35.4 Z";
const CAP = "M44 36.6 C40 38.6 32 38.2 28.6 42 C27.6 43.3 27.2 44.6 27 46 C29.2 42.6 32.4 42.8 34.6 45.2 C37 42.2 41 40.2 46.2 39.4 L45.6 36.6 Z";

/** Areas across the middle, and the cap of the shoulder that belongs to the front's sides. */
const FRONT = [
  ["skull_forehead", "M39.4 15 C38.6 -1.4 61.4 -1.4 60.6 15 Z"],
  ["face", "M39.4 16.2 L60.6 16.2 C60.6 23.4 55.2 30 50 30 C44.8 30 39.4 23.4 39.4 16.2 Z"],
  ["neck_front", NECK],
  ["chest", "M47 39.4 C41.4 40.4 37 42.6 34.8 46 L35 53 C34.8 58.6 35 62.4 35.8 66 L64.2 66 C65 62.4 65.2 58.6 65 53 L65.2 46 C63 42.6 58.6 40.4 53 39.4 Z"],
  ["abdomen", "M36 67.2 C36.6 73 36.3 78.6 35.2 85 L64.8 85 C63.7 78.6 63.4 73 64 67.2 Z"],
  PELVIS,
];
const BACK = [
  ["skull_forehead", "M39.4 15 C38.6 -1.4 61.4 -1.4 60.6 15 C60.8 22 57 28.2 50 28.2 C43 28.2 39.2 22 39.4 15 Z"],
  ["neck", "M44.6 26.6 C47.5 30 52.5 30 55.4 26.6 L55.8 35.4 L44.2 35.4 Z"],
  [
    "back_shoulders",
    "M44 36.6 C40 38.6 32 38.2 28.6 42 C27.6 43.3 27.2 44.6 27 46 C29.2 42.6 32.6 43 34.8 46 L35 53 C34.8 64 36.9 72 35.2 85 L64.8 85 C63.1 72 65.2 64 65 53 L65.2 46 C67.4 43 70.8 42.6 73 46 C72.8 44.6 72.4 43.3 71.4 42 C68 38.2 60 38.6 56 36.6 Z",
  ],
  PELVIS,
];

/** What makes a front of a front, and a back of a back; no region. */
const FEATURES = {
  front: "M45.6 18.6 h0.01 M54.4 18.6 h0.01 M46.6 24.8 C48.6 26.2 51.4 26.2 53.4 24.8 M50 70 v6",
  back: "M50 40 V82 M42.6 52 C41 57 41.4 61 44 63 M57.4 52 C59 57 58.6 61 56 63",
};

/** Every area of one figure: region, path, whether it is mirrored. */
function areas(side) {
  const limbs = [...LIMBS, ...(side === "front" ? [["back_shoulders", CAP]] : [])];
  return [...(side === "front" ? FRONT : BACK).map(([region, d]) => [region, d, false]), ...limbs.flatMap(([region, d]) => [[region, d, false], [region, d, true]])];
}

/** The worst ratio of each region of a cause. */
function worstByRegion({ lines }) {
  const worst = new Map();
  for (const { body_region: region, ratio } of lines) {
    worst.set(region, Math.max(worst.get(region) ?? 0, ratio));
  }
  return worst;
}

/** The drawing of a person with the regions that a cause hits; `mark` makes the region of one hazard stand out. */
export function bodyOutline(cause, words) {
  const worst = worstByRegion(cause);
  const most = Math.max(...worst.values());
  const { regions } = words.causes[cause.id];
  const texts = new Map(regions);
  const drawn = [];

  function area([region, d, mirrored]) {
    const ratio = worst.get(region);
    const hit = ratio !== undefined;
    const path = svg(
      "path",
      { d, class: hit ? "region hit" : "region", "data-region": region, transform: mirrored ? `translate(${WIDTH} 0) scale(-1 1)` : null, style: hit ? `--heat:${Math.max(PALEST, ratio / most).toFixed(3)}` : null },
      svg("title", {}, hit ? texts.get(region) : `${words.regions[region]}: not hit`),
    );
    drawn.push(path);
    return path;
  }

  const figure = (side, x) =>
    svg(
      "g",
      { transform: `translate(${x} 0)` },
      areas(side).map(area),
      svg("path", { class: "feature", d: FEATURES[side] }),
      svg("text", { x: WIDTH / 2, y: HEIGHT + 9 }, side),
    );
  const names = [...texts.values()];
  const items = regions.map(([region, text]) => h("li", { "data-region": region }, text));
  const element = h(
    "figure",
    { class: "body-outline", "data-test": "body-outline" },
    svg(
      "svg",
      { viewBox: `2 -2 ${2 * WIDTH - 14} ${HEIGHT + 15}`, role: "img", "aria-label": `Person, front and back. Hit: ${names.join(", ")}.` },
      figure("front", -3),
      figure("back", WIDTH - 11),
    ),
    h("ul", { class: "regions", "aria-hidden": "true" }, items),
  );
  return {
    element,
    mark(region) {
      for (const part of [...drawn, ...items]) {
        part.classList.toggle("selected", part.dataset.region === region);
      }
    },
  };
}
