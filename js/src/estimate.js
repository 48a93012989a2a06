// Friction from the text of a surface in one call, with its band.
import { CONSTANTS, LAYOUTS } from "./header.js";
import { AsperityError, numbersOf } from "./library.js";

const STRUCT = "asperity_estimate";
/** @type {Record<number, Estimate["strength_source"]>} */
const SOURCES = {
  [CONSTANTS.STRENGTH_DEFAULT]: "default",
  [CONSTANTS.STRENGTH_TABLE]: "table",
  [CONSTANTS.STRENGTH_GIVEN]: "given",
  [CONSTANTS.STRENGTH_MEASURED]: "measured",
};
/** @type {Record<number, Estimate["specimen"]>} */
const SPECIMENS = {
  [CONSTANTS.SPECIMEN_MANY_CONTACTS]: "many contacts",
  [CONSTANTS.SPECIMEN_ANY]: "any",
  [CONSTANTS.SPECIMEN_MEASURED]: "measured",
};

/**
 * Friction at one load, with its band; if few summits touch, of one specimen. SI units.
 * @typedef {object} Estimate
 * @property {number} load [N]
 * @property {number} friction_coefficient F/P; infinite from the pull-off load to 0, 0 below
 * @property {number} low lower end of the band
 * @property {number} high upper end
 * @property {number} friction_force F [N]
 * @property {number} friction_force_low lower end of its band
 * @property {number} friction_force_high upper end
 * @property {number} curve_coefficient F/P of a model of what `readText` makes of the text
 * @property {number} constant_odds how probable it is that F/P is within 10 % of the measured mean
 * @property {number} contacts expected number of summits in contact; NaN if loads are pressures
 * @property {number} another_force F of another specimen than the one that was measured [N]
 * @property {number} another_force_low lower end of its band
 * @property {number} another_force_high upper end
 * @property {number} strength_share share of the variance of ln(F/P) from the strength of the interface
 * @property {number} size_share share from how the strength depends on the size of a contact
 * @property {number} pressure_share share from how the strength grows with pressure
 * @property {number} adhesion_share share from adhesion
 * @property {number} hardness_share share from the hardness, and from whether asperities yield
 * @property {number} slope_share share from the slope and the height of the surface
 * @property {number} measurement_share share from the errors of the measured points
 * @property {number} model_share share from how real interfaces leave the law between loads
 * @property {number} specimen_share share from which summits a specimen happens to have
 * @property {number} tangential_stiffness K_t [N/m]
 * @property {number} tangential_stiffness_low
 * @property {number} tangential_stiffness_high
 * @property {number} normal_stiffness -d(load)/d(gap) [N/m]
 * @property {number} normal_stiffness_low
 * @property {number} normal_stiffness_high
 * @property {number} contact_radius_sum sum of the radii of all contacts [m]: the conductance is 2 k times it
 * @property {number} contact_radius_sum_low
 * @property {number} contact_radius_sum_high
 * @property {number} unloading_stiffness -d(load)/d(gap) when the load begins to fall [N/m]
 * @property {number} unloading_stiffness_low
 * @property {number} unloading_stiffness_high
 * @property {number} gap between the mean planes [m]; NaN if the surfaces are apart
 * @property {number} gap_low
 * @property {number} gap_high
 * @property {number} pull_off_force the largest pull that a specimen withstands [N]; NaN if very many summits touch
 * @property {number} pull_off_force_low
 * @property {number} pull_off_force_high
 * @property {number} error_growth by how much the errors of the measured points grew; 1 if they do not contradict each other
 * @property {number} warnings bits, which `warningsOf` puts into words
 * @property {"default" | "table" | "given" | "measured"} strength_source what the strength of the interface rests on
 * @property {"many contacts" | "any" | "measured"} specimen what the numbers are of: specimens hardly differ, one of them, or the measured one
 * @property {number} measured_specimens on how many the points were measured, as the text says; 0 if it does not
 * @property {boolean} is_of_pressures whether the text has no nominal area, so that loads are pressures [Pa]
 */

/**
 * Friction at a load or at many, with bands, from the text of a surface alone: docs/solvers.md has its keys.
 * @template {number | ArrayLike<number>} T
 * @param {import("./library.js").Library} library
 * @param {string} text
 * @param {T} load [N]
 * @returns {T extends number ? Estimate : Estimate[]}
 * @throws {AsperityError} with the line and the key, or the element
 */
export function estimate(library, text, load) {
  const size = LAYOUTS[STRUCT].size;
  const { at, length, loads, count, end } = laid(library, text, load, (count) => count * size);
  library.write(end, STRUCT, "struct_size", size);
  library.run("estimate_at_loads", at, length, count, loads, end);
  const found = Array.from({ length: count }, (_, i) => {
    const { is_of_pressures, strength_source, specimen, ...numbers } = library.read(end + i * size, STRUCT);
    const words = { strength_source: SOURCES[strength_source], specimen: SPECIMENS[specimen] };
    return { ...numbers, ...words, is_of_pressures: is_of_pressures === 1 };
  });
  return /** @type {any} */ (typeof load === "number" ? found[0] : found);
}

/**
 * The same for people: coefficients with their bands, what they rest on, and what would narrow the bands.
 * @param {import("./library.js").Library} library
 * @param {string} text
 * @param {number | ArrayLike<number>} load [N]
 * @returns {string}
 */
export function estimateText(library, text, load) {
  const LONGEST = 256;
  const { at, length, loads, count, end } = laid(library, text, load, (count) => LONGEST * (count + 16));
  const written = library.call("estimate_text", at, length, count, loads, end, LONGEST * (count + 16));
  if (!written) throw new AsperityError(library.lastError(), CONSTANTS.INVALID_PARAMETER);
  return library.string(end);
}

/**
 * Lays a text and loads into the memory, with room behind them.
 * @param {import("./library.js").Library} library
 * @param {string} text
 * @param {number | ArrayLike<number>} load
 * @param {(count: number) => number} room
 */
function laid(library, text, load, room) {
  if (typeof text !== "string") throw new TypeError(`text = ${String(text)}: must be a string`);
  const numbers = numbersOf("load", load);
  const bytes = new TextEncoder().encode(text).subarray(0, 2 ** 20 + 1);
  const behind = 8 * Math.ceil(bytes.length / 8);
  const at = library.room(Math.max(1, behind + 8 * numbers.length + room(numbers.length)));
  const [loads, end] = [at + behind, at + behind + 8 * numbers.length];
  const data = library.data();
  new Uint8Array(data.buffer).set(bytes, at);
  numbers.forEach((number, i) => data.setFloat64(loads + 8 * i, number, true));
  return { at, length: bytes.length, loads, count: numbers.length, end };
}
