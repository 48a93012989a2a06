// The package on WebAssembly that the caller brings: for single files, workers and hosts with their own way to load.
import { CONSTANTS } from "./header.js";
import { AsperityError, Library } from "./library.js";
import { modelClass, warningsOf } from "./model.js";

/** @typedef {import("./params.js").Params} Params */
/** @typedef {import("./model.js").State} State */
/** @typedef {import("./model.js").Summary} Summary */
/** @typedef {import("./model.js").Sensitivities} Sensitivities */
/** @typedef {import("./model.js").Warning} Warning */
/** @typedef {InstanceType<ReturnType<typeof modelClass>>} Model */

export { AsperityError };
export { MATERIALS, PAIRS, contact } from "./materials.js";
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
  OUT_OF_MEMORY: CONSTANTS.OUT_OF_MEMORY,
  INTERNAL: CONSTANTS.INTERNAL,
});

/**
 * One instance of the library, with a memory of its own.
 * @param {BufferSource | WebAssembly.Module} source asperity.wasm, as bytes or compiled
 */
export async function instantiate(source) {
  const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
  const library = new Library(await WebAssembly.instantiate(module, {}));
  return {
    /** A friction law: `new Model(params)`. */
    Model: modelClass(library),
    /** The version of the library. */
    version: library.string(library.call("version")),
    /**
     * The `warnings` of a state, in words.
     * @param {number} bits
     */
    warningsOf: (bits) => warningsOf(library, BigInt(bits)),
    /** How much memory the instance has taken [bytes]. */
    memorySize: () => library.memory.buffer.byteLength,
  };
}
