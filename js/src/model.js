// A friction law ready for use.
import { CONSTANTS } from "./header.js";
import { AsperityError, CHUNK, numberOf, numbersOf, wholeOf } from "./library.js";
import { readText, readParams, writeParams } from "./params.js";

/** @typedef {import("./params.js").Params} Params */
/** @typedef {import("./header.js").State} State */
/** @typedef {import("./header.js").Summary} Summary */
/** @typedef {import("./header.js").Specimens} Specimens */
/** An assumption of the model that fails, and what to do about it. @typedef {{ name: string, bit: number, text: string }} Warning */
/** @typedef {ArrayLike<number>} Loads */

/** The warnings that this version names; a later library may have more. */
const WARNINGS = Object.entries(CONSTANTS)
  .filter(([name]) => name.startsWith("WARNING_"))
  .map(([name, bit]) => ({ name: name.slice("WARNING_".length), bit: Number(bit) }));

/** What a batch call reports of single loads: below pull-off is no error here, and what is one is answered with NaN. @type {number[]} */
const OF_LOADS = [CONSTANTS.OK, CONSTANTS.SEPARATED, CONSTANTS.INVALID_LOAD, CONSTANTS.OUT_OF_RANGE];

/** What is asked of a model, and the calls for one argument, with the slope, and for many. */
const CALLS = {
  friction: { one: "friction_at_load", withSlope: "friction_and_slope_at_load", many: "friction_at_loads", argument: "load" },
  friction_force: { one: "friction_force_at_load", withSlope: "friction_force_and_slope_at_load", many: "friction_force_at_loads",
    argument: "load" },
  tangential_stiffness: { one: "tangential_stiffness_at_load", withSlope: "", many: "tangential_stiffness_at_loads", argument: "load" },
  load: { one: "load_and_slope_at_gap", withSlope: "load_and_slope_at_gap", many: "loads_at_gaps", argument: "gap" },
};
/** @typedef {keyof typeof CALLS} Quantity */

/** Surfaces that are given, or described by a text. @param {import("./library.js").Library} library @param {Params | string} params */
const surfaces = (library, params) => (typeof params === "string" ? readText(library, params) : params);

/**
 * A friction law of two surfaces: friction against load, and exact states. Make it once, ask it often. It frees its memory
 * when it is no longer reachable, or at `free`. All quantities are in the units of the parameters.
 */
export class Model {
  /** @type {number} */
  #pointer = 0;

  /**
   * @param {import("./library.js").Library} library the instance of the library
   * @param {Params | string} params the surfaces, or a text of which `readText` makes them
   * @throws {AsperityError} a parameter that the library refuses, or one that is missing: the message names it, its value and what is allowed
   */
  constructor(library, params) {
    /** @private */
    this.library = library;
    writeParams(library, surfaces(library, params));
    library.run("create", library.struct, library.out);
    this.#pointer = library.data().getUint32(library.out, true);
    library.models.register(this, this.#pointer, this);
  }

  get #open() {
    if (!this.#pointer) throw new AsperityError("model: has been freed; make another", CONSTANTS.NULL_POINTER);
    return this.#pointer;
  }

  /** Frees the memory; the model cannot be used any more. To free twice is no error. */
  free() {
    this.library.models.unregister(this);
    this.library.call("free", this.#pointer);
    this.#pointer = 0;
  }

  /** The parameters of the model. */
  get params() {
    return readParams(this.library, this.#open);
  }

  /**
   * Gives the model other parameters; if that throws, the model is as before.
   * @param {Params | string} params as of `new Model`
   */
  setParams(params) {
    const pointer = this.#open;
    writeParams(this.library, surfaces(this.library, params));
    this.library.run("set_params", pointer, this.library.struct);
  }

  /**
   * The same surfaces after a largest load: up to it summits that yielded spring back elastically, above it first loading goes on.
   * @param {number} largestLoad the largest load that they have borne [force], > 0
   * @returns {Model} which is freed on its own
   * @throws {AsperityError} a load that cannot be, or adhesion, of which unloading is not modelled
   */
  unloaded(largestLoad) {
    this.library.run("unloaded", this.#open, numberOf("largest_load", largestLoad), this.library.out);
    const pointer = this.library.data().getUint32(this.library.out, true);
    const made = new Model(this.library, this.params);
    made.free();
    made.#pointer = pointer;
    this.library.models.register(made, pointer, made);
    return made;
  }

  /**
   * Friction coefficient F/P [-] at a load, or at many: `model.frictionAtLoad(1e-3)`. From the pull-off load to 0 it is
   * `max_friction_coefficient`; below the pull-off load it is 0.
   * @template {number | Loads} T
   * @param {T} load normal load [force]
   * @returns {T extends number ? number : Float64Array}
   * @throws {AsperityError} a load that is not finite, or too heavy; for an array the message has its index
   */
  frictionAtLoad(load) {
    return typeof load === "number" ? this.#value("friction", load) : this.#values("friction", load);
  }

  /**
   * Friction force F [force] at a load, or at many: finite down to the pull-off load, 0 below it.
   * @template {number | Loads} T
   * @param {T} load normal load [force]
   * @returns {T extends number ? number : Float64Array}
   */
  frictionForceAtLoad(load) {
    return typeof load === "number" ? this.#value("friction_force", load) : this.#values("friction_force", load);
  }

  /**
   * Friction coefficient and its slope d(mu)/d(load) [1/force], 0 where the coefficient is capped.
   * @template {number | Loads} T
   * @param {T} load normal load [force]
   * @returns {{ value: T extends number ? number : Float64Array, slope: T extends number ? number : Float64Array }}
   */
  frictionAndSlopeAtLoad(load) {
    return this.#valuesAndSlopes("friction", load);
  }

  /**
   * Friction force and its slope dF/d(load), infinite at the pull-off load itself.
   * @template {number | Loads} T
   * @param {T} load normal load [force]
   * @returns {{ value: T extends number ? number : Float64Array, slope: T extends number ? number : Float64Array }}
   */
  frictionForceAndSlopeAtLoad(load) {
    return this.#valuesAndSlopes("friction_force", load);
  }

  /**
   * Tangential stiffness K_t [force/length] at a load, or at many: force by displacement while all contacts stick. Divided by
   * `stiffness_per_radius` of the summary it is the sum of the radii of all contacts. Their conductance, thermal or electrical, is
   * 2 k times that sum, with 1/k the mean of both bodies' 1/conductivity.
   * @template {number | Loads} T
   * @param {T} load normal load [force]
   * @returns {T extends number ? number : Float64Array}
   */
  tangentialStiffnessAtLoad(load) {
    return typeof load === "number" ? this.#value("tangential_stiffness", load) : this.#values("tangential_stiffness", load);
  }

  /**
   * Normal load at a gap between the mean planes, or at many: 0 at pull-off and beyond.
   * @template {number | Loads} T
   * @param {T} gap between the mean planes of the surfaces [length]
   * @returns {T extends number ? number : Float64Array}
   */
  loadAtGap(gap) {
    return typeof gap === "number" ? this.#value("load", gap) : this.#values("load", gap);
  }

  /**
   * Normal load at a gap, or at many, and its slope d(load)/d(gap): minus the normal stiffness.
   * @template {number | Loads} T
   * @param {T} gap between the mean planes of the surfaces [length]
   * @returns {{ value: T extends number ? number : Float64Array, slope: T extends number ? number : Float64Array }}
   */
  loadAndSlopeAtGap(gap) {
    return this.#valuesAndSlopes("load", gap);
  }

  /**
   * The tangential force [force] at a load and a displacement, and its slope by displacement [force/length], by integration
   * over the summits.
   * @param {number} load normal load [force]
   * @param {number} displacement of the surfaces along each other [length]
   */
  tangentialAtLoad(load, displacement) {
    const { out } = this.library;
    const [at, by] = [numberOf("load", load), numberOf("displacement", displacement)];
    this.library.run("tangential_at_load", this.#open, at, by, out, out + 8);
    return { force: this.library.data().getFloat64(out, true), stiffness: this.library.data().getFloat64(out + 8, true) };
  }

  /**
   * The exact state at a load, by integration over the summits, without the table.
   * @param {number} load normal load [force], from the pull-off load upwards
   * @returns {State}
   */
  stateAtLoad(load) {
    return this.library.fill("asperity_state", "state_at_load", this.#open, numberOf("load", load));
  }

  /**
   * The exact state at a gap.
   * @param {number} gap between the mean planes of the surfaces [length]
   * @returns {State}
   */
  stateAtGap(gap) {
    return this.library.fill("asperity_state", "state_at_gap", this.#open, numberOf("gap", gap));
  }

  /**
   * Single specimens at a load, with the summits that each happens to have. Each quantity is a list of its mean over the specimens,
   * standard deviation, 2.5 % quantile, median and 97.5 % quantile.
   * @param {number} load normal load [force]; also 0 and, with adhesion, below
   * @param {{ specimens?: number, seed?: number }} [options] how many (400 give means within 1 %), and which
   * @returns {Specimens}
   */
  specimensAtLoad(load, { specimens = 400, seed = 0 } = {}) {
    const at = this.library.array(0);
    const [count, first] = [wholeOf("specimens", specimens), BigInt(wholeOf("seed", seed))];
    this.library.data().setFloat64(at, numberOf("load", load), true);
    return this.library.fill("asperity_specimens", "specimens_at_loads", this.#open, Math.min(count, 2 ** 32 - 1), first, 1, at);
  }

  /** The constants of the model: dimensionless groups, pull-off, extent and error of the table. @returns {Summary} */
  summary() {
    return this.library.fill("asperity_summary", "summary_of", this.#open);
  }

  /**
   * The warnings of all states between two loads: what fails and what to do about it. Empty if nothing is known to fail.
   * @param {number} lightest normal load [force]
   * @param {number} heaviest normal load [force]
   * @returns {Warning[]}
   */
  checkLoads(lightest, heaviest) {
    const [from, to] = [numberOf("lightest", lightest), numberOf("heaviest", heaviest)];
    this.library.run("check_loads", this.#open, from, to, this.library.out);
    return warningsOf(this.library, this.library.data().getBigUint64(this.library.out, true));
  }

  /**
   * One number of a call for one load, which costs little more than the call.
   * @param {Quantity} quantity
   * @param {number} load
   * @returns {any}
   */
  #value(quantity, load) {
    // The last is for a slope, where the call has one: NULL. What a call does not take is left out.
    const value = this.library.number(CALLS[quantity].one, this.#open, load, 0);
    if (Number.isNaN(value)) this.#refuse(quantity, load, "");
    return value;
  }

  /**
   * @param {Quantity} quantity
   * @param {number | Loads} load
   * @returns {any}
   */
  #values(quantity, load) {
    return this.#batch(quantity, numbersOf(CALLS[quantity].argument, load));
  }

  /**
   * @param {Quantity} quantity
   * @param {number | Loads} load
   * @returns {any}
   */
  #valuesAndSlopes(quantity, load) {
    if (typeof load !== "number") {
      const numbers = numbersOf(CALLS[quantity].argument, load);
      const slope = new Float64Array(numbers.length);
      return { value: this.#batch(quantity, numbers, slope), slope };
    }
    const { out } = this.library;
    const value = this.library.number(CALLS[quantity].withSlope, this.#open, load, out);
    if (Number.isNaN(value)) this.#refuse(quantity, load, "");
    return { value, slope: this.library.data().getFloat64(out, true) };
  }

  /**
   * A batch call, in parts that fit the block. Values take the places of their loads.
   * @param {Quantity} quantity
   * @param {Float64Array} numbers loads, in the end values
   * @param {Float64Array} [slope] receives the slopes
   */
  #batch(quantity, numbers, slope) {
    const [inputs, values, slopes] = [this.library.array(0), this.library.array(1), slope ? this.library.array(2) : 0];
    // Stiffnesses have no slopes, and their call no place for them.
    const outputs = quantity === "tangential_stiffness" ? [values] : [values, slopes];
    for (let from = 0; from < numbers.length; from += CHUNK) {
      const part = numbers.subarray(from, from + CHUNK);
      this.library.numbers(inputs, part.length).set(part);
      const status = this.library.call(CALLS[quantity].many, this.#open, part.length, inputs, ...outputs);
      if (!OF_LOADS.includes(status)) this.library.check(status);
      const found = this.library.numbers(values, part.length);
      const refused = found.findIndex(Number.isNaN);
      if (refused >= 0) this.#refuse(quantity, part[refused], `element ${from + refused}: `);
      part.set(found);
      slope?.set(this.library.numbers(slopes, part.length), from);
    }
    return numbers;
  }

  /**
   * Throws the library's message about a load, or a gap, that it answered with NaN.
   * @param {Quantity} quantity
   * @param {number} argument
   * @param {string} place
   */
  #refuse(quantity, argument, place) {
    try {
      if (quantity === "load") this.stateAtGap(argument);
      else this.stateAtLoad(argument);
    } catch (error) {
      if (error instanceof AsperityError) throw new AsperityError(place + error.message, error.status);
      throw error;
    }
    throw new AsperityError(`${argument}: no answer was found; a bug in asperity, please report it`, CONSTANTS.INTERNAL);
  }
}

/**
 * Bits as the C interface takes them. @param {string} name @param {number} bits
 */
export function bitsOf(name, bits) {
  return BigInt(wholeOf(name, bits, "a whole number, bits of warnings"));
}

/**
 * What the bits of `warnings` in a state mean, a line for each.
 * @param {import("./library.js").Library} library
 * @param {bigint} bits
 */
export const warningsText = (library, bits) =>
  library.written((buffer, length) => library.call("warnings_text", bits, buffer, length));

/**
 * The bits of `warnings` in a state, in words.
 * @param {import("./library.js").Library} library
 * @param {bigint} bits
 * @returns {Warning[]}
 */
export function warningsOf(library, bits) {
  const found = [];
  for (let bit = 1n; bit <= bits; bit <<= 1n) {
    if (!(bits & bit)) continue;
    const name = WARNINGS.find((warning) => BigInt(warning.bit) === bit)?.name ?? `bit ${bit}`;
    found.push({ name, bit: Number(bit), text: warningsText(library, bit) });
  }
  return found;
}
