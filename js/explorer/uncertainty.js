// The standard deviations of the parameters, from which the band follows.
import { $, element, labelled } from "./dom.js";
import { parsed } from "./fields.js";

/** To start from, in per cent; the names are the library's. */
const SPREAD = {
  composite_modulus: ["E*, composite modulus", 5],
  work_of_adhesion: ["w, work of adhesion", 30],
  height_std: ["σ, spread of summit heights", 10],
  summit_radius: ["R, summit radius", 20],
  asperity_count: ["N, number of summits", 20],
  burgers_vector: ["b, Burgers vector", 0],
  slip_stress_1: ["τ₁, strength of small contacts", 30],
  measured_friction: ["μ, where it was measured", 5],
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

/** What they say, by parameter. */
export function spread() {
  const found = {};
  for (const [name, [label]] of Object.entries(SPREAD)) {
    const value = parsed($(idOf(name)).value) ?? 0;
    if (!(value >= 0 && value <= 1000)) throw new RangeError(`${label}: a standard deviation must be from 0 to 1000 %`);
    found[name] = value / 100;
  }
  return found;
}
