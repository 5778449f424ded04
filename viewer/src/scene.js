// The three-dimensional scene of a replay. Drawn only when something changes.

import {
  Color,
  DirectionalLight,
  HemisphereLight,
  LineBasicMaterial,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  PerspectiveCamera,
  Raycaster,
  RingGeometry,
  Scene,
  SphereGeometry,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { viewpoint } from "./camera.js";
import { Axes, grid as floorGrid, ground, pedestals, robotBases } from "./floor.js";
import { hittingLink, linkAt, path } from "./instant.js";
import { namesFor } from "./names.js";
import { Person, PERSON } from "./person.js";
import { Capsule, Hull, obstacle, ribbon, Zone } from "./shapes.js";
import { subjectOf } from "./subject.js";

/** Colours that the legend names too. */
export const COLOURS = {
  robot: "#7894b4",
  hitting: "#e4572e",
  person: PERSON.shirt,
  touched: PERSON.touched,
  contact: "#ffffff",
  path: "#2a9d8f",
  mat: "#d9a400",
  field: "#3b82f6",
  curtain: "#16a34a",
  door: "#0d9488",
  post: "#9333ea",
  button: "#db2777",
  obstacle: "#8b93a0",
};

const THEMES = {
  light: { sky: "#eef1f5", grid: "#b9c1cc", axis: "#b9c1cc", mark: "#4d5866" },
  dark: { sky: "#1b2027", grid: "#3a434f", axis: "#3a434f", mark: "#a3afbd" },
};

const dark = matchMedia("(prefers-color-scheme: dark)");

const solid = (color) => new MeshLambertMaterial({ color });
const clear = (color) => new MeshLambertMaterial({ color, transparent: true, opacity: 0.2, depthWrite: false });
const MATERIALS = {
  robot: solid(COLOURS.robot),
  hitting: solid(COLOURS.hitting),
  robotShape: clear(COLOURS.robot),
  hittingShape: clear(COLOURS.hitting),
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

/** Of a link that looks like more than its shape: where both are, and whether one sees through the shape. */
function dressed({ mesh }) {
  const place = (object) => [...object.getWorldPosition(new Vector3())];
  return { at: place(mesh), shape: place(mesh.parent), clear: mesh.parent.material.transparent && !mesh.material.transparent };
}

/** Makes the scene in a canvas; throws where there is no WebGL. */
export function makeScene(canvas, cell, labels, tellName) {
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

  const mark = contactMark();
  const axes = new Axes();
  const columns = pedestals(cell);
  named.push(...columns);
  scene.add(ground(), axes, mark, ...columns);
  const obstacles = cell.obstacles.map((item) => name(obstacle(item, MATERIALS.obstacle, MATERIALS.edge), item.name));
  scene.add(...obstacles);
  const zones = cell.zones.map((item) => name(new Zone(item, COLOURS[item.kind] ?? COLOURS.obstacle), item.title));
  const links = cell.links.map((link) => {
    const { radius_m: radius, points_m: points, triangles } = link;
    const shape = link.shape === "capsule" ? new Capsule(radius, MATERIALS.robot) : new Hull(points, triangles, MATERIALS.robot);
    return name(shape, cell.links.some((other) => other.robot !== link.robot) ? `${link.robot}/${link.name}` : link.name);
  });
  // What links look like, in their shapes: those are what is hit, and stay in the picture.
  const looks = cell.looks.map(({ link, points_m: points, triangles }) => {
    const mesh = new Hull(points, triangles, MATERIALS.robot);
    links[link].add(mesh);
    links[link].castShadow = false;
    return { link, mesh };
  });
  const person = new Person(cell, name);
  const other = new Person(cell, (shape) => name(shape, "the other person"));
  scene.add(...zones, ...links, person, other);

  let grid = null;
  let replay = null;
  let way = null;
  let hitting = 0;
  let bases = null;
  let subject = null;
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
        labels.place({ camera, width: canvas.clientWidth, height: canvas.clientHeight, free: replay ? [replay.contact_m, ...person.spots(frame)] : [] });
      });
    }
  }

  function theme() {
    const colours = dark.matches ? THEMES.dark : THEMES.light;
    scene.background = new Color(colours.sky);
    axes.colour = colours.mark;
    if (grid) {
      scene.remove(grid);
      grid.dispose();
    }
    grid = floorGrid(colours);
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

  function look(preset) {
    view = preset;
    resize();
    aim();
  }

  /** Puts the camera where the view wants it. */
  function aim() {
    const camAt = viewpoint(view, { ...subject, head: person.eye(frame) }, camera);
    camera.position.copy(camAt.position);
    controls.target.copy(camAt.target);
    controls.update();
    person.headless = view === "eye";
    if (view !== "eye") {
      const marks = axes.fit(subject.bounds, camera.position);
      labels.set(namesFor({ replay, cell, hazard: person.hazard, hitting, marks, colours: COLOURS, frame: () => frame }));
    }
    draw();
  }

  const pointer = new Vector2();
  const raycaster = new Raycaster();
  function point(event) {
    const { left, top, width, height } = canvas.getBoundingClientRect();
    pointer.set((2 * (event.clientX - left)) / width - 1, 1 - (2 * (event.clientY - top)) / height);
    raycaster.setFromCamera(pointer, camera);
    const hits = raycaster.intersectObjects(named.filter((object) => object.visible), true);
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
    // From now on the reader says where the camera stands.
    view = "free";
    person.headless = false;
  });
  canvas.addEventListener("pointermove", (event) => event.buttons === 0 && point(event));
  canvas.addEventListener("pointerleave", () => tellName(""));
  dark.addEventListener("change", theme);
  new ResizeObserver(() => {
    resize();
    if (subject && view !== "free") {
      aim();
    }
  }).observe(canvas);
  resize();
  theme();

  return {
    /** Puts another replay into the scene. */
    load(next, hazard) {
      replay = next;
      if (way) {
        scene.remove(way);
        way.geometry.dispose();
      }
      hitting = hittingLink(replay, cell, hazard);
      const of = (index) => (index === hitting ? "hitting" : "robot");
      links.forEach((shape, index) => (shape.material = MATERIALS[of(index)]));
      for (const { link, mesh } of looks) {
        mesh.material = MATERIALS[of(link)];
        links[link].material = MATERIALS[`${of(link)}Shape`];
      }
      person.load(replay, hazard);
      other.loadOther(replay, hazard);
      way = ribbon(path(replay, cell), 0.03, MATERIALS.path);
      scene.add(way);
      mark.position.set(...replay.contact_m);
      if (bases === null) {
        bases = robotBases(cell, replay);
        bases.forEach((base) => scene.add(base));
        named.push(...bases);
      }
      subject = subjectOf(replay, cell, hazard);
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
      person.place(frame);
      if (other.visible) {
        other.place(frame);
      }
      // Doors that stand open are not there.
      const worked = (person.hazard.worked ?? []).filter(({ at_s: at }) => Math.round(at / replay.step) <= frame);
      obstacles.forEach((shape, index) => {
        const control = cell.obstacles[index].opened_by;
        shape.visible = control === undefined || worked.filter((item) => item.name === control).length % 2 === 0;
      });
      for (const { obstacle: index, there, centre_m: centres } of replay.moved ?? []) {
        obstacles[index].visible = there[frame] === "1";
        obstacles[index].position.fromArray(centres, 3 * frame);
      }
      const touching = frame >= replay.contact_frame;
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
    draw,
    /** What is drawn, for tests: of the person, how many pedestals, how much of what must be seen is outside of the picture. */
    get drawn() {
      camera.updateMatrixWorld();
      const outside = subject.points.filter(({ p }) => {
        const { x, y, z } = p.clone().project(camera);
        return Math.abs(x) > 1 || Math.abs(y) > 1 || z > 1;
      }).length;
      return { ...person.drawn, pedestals: columns.length, outside, looks: looks.map(dressed) };
    },
  };
}
