// The package in Node: the library lies beside this file.
import { readFile } from "node:fs/promises";
import { instantiate } from "./instantiate.js";

export * from "./instantiate.js";
const instance = await instantiate(
  await readFile(new URL("./asperity.wasm", import.meta.url)),
);
export const { Model, version, warningsOf, warningsText, memorySize } = instance;
export const { estimate, estimateText } = instance;
export const { readText, toText, paper, calibrate, calibrateForce, withInterface } = instance;
export const { MATERIALS, PAIRS, INTERFACES, material, pair, interfaceOf, knownOf, contact } = instance;
