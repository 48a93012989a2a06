// The package in browsers and bundlers: the library is fetched from beside this file.
import { instantiate } from "./instantiate.js";

export * from "./instantiate.js";
const response = await fetch(new URL("./asperity.wasm", import.meta.url));
if (!response.ok) throw new Error(`asperity.wasm: the server answers ${response.status} ${response.statusText}`);
const instance = await instantiate(await response.arrayBuffer());
export const { Model, version, warningsOf, warningsText, memorySize } = instance;
export const { estimate, estimateText } = instance;
export const { readText, toText, paper, calibrate, calibrateForce, withInterface } = instance;
export const { MATERIALS, PAIRS, INTERFACES, material, pair, interfaceOf, knownOf, contact } = instance;
