// The data of the page: read once, replays unpacked at once and decoded when they are first looked at.

/** What a base64 text stands for. */
const bytesOf = (base64) => Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));

/** Little-endian float32 numbers from base64. */
function floats(base64) {
  const bytes = bytesOf(base64);
  const view = new DataView(bytes.buffer);
  return Float32Array.from({ length: bytes.length / 4 }, (_, index) => view.getFloat32(4 * index, true));
}

/** The list of replays, which is JSON, gzip and base64: so that fifty of them can be mailed. */
async function unpacked(base64) {
  const stream = new Blob([bytesOf(base64)]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).json();
}

function decode(replay, cell) {
  const decoded = {
    ...replay,
    step: cell.step_s,
    links: floats(replay.links),
    body: floats(replay.body),
  };
  for (const key of ["time_s", "distance_m", "speed_m_s", "force_ratio"]) {
    decoded[key] = floats(replay[key]);
  }
  return decoded;
}

/** Reads the data of the page. */
export async function readData() {
  const data = JSON.parse(document.getElementById("data").textContent);
  if (data.format !== 1) {
    throw new Error(`data of format ${data.format}, but this viewer reads format 1`);
  }
  const replays = await unpacked(data.replays);
  const raw = new Map(replays.map((replay) => [replay.id, replay]));
  const decoded = new Map();
  const hazards = new Map(data.scan.hazards.map((hazard) => [hazard.id, hazard]));
  return {
    ...data,
    replays,
    hazard: (id) => hazards.get(id),
    /** The replay of a hazard, or undefined if the report carries none. */
    replay(id) {
      if (!decoded.has(id) && raw.has(id)) {
        decoded.set(id, decode(raw.get(id), data.cell));
      }
      return decoded.get(id);
    },
    topView: (id) => raw.get(id)?.top_view,
  };
}
