// Which of the capsules a point lies nearest to, and what stands between two points.

/** Distance from `p` to the segment from `a` to `b`. */
export function toSegment(p, a, b) {
  const along = [0, 1, 2].map((i) => b[i] - a[i]);
  const length = along.reduce((sum, d) => sum + d * d, 0);
  const raw = length > 0 ? along.reduce((sum, d, i) => sum + d * (p[i] - a[i]), 0) / length : 0;
  const t = Math.max(0, Math.min(1, raw));
  return Math.hypot(...[0, 1, 2].map((i) => p[i] - a[i] - t * along[i]));
}

/** Whether the way from `from` to `to` passes within the capsule, told at a few points of its length. */
export function between(from, to, { a, b, radius }) {
  const STEPS = 24;
  for (let step = 0; step < STEPS; step++) {
    const t = step / STEPS;
    if (toSegment(from.map((value, i) => value + t * (to[i] - value)), a, b) < radius) {
      return true;
    }
  }
  return false;
}
