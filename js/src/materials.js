// Materials, pairs of them and interfaces, with sources, in SI units, as the library has them.
import { CONSTANTS } from "./header.js";
import { AsperityError } from "./library.js";
import { readStruct, writeParams } from "./params.js";

/**
 * An isotropic elastic body; null where no source is known.
 * @typedef {object} Material
 * @property {string} name
 * @property {number} young Young's modulus [Pa]
 * @property {number[] | null} young_range of published values [Pa]
 * @property {number} poisson Poisson's ratio
 * @property {number | null} hardness indentation hardness [Pa]
 * @property {number[] | null} hardness_range of published values [Pa]
 * @property {number | null} burgers_vector [m]; of a glass the distance of like atoms; an elastomer has none
 * @property {string} reference where the numbers are from
 */

/**
 * Two bodies and what holds them together; null where no source is known.
 * @typedef {object} Pair
 * @property {string} name both bodies, with a slash between
 * @property {string} first
 * @property {string} second
 * @property {number} work_of_adhesion w [J/m^2]
 * @property {number[] | null} work_of_adhesion_range of measurements and estimates [J/m^2]
 * @property {number | null} hamaker the Hamaker constant [J] that w is estimated from
 * @property {number | null} slip_stress_1 measured shear strength of small contacts over G*
 * @property {string} reference where w and the strength are from
 */

/**
 * What was measured of the strength of an interface, a start for one like it; null where no source is known.
 * @typedef {object} Interface
 * @property {string} name what touches, and the film or the surroundings
 * @property {number | null} shear_strength tau_0 [Pa] at no pressure; null where only a friction coefficient is known
 * @property {number | null} pressure_coefficient kappa, what the strength grows by with the pressure
 * @property {number | null} friction_coefficient of many contacts, where the strength of one is not known
 * @property {number | null} load the lightest load of that measurement [N]
 * @property {string} conditions bodies, film, humidity, vacuum, temperature and loads, as far as they are known
 * @property {string} source "read" if the numbers were seen in the text that the reference names, else "quoted"
 * @property {string} reference where the numbers are from
 */

/**
 * What a library knows of materials.
 * @typedef {object} Materials
 * @property {Readonly<Record<string, Material>>} MATERIALS all, by name
 * @property {Readonly<Record<string, Pair>>} PAIRS all, by name
 * @property {Readonly<Record<string, Interface>>} INTERFACES all, by name
 * @property {(name: string) => Interface} interfaceOf one of them; of an unknown name the nearest is told
 * @property {(name: string) => Material} material one of them; of an unknown name the nearest is told
 * @property {(name: string) => Pair} pair one of them, in either order; of an unknown name the nearest is told
 * @property {(first: string, second: string) => import("./params.js").Params} knownOf what is known of two materials in contact:
 *   moduli, the longer Burgers vector, the range of adhesion equal to it, the lesser hardness if both are known, and of a
 *   pair that is listed its work of adhesion and measured slip stress. What is not known is left out.
 * @property {(first: string, second: string, given?: import("./params.js").Params) => import("./params.js").Params} contact the
 *   parameters of a contact of two materials, to which the roughness is added: what is known, and what is given in its
 *   place. A work of adhesion and a Burgers vector that are not known must be given; a range of adhesion that is not known
 *   is taken equal to the latter.
 */

/** Reads them. @param {import("./library.js").Library} library @returns {Materials} */
export function materialsOf(library) {
  const material = (/** @type {string} */ name) => materialOf(library, name);
  const pair = (/** @type {string} */ name) => pairOf(library, name);
  /** @type {Materials["knownOf"]} */
  const knownOf = (first, second) => {
    const [one, other] = [material(first), material(second)];
    const bodies = { E1: one.young, nu1: one.poisson, E2: other.young, nu2: other.poisson };
    return { ...bodies, ...ofPair(library, `${first}/${second}`) };
  };
  /** @type {Materials["contact"]} */
  const contact = (first, second, given = {}) => {
    const found = { ...knownOf(first, second), ...given };
    if (found.work_of_adhesion === undefined) pair(`${first}/${second}`); // which the library refuses
    if (found.burgers_vector === undefined) {
      const says = `burgers_vector: none is known of a body of ${first}/${second}: give one`;
      throw new AsperityError(says, CONSTANTS.INVALID_PARAMETER);
    }
    return { adhesion_range: found.burgers_vector, ...found };
  };
  const interfaceOf = (/** @type {string} */ name) => interfaceNamed(library, name);
  const MATERIALS = table(library, CONSTANTS.NAMES_MATERIALS, material);
  const PAIRS = table(library, CONSTANTS.NAMES_PAIRS, pair);
  const INTERFACES = table(library, CONSTANTS.NAMES_INTERFACES, interfaceOf);
  return { MATERIALS, PAIRS, INTERFACES, material, pair, interfaceOf, knownOf, contact };
}

/** What the library sets for two materials in addition to their moduli. @param {import("./library.js").Library} library @param {string} name */
function ofPair(library, name) {
  writeParams(library, { slip_stress_1: NaN }); // set only where it is measured
  library.run("params_set_pair", library.struct, library.text(name));
  const { work_of_adhesion, adhesion_range, burgers_vector, hardness, slip_stress_1 } = readStruct(library);
  const found = { work_of_adhesion, adhesion_range, burgers_vector, slip_stress_1, hardness: hardness || NaN };
  return Object.fromEntries(Object.entries(found).filter(([, value]) => !Number.isNaN(value)));
}

/**
 * All entries of a kind, by name.
 * @template Entry
 * @param {import("./library.js").Library} library
 * @param {number} kind
 * @param {(name: string) => Entry} read
 * @returns {Readonly<Record<string, Entry>>}
 */
function table(library, kind, read) {
  /** @type {Record<string, Entry>} */
  const found = {};
  for (let index = 0; ; index++) {
    const pointer = library.call("name", kind, index);
    if (!pointer) return Object.freeze(found);
    const name = library.string(pointer);
    found[name] = read(name);
  }
}

/** @param {import("./library.js").Library} library @param {string} name @returns {Material} */
function materialOf(library, name) {
  const { young_low, young_high, hardness_low, hardness_high, ...found } = described(library, "MATERIALS", name);
  return { hardness: null, burgers_vector: null, ...found, young_range: range(young_low, young_high),
    hardness_range: range(hardness_low, hardness_high) };
}

/** @param {import("./library.js").Library} library @param {string} name @returns {Pair} */
function pairOf(library, name) {
  const { work_of_adhesion_low, work_of_adhesion_high, ...found } = described(library, "PAIRS", name);
  const [first, second] = found.name.split("/");
  return { first, second, hamaker: null, slip_stress_1: null, ...found,
    work_of_adhesion_range: range(work_of_adhesion_low, work_of_adhesion_high) };
}

const UNKNOWN = { shear_strength: null, pressure_coefficient: null, friction_coefficient: null, load: null };

/** @param {import("./library.js").Library} library @param {string} name @returns {Interface} */
const interfaceNamed = (library, name) => ({ ...UNKNOWN, ...described(library, "INTERFACES", name) });

/**
 * What the library tells of a name, by key; what it leaves out is not known.
 * @param {import("./library.js").Library} library
 * @param {"MATERIALS" | "PAIRS" | "INTERFACES"} kind
 * @param {string} name
 * @returns {any}
 */
function described(library, kind, name) {
  if (typeof name !== "string") throw new TypeError(`${kind.toLowerCase().slice(0, -1)} = ${String(name)}: must be a name`);
  const asked = library.text(name);
  const lines = library.written((buffer, length) => library.call("describe", CONSTANTS[`NAMES_${kind}`], asked, buffer, length));
  if (!lines) throw new AsperityError(library.lastError(), CONSTANTS.INVALID_PARAMETER);
  // Strings and numbers of TOML as the library writes them are those of JSON.
  const values = [...lines.matchAll(/^(\w+) = ("(?:[^"\\]|\\.)*"|[^\s#]+)/gm)];
  return Object.fromEntries(values.map(([, key, value]) => [key, JSON.parse(value)]));
}

/** @param {number | undefined} low @param {number | undefined} high */
const range = (low, high) => (low === undefined || high === undefined ? null : [low, high]);
