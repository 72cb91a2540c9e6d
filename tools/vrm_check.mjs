#!/usr/bin/env node
// Opens a VRM with three-vrm, the reader of pixiv, without a screen: its bones, its springs, and what they do when the
// hips sway. Exit code 1 where something is wrong, 3 where three-vrm is not installed.
//
//     npm install three @pixiv/three-vrm        # anywhere; say where with NODE_MODULES
//     NODE_MODULES=.../node_modules node tools/vrm_check.mjs costume.vrm

import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const folder = path.resolve(process.env.NODE_MODULES ?? path.join(process.cwd(), "node_modules"));

// Pictures are not looked at.
globalThis.self = globalThis;
globalThis.createImageBitmap = async () => ({ width: 1, height: 1, close() {} });

let THREE, GLTFLoader, VRMLoaderPlugin;
try {
  THREE = await import(pathToFileURL(path.join(folder, "three/build/three.module.js")));
  ({ GLTFLoader } = await import(pathToFileURL(path.join(folder, "three/examples/jsm/loaders/GLTFLoader.js"))));
  ({ VRMLoaderPlugin } = await import(pathToFileURL(path.join(folder, "@pixiv/three-vrm/lib/three-vrm.module.js"))));
} catch (error) {
  console.log(`skipped: no three-vrm here (npm install three @pixiv/three-vrm, and NODE_MODULES): ${error.message}`);
  process.exit(3);
}

const failures = [];
const expect = (holds, what) => {
  if (!holds) failures.push(what);
};

for (const file of process.argv.slice(2)) {
  const loader = new GLTFLoader();
  loader.register((parser) => new VRMLoaderPlugin(parser));
  const bytes = fs.readFileSync(file);
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const gltf = await loader.parseAsync(buffer, "");
  const vrm = gltf.userData.vrm;
  expect(vrm, `${file}: three-vrm finds no VRM`);
  if (!vrm) continue;
  const bones = Object.keys(vrm.humanoid.humanBones).length;
  const joints = [...(vrm.springBoneManager?.joints ?? [])];
  const colliders = vrm.springBoneManager?.colliders.length ?? 0;
  console.log(`${file}: "${vrm.meta.name}" by ${vrm.meta.authors}, ${bones} bones, ${joints.length} spring joints, ${colliders} colliders`);
  expect(15 <= bones, `${file}: too few bones`);
  // Arms are straight out to the sides.
  vrm.scene.updateMatrixWorld(true);
  for (const side of ["left", "right"]) {
    const [upper, hand] = ["UpperArm", "Hand"].map((bone) =>
      vrm.humanoid.getRawBoneNode(side + bone).getWorldPosition(new THREE.Vector3()));
    const along = hand.sub(upper).normalize();
    expect(0.99 < Math.abs(along.x), `${file}: ${side} arm is not in the T-pose`);
  }
  if (!joints.length) continue;
  // The hips sway; tips must follow late, stay whole, and come to rest.
  const hips = vrm.humanoid.getNormalizedBoneNode("hips");
  const start = hips.position.clone();
  const tips = joints.map((joint) => joint.child).filter(Boolean);
  const places = () => tips.map((tip) => tip.getWorldPosition(new THREE.Vector3()));
  const play = (frames, sway) => {
    for (let frame = 0; frame < frames; frame++) {
      hips.position.x = start.x + sway * Math.sin((frame * 2 * Math.PI) / 60);
      vrm.update(1 / 60);
    }
  };
  play(300, 0);
  const rest = places();
  play(45, 0.08);
  const swung = places();
  const lag = Math.max(...swung.map((place, it) => Math.abs(place.x - rest[it].x - hips.position.x + start.x)));
  play(600, 0);
  const again = Math.max(...places().map((place, it) => place.distanceTo(rest[it])));
  console.log(`${file}: tips lag by ${(1000 * lag).toFixed(1)} mm at most, and are back within ${(1000 * again).toFixed(1)} mm`);
  expect(0.002 < lag, `${file}: nothing swings`);
  expect(again < 0.02, `${file}: springs do not come to rest`);
}
failures.forEach((failure) => console.log(`FAILED: ${failure}`));
process.exit(failures.length ? 1 : 0);
