// The viewer of a page that quarry writes: a mesh that turns, its quality, its features. All that it shows lies
// in the page itself.
import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, LineBasicMaterial,
  LineSegments, Mesh, MeshLambertMaterial, OrthographicCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer,
} from "three";
import { TrackballControls } from "three/examples/jsm/controls/TrackballControls.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";

const NONE = 0xffffffff;
const data = JSON.parse(document.getElementById("mesh").textContent);

function bytes(text) {
  const raw = atob(text);
  const out = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) out[i] = raw.charCodeAt(i);
  return out.buffer;
}

const points = new Float32Array(bytes(data.points));
const faces = new Uint32Array(bytes(data.faces));  // four corners a face, the last one NONE of a triangle
const quality = new Float32Array(bytes(data.quality));
const features = new Uint32Array(bytes(data.features));
const colours = { quality: new Uint8Array(bytes(data.quality_colours)), region: new Uint8Array(bytes(data.region_colours)) };
const faceCount = faces.length / 4;

// Every face has corners of its own, so that it has a colour of its own.
function makeFaces() {
  const firstTriangle = new Uint32Array(faceCount + 1);
  for (let f = 0; f < faceCount; ++f) firstTriangle[f + 1] = firstTriangle[f] + (faces[4 * f + 3] === NONE ? 1 : 2);
  const triangles = firstTriangle[faceCount];
  const position = new Float32Array(9 * triangles);
  const faceOfTriangle = new Uint32Array(triangles);
  for (let f = 0; f < faceCount; ++f) {
    for (let t = firstTriangle[f]; t < firstTriangle[f + 1]; ++t) {
      const k = t - firstTriangle[f];
      [0, k + 1, k + 2].forEach((corner, i) => {
        const v = faces[4 * f + corner];
        position.set(points.subarray(3 * v, 3 * v + 3), 9 * t + 3 * i);
      });
      faceOfTriangle[t] = f;
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(position, 3));
  geometry.setAttribute("color", new BufferAttribute(new Uint8Array(9 * triangles), 3, true));
  geometry.computeVertexNormals();
  return { geometry, faceOfTriangle };
}

// Sides of elements: one of the two of each inner edge runs upwards. Rims are among the features.
function makeEdges() {
  const ends = [];
  for (let f = 0; f < faceCount; ++f) {
    const n = faces[4 * f + 3] === NONE ? 3 : 4;
    for (let k = 0; k < n; ++k) {
      const a = faces[4 * f + k], b = faces[4 * f + ((k + 1) % n)];
      if (a < b) ends.push(a, b);
    }
  }
  return ends;
}

function along(ends) {
  const position = new Float32Array(3 * ends.length);
  for (let i = 0; i < ends.length; ++i) position.set(points.subarray(3 * ends[i], 3 * ends[i] + 3), 3 * i);
  return position;
}

const canvas = document.getElementById("view");
const renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
const scene = new Scene();
scene.background = new Color(0xffffff);
const camera = new OrthographicCamera(-1, 1, 1, -1, -100, 100);
scene.add(camera, new AmbientLight(0xffffff, 1.5));
const lamp = new DirectionalLight(0xffffff, 1.7);
lamp.position.set(-0.4, 0.5, 1);
camera.add(lamp);

const { geometry, faceOfTriangle } = makeFaces();
const body = new Mesh(geometry, new MeshLambertMaterial({
  vertexColors: true, flatShading: true, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
}));
const edgeGeometry = new BufferGeometry();
edgeGeometry.setAttribute("position", new BufferAttribute(along(makeEdges()), 3));
const edges = new LineSegments(edgeGeometry, new LineBasicMaterial({ color: 0x29364a, transparent: true, opacity: 0.45 }));
const featureGeometry = new LineSegmentsGeometry();
if (features.length > 0) featureGeometry.setPositions(along(features));
const lines = new LineSegments2(featureGeometry, new LineMaterial({ color: 0x141a24, linewidth: 2 }));
if (features.length > 0) scene.add(lines);
scene.add(body, edges);

function paint(by) {
  const attribute = geometry.getAttribute("color");
  for (let t = 0; t < faceOfTriangle.length; ++t) {
    const f = faceOfTriangle[t];
    const colour = by === "plain" ? [222, 220, 212] : colours[by].subarray(3 * f, 3 * f + 3);
    for (let i = 0; i < 3; ++i) attribute.array.set(colour, 9 * t + 3 * i);
  }
  attribute.needsUpdate = true;
}

const controls = new TrackballControls(camera, canvas);
controls.noRotate = data.planar;
controls.staticMoving = true;
controls.rotateSpeed = 3;
let stale = true;
controls.addEventListener("change", () => { stale = true; });

function reset() {
  controls.reset();
  camera.zoom = 1;
  camera.position.set(...(data.planar ? [0, 0, 3] : [1.9, 1.3, 1.3]));
  camera.up.set(0, data.planar ? 1 : 0, data.planar ? 0 : 1);
  camera.lookAt(0, 0, 0);
  resize();
}

function resize() {
  const { clientWidth: w, clientHeight: h } = canvas;
  renderer.setPixelRatio(window.devicePixelRatio);
  renderer.setSize(w, h, false);
  const reach = 1.08 / Math.min(1, w / h);
  camera.left = -reach * (w / h);
  camera.right = reach * (w / h);
  camera.top = reach;
  camera.bottom = -reach;
  camera.updateProjectionMatrix();
  controls.handleResize();
  stale = true;
}

// A click tells what lies under it.
function pick(event) {
  const box = canvas.getBoundingClientRect();
  const at = new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
  const caster = new Raycaster();
  caster.setFromCamera(at, camera);
  const [hit] = caster.intersectObject(body);
  const picked = document.getElementById("picked");
  if (!hit) {
    picked.textContent = "Click on an element to see its numbers.";
    return;
  }
  const f = faceOfTriangle[hit.faceIndex];
  const place = new Vector3().copy(hit.point).multiplyScalar(data.radius).add(new Vector3(...data.center));
  const coordinates = place.toArray().slice(0, data.planar ? 2 : 3).map((x) => x.toPrecision(8)).join(", ");
  picked.textContent = `Element ${f}: scaled Jacobian ${quality[f].toFixed(4)}, at (${coordinates})`;
}

function show(name, object) {
  const box = document.getElementById(name);
  box.addEventListener("change", () => { object.visible = box.checked; stale = true; });
  object.visible = box.checked;
}

for (const radio of document.querySelectorAll("input[name=colour]")) {
  radio.addEventListener("change", () => { paint(radio.value); stale = true; });
  if (radio.checked) paint(radio.value);
}
show("edges", edges);
show("features", lines);
document.getElementById("reset").addEventListener("click", reset);
let pressed = null;
canvas.addEventListener("pointerdown", (event) => { pressed = [event.clientX, event.clientY]; });
canvas.addEventListener("click", (event) => {
  // The end of a turn is no click.
  if (pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < 4) pick(event);
});
window.addEventListener("resize", resize);

function frame() {
  controls.update();
  if (stale) {
    renderer.render(scene, camera);
    stale = false;
    document.body.dataset.drawn = "yes";
  }
  requestAnimationFrame(frame);
}
reset();
frame();
