// Parameters as JavaScript has them, names and numbers, into the struct of the C interface.
import { CONSTANTS, LAYOUTS, WORDS } from "./header.js";
import { AsperityError, CHUNK, numberOf, numbersOf } from "./library.js";

/**
 * Two rough surfaces. The numbers are in one consistent system of units; their names are those of `asperity_params`, and
 * those of its setters: `E1`, `nu1`, `E2`, `nu2` together stand for the moduli, `m0`, `m2`, `m4` with `nominal_area` for
 * `height_std`, `summit_radius` and `asperity_count`; `Ra` for `m0` of Gaussian heights; `summit_density` with `nominal_area` for
 * `asperity_count`; `calibration_load` with `calibration_friction_coefficient` is `calibrate`, with `calibration_friction_force`
 * it is `calibrateForce`. `calibrated` is the measurement that the slip stresses are from: it is kept, and does not change them.
 * What is left out has its default, or is asked for.
 *
 * @typedef {import("./header.js").Fields & {
 *   E1?: number, nu1?: number, E2?: number, nu2?: number,
 *   m0?: number, m2?: number, m4?: number, Ra?: number, summit_density?: number,
 *   calibration_friction_coefficient?: number,
 *   calibrated?: { calibration_load: number, calibration_friction_force: number },
 * }} Params
 */

/** Names that are set last, when the surfaces are whole. */
const MEASURED = ["calibration_load", "calibration_friction_coefficient", "calibration_friction_force"];
/** A longer text is refused [bytes]. */
const LONGEST_TEXT = 2 ** 20;
/** What is kept of a calibration. */
const KEPT = /** @type {const} */ (["calibration_load", "calibration_friction_force"]);
/** What the dimensionless groups of the paper set. */
const GROUPS = ["composite_modulus", "effective_shear_modulus", "work_of_adhesion", "adhesion_range", "burgers_vector", "height_std",
  "summit_radius", "asperity_count"];

/** Begins a struct at `library.struct`: defaults, and inputs that are unset. @param {import("./library.js").Library} library */
export const initParams = (library) => library.run("params_init", library.struct, LAYOUTS.asperity_params.size);

/**
 * Writes the struct at `library.struct`, tables of heights into the first two arrays of the block.
 * @param {import("./library.js").Library} library
 * @param {Params} params
 */
export function writeParams(library, params) {
  if (typeof params !== "object" || params === null) throw new TypeError("params: must be an object of names and numbers");
  const { table_height, table_density, calibrated, ...numbers } = params;
  initParams(library);
  const given = Object.entries(numbers).filter(([, value]) => value !== undefined);
  const set = (/** @type {[string, unknown][]} */ some) =>
    library.setValues(some.map(([name]) => name), some.map(([name, value]) => number(name, value)));
  set(given.filter(([name]) => !MEASURED.includes(name)));
  if (table_height || table_density) writeTable(library, table_height ?? [], table_density ?? [], params.height_distribution);
  // By name they would calibrate again, and surfaces that were changed since would get another strength.
  if (calibrated) for (const name of KEPT) library.write(library.struct, "asperity_params", name, number(name, calibrated[name]));
  const measured = given.filter(([name]) => MEASURED.includes(name));
  if (measured.length) set(measured);
}

/**
 * The same surfaces with slip stresses that make the friction coefficient at this load the measured one: both have one factor. The
 * pressure coefficient stays as it is. The measurement is kept as `calibrated`.
 * @param {import("./library.js").Library} library
 * @param {Params} params the surfaces of the measurement
 * @param {number} load normal load of the measurement [force], > 0
 * @param {number} frictionCoefficient measured at it [-]
 * @returns {Params}
 * @throws {AsperityError} a coefficient that no strength gives, with the numbers
 */
export const calibrate = (library, params, load, frictionCoefficient) =>
  measuredBy(library, "params_calibrate", params, { calibration_load: load, calibration_friction_coefficient: frictionCoefficient });

/**
 * As `calibrate`, from a measured friction force: for loads that are 0 or pull.
 * @param {import("./library.js").Library} library
 * @param {Params} params the surfaces of the measurement
 * @param {number} load normal load of the measurement [force]
 * @param {number} frictionForce measured at it [force]
 * @returns {Params}
 */
export const calibrateForce = (library, params, load, frictionForce) =>
  measuredBy(library, "params_calibrate_force", params, { calibration_load: load, calibration_friction_force: frictionForce });

/**
 * @param {import("./library.js").Library} library
 * @param {string} call
 * @param {Params} params
 * @param {Record<string, number>} measurement
 * @returns {Params}
 */
function measuredBy(library, call, params, measurement) {
  const surfaces = withoutPoint(params);
  const values = Object.entries(measurement).map(([name, value]) => number(name, value));
  writeParams(library, surfaces);
  library.run(call, library.struct, ...values);
  return { ...surfaces, ...only(readStruct(library), ["slip_stress_1", "slip_stress_2", "calibrated"]) };
}

/**
 * The same surfaces with a strength of the interface that was measured elsewhere, in SI units: a start, until you calibrate.
 * @param {import("./library.js").Library} library
 * @param {Params} params whose bodies are given
 * @param {string} name one of INTERFACES
 * @returns {Params}
 * @throws {AsperityError} an unknown name, with the nearest; an interface of which only a friction coefficient is known, with it
 */
export function withInterface(library, params, name) {
  if (typeof name !== "string") throw new TypeError(`interface = ${String(name)}: must be a name`);
  const surfaces = withoutPoint(params);
  const found = readText(library, `interface = ${JSON.stringify(name)}`, surfaces);
  return { ...surfaces, ...only(found, ["slip_stress_1", "slip_stress_2", "pressure_coefficient"]) };
}

/**
 * The paper's case: alpha = 0.01, beta = 1000, gamma = 0.001, b/h = 1 and nu = 0.3, in its units b = G = 1, N = 1.
 * @param {import("./library.js").Library} library
 * @returns {Params}
 */
export function paper(library) {
  initParams(library);
  library.run("params_set_dimensionless", library.struct, 0.01, 1000, 0.001, 1, 0.3);
  return only(readStruct(library), GROUPS);
}

/**
 * The surfaces that a text in TOML describes, in SI units, with materials, roughness, an interface and a measured friction as
 * docs/solvers.md lists them.
 * @param {import("./library.js").Library} library
 * @param {string} text
 * @param {Params} [params] what the text does not give
 * @returns {Params} without what neither gives
 * @throws {AsperityError} with the line and the key
 */
export function readText(library, text, params = {}) {
  if (typeof text !== "string") throw new TypeError(`text = ${String(text)}: must be a string`);
  writeParams(library, params);
  // Of a text that is too long the library must see no more than that it is.
  const bytes = new TextEncoder().encode(text).subarray(0, LONGEST_TEXT + 1);
  library.run("params_set_text", library.struct, library.bytes(bytes), bytes.length);
  return Object.fromEntries(Object.entries(readStruct(library)).filter(([, value]) => !Number.isNaN(value)));
}

/**
 * A text of which `readText` makes the same surfaces, bit for bit.
 * @param {import("./library.js").Library} library
 * @param {Params} params
 * @returns {string}
 */
export function toText(library, params) {
  writeParams(library, params);
  const text = library.written((buffer, length) => library.call("params_text", library.struct, buffer, length));
  if (!text) throw new AsperityError(library.lastError(), CONSTANTS.INVALID_PARAMETER);
  return text;
}

/** The surfaces without a measured point. @param {Params} params @returns {Params} */
function withoutPoint(params) {
  return Object.fromEntries(Object.entries(params).filter(([name]) => ![...MEASURED, "calibrated"].includes(name)));
}

/** Some of the parameters. @param {Params} params @param {string[]} names @returns {Params} */
export const only = (params, names) => Object.fromEntries(Object.entries(params).filter(([name]) => names.includes(name)));

/** The parameters that are true or false. */
const FLAGS = ["attraction", "taken_as_gaussian"];

/** A parameter as a number, words by theirs. @param {string} name @param {unknown} value */
export function number(name, value) {
  if (typeof value === "boolean" && FLAGS.includes(name)) return Number(value);
  const words = Object.hasOwn(WORDS, name) ? WORDS[name] : undefined;
  if (words && typeof value === "string") {
    if (Object.hasOwn(words, value)) return words[value];
    const known = Object.keys(words).map((word) => `"${word}"`).join(", ");
    throw new AsperityError(`${name} = "${value}": must be one of ${known}`, CONSTANTS.INVALID_PARAMETER);
  }
  return numberOf(name, value);
}

/**
 * @param {import("./library.js").Library} library
 * @param {ArrayLike<number>} heights
 * @param {ArrayLike<number>} densities
 * @param {string | undefined} distribution
 */
function writeTable(library, heights, densities, distribution) {
  const [height, density] = [numbersOf("table_height", heights), numbersOf("table_density", densities)];
  if (height.length !== density.length) {
    const message = `table_density: ${density.length} numbers for ${height.length} heights`;
    throw new AsperityError(message, CONSTANTS.INVALID_PARAMETER);
  }
  // A longer table is refused by the library, which reads no more of it than its length.
  const length = Math.min(height.length, CHUNK);
  const data = library.data();
  for (let i = 0; i < length; i++) {
    data.setFloat64(library.array(0) + 8 * i, height[i], true);
    data.setFloat64(library.array(1) + 8 * i, density[i], true);
  }
  library.write(library.struct, "asperity_params", "table_height", library.array(0));
  library.write(library.struct, "asperity_params", "table_density", library.array(1));
  library.write(library.struct, "asperity_params", "table_length", height.length);
  if (distribution === undefined)
    library.write(library.struct, "asperity_params", "height_distribution", CONSTANTS.HEIGHTS_TABULATED);
}

/**
 * The numbers of a model's struct, by name, words where they are words.
 * @param {import("./library.js").Library} library
 * @param {number} model
 * @returns {Params}
 */
export function readParams(library, model) {
  library.write(library.struct, "asperity_params", "struct_size", LAYOUTS.asperity_params.size);
  library.run("get_params", model, library.struct);
  return readStruct(library);
}

/** The struct at `library.struct`, words where they are words. @param {import("./library.js").Library} library */
export function readStruct(library) {
  const { calibration_load, calibration_friction_force, table_length, ...found } = library.read(library.struct, "asperity_params");
  if (table_length)
    for (const name of ["table_height", "table_density"]) {
      const offset = LAYOUTS.asperity_params.fields.find((field) => field.name === name)?.offset ?? 0;
      const pointer = library.data().getUint32(library.struct + offset, true);
      found[name] = new Float64Array(library.memory.buffer, pointer, table_length).slice();
    }
  if (calibration_friction_force) found.calibrated = { calibration_load, calibration_friction_force };
  for (const name of FLAGS) found[name] = found[name] !== 0;
  for (const [name, words] of Object.entries(WORDS)) found[name] = wordOf(words, found[name]);
  return found;
}

/** @param {Record<string, number>} words @param {number} value */
const wordOf = (words, value) => Object.keys(words).find((word) => words[word] === value);
