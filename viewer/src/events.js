// What happens in a replay, in order: controls are worked, sensors begin to report, contact, the link comes to rest. Marked on every
// time axis.

/** Below this speed a link counts as standing still, m/s. */
const RESTS_BELOW = 0.01;

/** Frame at which the speed falls below that of rest, after `from` if it does so there, else for the first time; -1 if never. */
function restFrame(speeds, from) {
  const falls = [...speeds.keys()].filter((frame) => frame > 0 && speeds[frame] < RESTS_BELOW && speeds[frame - 1] >= RESTS_BELOW);
  return falls.find((frame) => frame >= from) ?? falls[0] ?? -1;
}

/** The events of a replay: frame, kind (`press`, `sensor`, `contact`, `rest`) and what it is in words. */
export function eventsOf(replay, hazard, words) {
  const said = words.hazards[hazard.id];
  const reports = replay.sensors
    .map(({ name, detected }) => ({ frame: detected.indexOf("1"), kind: "sensor", text: `${name} ${words.people.begins}` }))
    .filter(({ frame }) => frame >= 0);
  const from = reports.length > 0 ? Math.min(...reports.map(({ frame }) => frame)) : 0;
  const rest = restFrame(replay.speed_m_s, from);
  const presses = (hazard.worked ?? []).map(({ at_s: at }, index) => ({ frame: Math.round(at / replay.step), kind: "press", text: said.worked[index] }));
  return [
    ...presses,
    ...reports,
    { frame: replay.contact_frame, kind: "contact", text: said.event },
    ...(rest >= 0 ? [{ frame: rest, kind: "rest", text: said.rests }] : []),
  ].sort((a, b) => a.frame - b.frame);
}
