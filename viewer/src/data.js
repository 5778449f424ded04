// The data of the page: read once, replays unpacked at once and decoded when they are first looked at.

/** The form of the data that is read. */
const FORMAT = 3;

/** What a base64 text stands for. */
const bytesOf = (base64) => Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));

/** Little-endian float32 numbers from base64. */
function floats(base64) {
  const bytes = bytesOf(base64);
  const view = new DataView(bytes.buffer);
  return Float32Array.from({ length: bytes.length / 4 }, (_, index) => view.getFloat32(4 * index, true));
}

/** A list that is JSON, gzip and base64: so that fifty replays can be mailed. */
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
    arms: floats(replay.arms),
    ...(replay.moved ? { moved: replay.moved.map((item) => ({ ...item, centre_m: floats(item.centre_m) })) } : {}),
    ...(replay.beside ? { beside: floats(replay.beside), beside_arms: floats(replay.beside_arms) } : {}),
  };
  for (const key of ["time_s", "distance_m", "speed_m_s", "force_ratio"]) {
    decoded[key] = floats(replay[key]);
  }
  return decoded;
}

/** Reads the data of the page. */
export async function readData() {
  const data = JSON.parse(document.getElementById("data").textContent);
  if (data.format !== FORMAT) {
    throw new Error(`data of format ${data.format}, but this viewer reads format ${FORMAT}`);
  }
  const replays = await unpacked(data.replays);
  data.cell.looks = data.cell.looks ? await unpacked(data.cell.looks) : [];
  const raw = new Map(replays.map((replay) => [replay.id, replay]));
  const decoded = new Map();
  const hazards = new Map(data.scan.hazards.map((hazard) => [hazard.id, hazard]));
  const causes = data.scan.causes ?? [];
  const byId = new Map(causes.map((cause, index) => [cause.id, { ...cause, number: index + 1 }]));
  const causeOf = new Map([...byId.values()].flatMap((cause) => cause.hazards.map((id) => [id, cause])));
  const without = data.scan.hazards.filter(({ id }) => !causeOf.has(id));
  if (without.length > 0) {
    // Cards show causes only: a hazard in none of them would go unseen.
    throw new Error(`${without[0].id} is in no cause`);
  }
  return {
    ...data,
    replays,
    /** Causes, worst first, with the numbers that cards, map and paper call them by. */
    causes: [...byId.values()],
    cause: (id) => byId.get(id),
    causeOf: (id) => causeOf.get(id),
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
