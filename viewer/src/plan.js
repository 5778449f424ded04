// Plane geometry: outlines of turned boxes and of other points seen from above.

/** Turns a vector by a quaternion [x, y, z, w]. */
export function turned([x, y, z, w], [a, b, c]) {
  const [u, v, t] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * u + y * t - z * v, b + w * v + z * u - x * t, c + w * t + x * v - y * u];
}

/** Convex hull of points in the plane, by the monotone chain. */
export function hull(points) {
  const all = [...points].sort(([a, b], [c, d]) => a - c || b - d);
  const half = (ordered) => {
    const chain = [];
    for (const p of ordered) {
      while (chain.length > 1) {
        const [q, r] = chain.slice(-2);
        if ((r[0] - q[0]) * (p[1] - q[1]) - (r[1] - q[1]) * (p[0] - q[0]) > 0) {
          break;
        }
        chain.pop();
      }
      chain.push(p);
    }
    return chain.slice(0, -1);
  };
  return [...half(all), ...half(all.reverse())];
}

/** Outline of an obstacle from above. */
export function outline({ centre_m: centre, size_m: size, quaternion }) {
  const signs = [-0.5, 0.5];
  const corners = signs.flatMap((i) => signs.flatMap((j) => signs.map((k) => [i * size[0], j * size[1], k * size[2]])));
  return hull(corners.map((corner) => turned(quaternion, corner)).map(([x, y]) => [centre[0] + x, centre[1] + y]));
}

/** Whether a point lies in a convex outline that runs anticlockwise. */
export function inside([x, y], polygon) {
  return polygon.every(([ax, ay], index) => {
    const [bx, by] = polygon[(index + 1) % polygon.length];
    return (bx - ax) * (y - ay) - (by - ay) * (x - ax) >= 0;
  });
}
