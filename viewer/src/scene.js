// The three-dimensional scene of a replay. Drawn only when something changes.

import {
  Color,
  DirectionalLight,
  GridHelper,
  HemisphereLight,
  LineBasicMaterial,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Raycaster,
  RingGeometry,
  Scene,
  ShadowMaterial,
  SphereGeometry,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { viewpoint } from "./camera.js";
import { bodyAt, headPart, hittingLink, linkAt, linkPoints, path, touchedPart } from "./instant.js";
import { toSegment } from "./near.js";
import { Capsule, Hull, obstacle, ribbon, Zone } from "./shapes.js";

/** Colours that the legend names too. */
export const COLOURS = {
  robot: "#6f8fb3",
  hitting: "#e4572e",
  person: "#d9b08c",
  touched: "#c2185b",
  contact: "#ffffff",
  path: "#2a9d8f",
  mat: "#d9a400",
  field: "#3b82f6",
  curtain: "#16a34a",
  door: "#0d9488",
  post: "#9333ea",
  obstacle: "#8b93a0",
};

const THEMES = {
  light: { sky: "#eef1f5", grid: "#b9c1cc", axis: "#8d97a5" },
  dark: { sky: "#1b2027", grid: "#3a434f", axis: "#596574" },
};

const GRID_M = 20;
const dark = matchMedia("(prefers-color-scheme: dark)");

const solid = (color) => new MeshLambertMaterial({ color });
const MATERIALS = {
  robot: solid(COLOURS.robot),
  hitting: solid(COLOURS.hitting),
  person: solid(COLOURS.person),
  touched: solid(COLOURS.touched),
  obstacle: new MeshLambertMaterial({ color: COLOURS.obstacle, transparent: true, opacity: 0.22, depthWrite: false }),
  edge: new LineBasicMaterial({ color: COLOURS.obstacle }),
  path: new MeshBasicMaterial({ color: COLOURS.path }),
};

function lights(scene) {
  scene.add(new HemisphereLight("#ffffff", "#9aa3b0", 2.1));
  const sun = new DirectionalLight("#ffffff", 1.9);
  sun.position.set(-3, -4, 9);
  sun.castShadow = true;
  sun.shadow.mapSize.set(1024, 1024);
  Object.assign(sun.shadow.camera, { left: -5, right: 5, top: 5, bottom: -5, near: 1, far: 20 });
  scene.add(sun, sun.target);
  return sun;
}

/** The mark of the contact: seen through everything. */
function contactMark() {
  const material = new MeshBasicMaterial({ color: COLOURS.contact, depthTest: false, transparent: true });
  const ring = new MeshBasicMaterial({ color: "#000000", depthTest: false, transparent: true });
  const mark = new Mesh(new SphereGeometry(0.018, 16, 12), material);
  const outer = new Mesh(new RingGeometry(0.045, 0.058, 40), material);
  const shade = new Mesh(new RingGeometry(0.04, 0.063, 40), ring);
  [mark.renderOrder, outer.renderOrder, shade.renderOrder] = [12, 11, 10];
  mark.add(outer, shade);
  mark.materials = [material, ring];
  return mark;
}

/** Makes the scene in a canvas; throws where there is no WebGL. */
export function makeScene(canvas, cell, tellName) {
  const renderer = new WebGLRenderer({ canvas, antialias: true });
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  renderer.shadowMap.enabled = true;
  const scene = new Scene();
  const camera = new PerspectiveCamera(40, 1, 0.02, 200);
  camera.up.set(0, 0, 1);
  const controls = new OrbitControls(camera, canvas);
  const sun = lights(scene);

  const named = [];
  const name = (object, text) => {
    object.userData.name = text;
    named.push(object);
    return object;
  };

  const floor = new Mesh(new PlaneGeometry(GRID_M, GRID_M), new ShadowMaterial({ opacity: 0.18 }));
  floor.receiveShadow = true;
  floor.position.z = 0.002;
  const mark = contactMark();
  scene.add(floor, mark);
  for (const item of cell.obstacles) {
    scene.add(name(obstacle(item, MATERIALS.obstacle, MATERIALS.edge), item.name));
  }
  const zones = cell.zones.map((item) => name(new Zone(item, COLOURS[item.kind] ?? COLOURS.obstacle), `${item.kind} ${item.name}`));
  const links = cell.links.map((link) => {
    const { radius_m: radius, points_m: points, triangles } = link;
    const shape = link.shape === "capsule" ? new Capsule(radius, MATERIALS.robot) : new Hull(points, triangles, MATERIALS.robot);
    return name(shape, cell.links.some((other) => other.robot !== link.robot) ? `${link.robot}/${link.name}` : link.name);
  });
  const body = cell.body.map((part) => name(new Capsule(part.radius_m, MATERIALS.person), part.region.replaceAll("_", " ")));
  scene.add(...zones, ...links, ...body);

  let grid = null;
  let replay = null;
  let arm = [];
  let way = null;
  let subject = null;
  let head = 0;
  let frame = 0;
  let view = "overview";
  let pending = false;

  function draw() {
    if (!pending) {
      pending = true;
      requestAnimationFrame(() => {
        pending = false;
        mark.children.forEach((ring) => ring.quaternion.copy(camera.quaternion));
        // About as large on the picture from near and far.
        mark.scale.setScalar(Math.max(0.25, Math.min(2, camera.position.distanceTo(mark.position) / 3.5)));
        renderer.render(scene, camera);
      });
    }
  }

  function theme() {
    const { sky, grid: line, axis } = dark.matches ? THEMES.dark : THEMES.light;
    scene.background = new Color(sky);
    if (grid) {
      scene.remove(grid);
      grid.dispose();
    }
    grid = new GridHelper(GRID_M, GRID_M, axis, line);
    grid.rotation.x = Math.PI / 2;
    scene.add(grid);
    draw();
  }

  function resize() {
    const { clientWidth: width, clientHeight: height } = canvas;
    if (width > 0 && height > 0) {
      renderer.setSize(width, height, false);
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
      draw();
    }
  }

  /** What the camera has to show of a replay: person and robot at the contact. */
  function subjectOf(hazard) {
    const at = replay.contact_frame;
    const capsules = [];
    const points = [];
    const take = (list, radius) => list.forEach((p) => points.push({ p: new Vector3(...p), radius }));
    cell.body.forEach((_, part) => {
      const capsule = bodyAt(replay, cell, at, part);
      capsules.push(capsule);
      take([capsule.a, capsule.b], capsule.radius);
    });
    const robot = [0, 0];
    cell.links.forEach((link, index) => {
      const reach = linkPoints(replay, cell, at, index);
      const pose = linkAt(replay, cell, at, index);
      if (!pose.position) {
        capsules.push(pose);
      }
      take(reach, link.radius_m ?? 0);
      robot.forEach((_, axis) => (robot[axis] += reach[0][axis] / cell.links.length));
    });
    take([replay.contact_m], 0.1);
    take(replay.arm?.points_m ?? [], 0.1);
    // The touching shapes themselves always lie at the contact; they do not count as hiding it.
    const hiding = capsules.filter(({ a, b, radius }) => toSegment(replay.contact_m, a, b) > radius + 0.03);
    return { points, capsules: hiding, contact: replay.contact_m, person: hazard.person_xy_m, robot };
  }

  function look(preset) {
    view = preset;
    resize();
    const camAt = viewpoint(view, { ...subject, head: bodyAt(replay, cell, frame, head).a }, camera);
    camera.position.copy(camAt.position);
    controls.target.copy(camAt.target);
    controls.update();
    headVisible();
    draw();
  }

  /** From the person's own eyes the head would hide everything. */
  function headVisible() {
    body[head].visible = view !== "eye";
  }

  const pointer = new Vector2();
  const raycaster = new Raycaster();
  function point(event) {
    const { left, top, width, height } = canvas.getBoundingClientRect();
    pointer.set((2 * (event.clientX - left)) / width - 1, 1 - (2 * (event.clientY - top)) / height);
    raycaster.setFromCamera(pointer, camera);
    const hits = raycaster.intersectObjects([...named, ...arm], true);
    // What is solid is meant first, then what one sees through.
    const hit = hits.find(({ object }) => object.material && !object.material.transparent && object.isMesh) ?? hits.find(({ object }) => object.isMesh);
    let object = hit?.object;
    while (object && !object.userData.name) {
      object = object.parent;
    }
    tellName(object?.userData.name ?? "");
  }

  controls.addEventListener("change", draw);
  controls.addEventListener("start", () => {
    if (view === "eye") {
      view = "free";
      headVisible();
    }
  });
  canvas.addEventListener("pointermove", (event) => event.buttons === 0 && point(event));
  canvas.addEventListener("pointerleave", () => tellName(""));
  dark.addEventListener("change", theme);
  new ResizeObserver(resize).observe(canvas);
  resize();
  theme();

  return {
    /** Puts another replay into the scene. */
    load(next, hazard) {
      replay = next;
      scene.remove(...arm);
      if (way) {
        scene.remove(way);
        way.geometry.dispose();
      }
      const hitting = hittingLink(replay, cell, hazard);
      links.forEach((shape, index) => (shape.material = index === hitting ? MATERIALS.hitting : MATERIALS.robot));
      const touched = replay.arm ? -1 : touchedPart(replay, cell, hazard);
      body.forEach((shape, part) => (shape.material = part === touched ? MATERIALS.touched : MATERIALS.person));
      arm = [];
      if (replay.arm) {
        const { points_m: points, radius_m: radius, side } = replay.arm;
        arm = points.slice(1).map((to, index) => {
          const part = new Capsule(radius, MATERIALS.touched);
          part.userData.name = `${side} ${index === 0 ? "upper arm" : "lower arm and hand"}`;
          part.place(points[index], to);
          return part;
        });
        scene.add(...arm);
      }
      way = ribbon(path(replay, cell), 0.03, MATERIALS.path);
      scene.add(way);
      mark.position.set(...replay.contact_m);
      head = headPart(replay, cell);
      subject = subjectOf(hazard);
      sun.position.set(replay.contact_m[0] - 3, replay.contact_m[1] - 4, 9);
      sun.target.position.set(replay.contact_m[0], replay.contact_m[1], 0);
    },
    /** Shows a frame. */
    show(to) {
      frame = to;
      links.forEach((shape, index) => {
        const pose = linkAt(replay, cell, frame, index);
        pose.position ? shape.place(pose.position, pose.quaternion) : shape.place(pose.a, pose.b);
      });
      body.forEach((shape, part) => {
        const { a, b } = bodyAt(replay, cell, frame, part);
        shape.place(a, b);
      });
      const touching = frame >= replay.contact_frame;
      arm.forEach((part) => (part.visible = touching));
      mark.materials.forEach((material) => (material.opacity = touching ? 1 : 0.35));
      zones.forEach((zone, index) => {
        const sensor = replay.sensors.find((item) => item.name === cell.zones[index].name);
        zone.lit = sensor?.detected[frame] === "1";
      });
      if (view === "eye") {
        look("eye");
      }
      draw();
    },
    look,
  };
}
