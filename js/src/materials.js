// Materials and pairs of them, with sources, in SI units: the table of asperity.materials in the Python package.
import { TABLE } from "./materials_table.js";

/**
 * An isotropic elastic body; null where no value is trusted.
 * @typedef {{
 *   name: string, young: number, young_range: number[], poisson: number, hardness: number | null,
 *   hardness_range: number[] | null, burgers_vector: number, reference: string
 * }} Material
 *
 * Two bodies, by name, and what holds them together.
 * @typedef {{
 *   first: string, second: string, work_of_adhesion: number, work_of_adhesion_range: number[], hamaker: number | null,
 *   slip_stress_1: number | null, reference: string
 * }} Pair
 */

/** @type {Readonly<Record<string, Material>>} */
export const MATERIALS = Object.freeze(TABLE.materials);
/** @type {Readonly<Record<string, Pair>>} */
export const PAIRS = Object.freeze(TABLE.pairs);

/** The pair of two materials, in either order. @param {string} first @param {string} second @returns {Pair | undefined} */
export const pairOf = (first, second) => PAIRS[`${first}/${second}`] ?? PAIRS[`${second}/${first}`];

/**
 * The parameters of a contact of two materials: moduli, the longer Burgers vector, the range of adhesion equal to it, the
 * lesser hardness if both are known, and of a pair that is listed its work of adhesion and measured slip stress.
 * @param {string} first
 * @param {string} second
 * @returns {import("./params.js").Params}
 */
export function contact(first, second) {
  const bodies = [first, second].map((name) => {
    if (!Object.hasOwn(MATERIALS, name))
      throw new RangeError(`material "${name}": is not known; known are ${Object.keys(MATERIALS).join(", ")}`);
    return MATERIALS[name];
  });
  const [one, other] = bodies;
  const burgers_vector = Math.max(one.burgers_vector, other.burgers_vector);
  /** @type {import("./params.js").Params} */
  const found = { E1: one.young, nu1: one.poisson, E2: other.young, nu2: other.poisson };
  Object.assign(found, { adhesion_range: burgers_vector, burgers_vector });
  if (one.hardness !== null && other.hardness !== null) found.hardness = Math.min(one.hardness, other.hardness);
  const pair = pairOf(first, second);
  if (pair) found.work_of_adhesion = pair.work_of_adhesion;
  if (pair?.slip_stress_1) found.slip_stress_1 = pair.slip_stress_1;
  return found;
}
