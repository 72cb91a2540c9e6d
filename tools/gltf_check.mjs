#!/usr/bin/env node
// Holds GLB and VRM files against the Khronos validator: exit code 1 for any error or warning, 3 where the validator
// is not installed.
//
//     npm install gltf-validator        # anywhere; say where with NODE_MODULES
//     NODE_MODULES=.../node_modules node tools/gltf_check.mjs dance.glb ...
//
// What it does not know of is told: extensions of others, such as VRMC_vrm.

import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";

const folder = process.env.NODE_MODULES ?? path.join(process.cwd(), "node_modules");
let validator;
try {
  validator = createRequire(path.join(path.resolve(folder), "here.js"))("gltf-validator");
} catch {
  console.log("skipped: no gltf-validator here (npm install gltf-validator, and NODE_MODULES)");
  process.exit(3);
}

let findings = 0;
for (const file of process.argv.slice(2)) {
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), { maxIssues: 1000 });
  const { numErrors, numWarnings, numInfos, messages } = report.issues;
  const counted = {};
  for (const message of messages) {
    if (message.severity < 2) console.log(`  ${message.code} ${message.pointer}: ${message.message}`);
    counted[message.code] = (counted[message.code] ?? 0) + 1;
  }
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos ${JSON.stringify(counted)}`);
  findings += numErrors + numWarnings;
}
process.exit(findings ? 1 : 0);
