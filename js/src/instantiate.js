// The package on WebAssembly that the caller brings: for single files, workers and hosts with their own way to load.
import { CONSTANTS } from "./header.js";
import { AsperityError, Library } from "./library.js";
import { estimate, estimateText } from "./estimate.js";
import { materialsOf } from "./materials.js";
import { Model, bitsOf, warningsOf, warningsText } from "./model.js";
import { calibrate, calibrateForce, paper, readText, toText, withInterface } from "./params.js";

/** @typedef {import("./params.js").Params} Params */
/** @typedef {import("./estimate.js").Estimate} Estimate */
/** @typedef {import("./model.js").State} State */
/** @typedef {import("./model.js").Summary} Summary */
/** @typedef {import("./model.js").Warning} Warning */
/** @typedef {import("./materials.js").Material} Material */
/** @typedef {import("./materials.js").Pair} Pair */
/** @typedef {import("./materials.js").Interface} Interface */

/**
 * One instance of the library, with a memory of its own.
 * @typedef {object} Instance
 * @property {new (params: Params | string) => Model} Model a friction law: `new Model(params)`, or of the text of a surface
 * @property {string} version of the library
 * @property {(bits: number) => Warning[]} warningsOf the `warnings` of a state, in words
 * @property {(bits: number) => string} warningsText the same as one text, a line for each warning; "no warning" for 0
 * @property {<T extends number | ArrayLike<number>>(text: string, load: T) => T extends number ? Estimate : Estimate[]} estimate
 *   friction at loads with its band, from the text of a surface alone
 * @property {(text: string, load: number | ArrayLike<number>) => string} estimateText the same for people
 * @property {(text: string, params?: Params) => Params} readText the surfaces that a text in TOML describes, in SI units
 * @property {(params: Params) => string} toText a text of which `readText` makes the same surfaces
 * @property {() => Params} paper the paper's case, in its units
 * @property {(params: Params, load: number, frictionCoefficient: number) => Params} calibrate the same surfaces with the strength
 *   of the interface from one measured friction coefficient
 * @property {(params: Params, load: number, frictionForce: number) => Params} calibrateForce the same from a measured friction
 *   force, for loads that are 0 or pull
 * @property {(params: Params, name: string) => Params} withInterface the same surfaces with the strength of one of INTERFACES, in SI
 *   units
 * @property {() => number} memorySize how much memory the instance has taken [bytes]
 */

export { AsperityError };
export { momentsOfAreal, momentsOfMap } from "./roughness.js";

/** Why a call failed; the numbers are those of the C interface. */
export const Status = Object.freeze({
  OK: CONSTANTS.OK,
  NULL_POINTER: CONSTANTS.NULL_POINTER,
  INVALID_PARAMETER: CONSTANTS.INVALID_PARAMETER,
  INVALID_LOAD: CONSTANTS.INVALID_LOAD,
  SEPARATED: CONSTANTS.SEPARATED,
  OUT_OF_RANGE: CONSTANTS.OUT_OF_RANGE,
  NOT_CONVERGED: CONSTANTS.NOT_CONVERGED,
  INTERNAL: CONSTANTS.INTERNAL,
});

/**
 * Makes an instance of the library.
 * @param {BufferSource | WebAssembly.Module} source asperity.wasm, as bytes or compiled
 * @returns {Promise<Instance & import("./materials.js").Materials>}
 */
export async function instantiate(source) {
  const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
  const library = new Library(await WebAssembly.instantiate(module, {}));
  return {
    Model: class extends Model {
      /** @param {Params | string} params */
      constructor(params) {
        super(library, params);
      }
    },
    version: library.string(library.call("version")),
    warningsOf: (bits) => warningsOf(library, bitsOf("bits", bits)),
    warningsText: (bits) => warningsText(library, bitsOf("bits", bits)),
    ...materialsOf(library),
    estimate: (text, load) => estimate(library, text, load),
    estimateText: (text, load) => estimateText(library, text, load),
    readText: (text, params) => readText(library, text, params),
    toText: (params) => toText(library, params),
    paper: () => paper(library),
    calibrate: (params, load, frictionCoefficient) => calibrate(library, params, load, frictionCoefficient),
    calibrateForce: (params, load, frictionForce) => calibrateForce(library, params, load, frictionForce),
    withInterface: (params, name) => withInterface(library, params, name),
    memorySize: () => library.memory.buffer.byteLength,
  };
}
