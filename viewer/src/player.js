// The clock of a replay: the frame that is shown, and playing on from it. It stops at the last frame.

/** A player, stopped, of nothing yet. */
export function makePlayer() {
  const listeners = [];
  let frames = 1;
  let step = 1;
  let frame = 0;
  let speed = 0.5;
  let playing = false;
  let began = null;

  const tell = () => listeners.forEach((listener) => listener({ frame, playing }));

  function tick(now) {
    if (!playing) {
      return;
    }
    began ??= { now, frame };
    const next = began.frame + Math.floor(((now - began.now) / 1000) * (speed / step));
    if (next !== frame) {
      frame = Math.min(next, frames - 1);
      playing = frame < frames - 1;
      tell();
    }
    requestAnimationFrame(tick);
  }

  const player = {
    get frame() {
      return frame;
    },
    get playing() {
      return playing;
    },
    /** Another replay, shown at this frame. */
    load(count, seconds, at) {
      [frames, step] = [count, seconds];
      player.seek(at);
    },
    /** Shows a frame and stays there. */
    seek(to) {
      frame = Math.max(0, Math.min(frames - 1, Math.round(to)));
      playing = false;
      tell();
    },
    pause() {
      playing = false;
      tell();
    },
    /** Plays or pauses; from the last frame it begins anew. */
    toggle() {
      playing = !playing;
      began = null;
      if (playing) {
        frame = frame >= frames - 1 ? 0 : frame;
        requestAnimationFrame(tick);
      }
      tell();
    },
    setSpeed(value) {
      speed = value;
      began = null;
    },
    follow: (listener) => listeners.push(listener),
  };
  return player;
}
