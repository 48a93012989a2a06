// The standard deviations of the parameters, from which the band follows.
import { $, element, labelled } from "./dom.js";
import { measuredOf, parsed, uncalibrated } from "./fields.js";

/**
 * To start from, in per cent; the names are the library's but for the last three, of the strength of the interface: one factor
 * on both slip stresses. Of a log-normal factor with a standard deviation of 117.5 %, 95 % lie within 10 either way.
 */
const SPREAD = {
  composite_modulus: ["E*, composite modulus", 5],
  work_of_adhesion: ["w, work of adhesion", 30],
  height_std: ["σ, spread of summit heights", 10],
  summit_radius: ["R, summit radius", 20],
  asperity_count: ["N, number of summits", 20],
  burgers_vector: ["b, Burgers vector", 0],
  unmeasured: ["τ, strength, not measured", 117.5],
  given: ["τ, strength, as given", 30],
  measured: ["μ, where it was measured", 5],
};

const idOf = (name) => `spread-${name}`;

/** The fields, by id. */
export const SPREAD_FIELDS = Object.keys(SPREAD).map(idOf);

/** Makes the fields. */
export function buildSpread(changed) {
  for (const [name, [label, part]] of Object.entries(SPREAD)) {
    const input = element("input", { id: idOf(name), inputMode: "decimal", value: String(part) });
    input.addEventListener("input", changed);
    $("spread").append(element("div", { className: "field" }, ...labelled(idOf(name), label, "%", input)));
  }
}

/** What they say. */
export function deviations() {
  const found = {};
  for (const [name, [label]] of Object.entries(SPREAD)) {
    const value = parsed($(idOf(name)).value) ?? 0;
    if (!(value >= 0 && value <= 1000)) throw new RangeError(`${label}: a standard deviation must be from 0 to 1000 %`);
    found[name] = value / 100;
  }
  return found;
}

/**
 * What they say of one surface. Before its strength is measured, it is a default that may be wrong by a factor 10 either way.
 * @returns {{ spread: Record<string, number>, error: number }} by parameter; the relative error of a measured point
 */
export function spreadOf(surface, { unmeasured, given, measured, ...spread }) {
  const known = !measuredOf(surface) && !uncalibrated(surface);
  return { spread: { ...spread, slip_stress: known ? given : unmeasured }, error: measured };
}
