#!/usr/bin/env node
// usage: experiments/scripts/view_glb.mjs MODEL.glb PICTURE.png
// Opens a binary glTF as any viewer of the web would, by three.js in a headless Chromium, writes what it
// shows and prints what it has found, one JSON object: meshes, triangles, images, whether there are
// texture coordinates, the share of the picture that is not background. Exit status: 0 the model is
// shown, 1 it is not, 2 bad usage, 77 Chromium or three.js is missing. three.js is the folder that
// CIRQUE_THREE names (that of the npm package "three"), else it is fetched into a temporary folder.
import { spawn, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join, normalize } from "node:path";

const kWaitMs = 60000, kShown = 0, kNotShown = 1, kMisused = 2, kMissing = 77;
const [model, picture] = process.argv.slice(2);
if (!picture) {
  console.error("usage: experiments/scripts/view_glb.mjs MODEL.glb PICTURE.png");
  process.exit(kMisused);
}
const folder = mkdtempSync(join(tmpdir(), "view_glb-"));
let browser = null;

function finish(status, message) {
  if (message) console.error(`view_glb: ${message}`);
  if (browser) browser.kill();
  // The browser still writes into its folder for a moment.
  setTimeout(() => {
    rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
    process.exit(status);
  }, 300);
}

function findChromium() {
  return ["chromium", "chromium-browser", "google-chrome"].find(
    (name) => spawnSync(name, ["--version"], { stdio: "ignore" }).status === 0);
}

function findThree() {
  if (process.env.CIRQUE_THREE) return process.env.CIRQUE_THREE;
  const fetched = spawnSync("npm", ["install", "--no-audit", "--no-fund", "--prefix", folder, "three"],
                            { stdio: "ignore" });
  return fetched.status === 0 ? join(folder, "node_modules/three") : "";
}

const kPage = `<!DOCTYPE html><meta charset="utf-8"><link rel="icon" href="data:,">
<style>body { margin: 0 }</style>
<script type="importmap">{"imports": {"three": "/three/build/three.module.js"}}</script>
<script type="module">
import * as THREE from "three";
import { GLTFLoader } from "/three/examples/jsm/loaders/GLTFLoader.js";
const report = (result) => fetch("/result", { method: "POST", body: JSON.stringify(result) });
try {
  const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  renderer.setSize(1000, 800);
  document.body.append(renderer.domElement);
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0xffffff);
  const { scene: model } = await new GLTFLoader().loadAsync("/model.glb");
  scene.add(model, new THREE.HemisphereLight(0xffffff, 0x8890a0, 2.2));
  const sun = new THREE.DirectionalLight(0xffffff, 1.6);
  sun.position.set(1, 2, 3);
  scene.add(sun);
  const found = { meshes: 0, triangles: 0, images: 0, texture_coordinates: true };
  model.traverse((part) => {
    if (!part.isMesh) return;
    const { index, attributes } = part.geometry;
    found.meshes += 1;
    found.triangles += (index ? index.count : attributes.position.count) / 3;
    found.images += part.material.map ? 1 : 0;
    found.texture_coordinates &&= Boolean(attributes.uv);
  });
  const box = new THREE.Box3().setFromObject(model);
  const middle = box.getCenter(new THREE.Vector3()), radius = box.getSize(new THREE.Vector3()).length() / 2;
  const camera = new THREE.PerspectiveCamera(35, 1000 / 800, radius / 100, radius * 20);
  camera.position.copy(middle).add(new THREE.Vector3(0.45, 0.35, 1).normalize().multiplyScalar(3.6 * radius));
  camera.lookAt(middle);
  renderer.render(scene, camera);
  const gl = renderer.getContext(), pixels = new Uint8Array(4 * 1000 * 800);
  gl.readPixels(0, 0, 1000, 800, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let drawn = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    if (pixels[i] !== 255 || pixels[i + 1] !== 255 || pixels[i + 2] !== 255) ++drawn;
  }
  found.share_drawn = drawn / (1000 * 800);
  await report({ found, picture: renderer.domElement.toDataURL("image/png").split(",")[1] });
} catch (error) {
  await report({ error: String(error) });
}
</script>`;

function conclude(result) {
  if (result.error) return finish(kNotShown, result.error);
  writeFileSync(picture, Buffer.from(result.picture, "base64"));
  console.log(JSON.stringify(result.found));
  return finish(result.found.share_drawn > 0.001 ? kShown : kNotShown);
}

function serve(three) {
  const send = (response, type, body) => {
    response.writeHead(200, { "Content-Type": type });
    response.end(body);
  };
  return createServer((request, response) => {
    const path = normalize(new URL(request.url, "http://localhost").pathname);
    const file = join(three, path.replace(/^\/three\//, ""));
    if (path === "/") send(response, "text/html", kPage);
    else if (path === "/model.glb") send(response, "model/gltf-binary", readFileSync(model));
    else if (path.startsWith("/three/") && existsSync(file)) send(response, "text/javascript", readFileSync(file));
    else if (path === "/result") {
      const pieces = [];
      request.on("data", (piece) => pieces.push(piece));
      request.on("end", () => {
        send(response, "text/plain", "");
        conclude(JSON.parse(Buffer.concat(pieces).toString()));
      });
    } else {
      response.writeHead(404);
      response.end();
    }
  });
}

function main() {
  if (!existsSync(model)) return finish(kMisused, `${model}: no such file`);
  const chromium = findChromium();
  if (!chromium) return finish(kMissing, "there is no Chromium");
  const three = findThree();
  if (!existsSync(join(three, "build/three.module.js"))) return finish(kMissing, "there is no three.js");
  const server = serve(three);
  server.listen(0, "127.0.0.1", () => {
    browser = spawn(chromium, [
      "--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic",
      "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
      `--user-data-dir=${join(folder, "profile")}`, "--remote-debugging-port=0",
      `http://127.0.0.1:${server.address().port}/`], { stdio: "ignore" });
  });
  setTimeout(() => finish(kNotShown, `the browser has not answered within ${kWaitMs / 1000} s`), kWaitMs);
}
main();
