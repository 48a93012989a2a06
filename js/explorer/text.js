// Numbers and sentences as the page shows them.
import { measuredOf, uncalibrated } from "./fields.js";

const PREFIXES = { "-15": "f", "-12": "p", "-9": "n", "-6": "µ", "-3": "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T" };

/** A number with an SI prefix, to so many digits: 0.00123 N is 1.23 mN. */
export function withUnit(value, unit, digits = 3) {
  if (value === 0) return `0 ${unit}`;
  if (!Number.isFinite(value)) return String(value);
  // Rounded first: 999.9 µN is 1.00 mN.
  const rounded = Number(value.toPrecision(digits));
  const power = Math.floor(Math.log10(Math.abs(rounded)) / 3 + 1e-9) * 3;
  const prefix = PREFIXES[power];
  if (prefix === undefined) return `${rounded.toExponential(digits - 1).replace("e", " × 10^").replace("+", "")} ${unit}`;
  return `${(rounded / 10 ** power).toPrecision(digits)} ${prefix}${unit}`;
}

/** A decade of load: 1e-5 is 10 µN. */
export function decade(load) {
  const power = Math.round(Math.log10(load));
  const prefix = PREFIXES[Math.floor(power / 3) * 3];
  return prefix === undefined ? `1e${power}` : `${10 ** (((power % 3) + 3) % 3)} ${prefix}N`;
}

/** A friction coefficient. */
export const coefficient = (mu) => (mu >= 1000 ? mu.toPrecision(4) : mu >= 10 ? mu.toFixed(1) : mu.toFixed(3));

/** A number of contacts or summits. */
export const count = (contacts) => (contacts < 100 ? contacts.toPrecision(3) : Math.round(contacts).toLocaleString("en"));

export const percent = (part) => (part === 0 ? "0 %" : `${Number((100 * part).toPrecision(2))} %`);

/** A message of the library in words, not in the names of fields. */
export const plain = (message) => message.replace(/(?<=\w)_(?=\w)/g, " ");

/** How warnings are called on the chart and in the table. */
export const SHORT = {
  FEW: "fewer than 20 contacts",
  CROWDED: "crowded",
  PLASTIC: "asperities yield",
  STEEP: "steep",
  ATOMIC: "atomic",
  ADHESIVE: "held by adhesion",
  UNCALIBRATED: "not calibrated",
  BROAD: "broad spectrum",
  STRONG: "stronger than the bodies",
  FEW_WAVES: "few waves on the area",
  FLAT_TOP: "flat tops",
  NOT_GAUSSIAN: "not Gaussian",
};

export const short = ({ name }) => SHORT[name] ?? name.toLowerCase();

/** The name of a surface, from its letter and its bodies. */
export const title = (letter, surface) => `${letter} ${surface.roughness === "file" ? surface.file_name : `${surface.first}/${surface.second}`}`;

/** Where the strength of the interface is from. */
export function strength(surface) {
  const measured = measuredOf(surface);
  if (measured) return `from μ = ${measured.mu} at ${withUnit(measured.load, "N")}${surface.measured_on && ", other roughness"}`;
  return uncalibrated(surface) ? "not measured" : "as given";
}

/** A band in the words of an estimate: a default strength is no more than an order of magnitude. */
export function bandOf(surface, { low, high }) {
  if (low === high) return "none: all inputs count as known";
  return `${uncalibrated(surface) ? "an order of magnitude" : "95 %"}, ${coefficient(low)} to ${coefficient(high)}`;
}

/** What the band of a surface rests on. */
export function rests(surface) {
  const measured = measuredOf(surface);
  if (measured) return `strength measured at ${withUnit(measured.load, "N")} to 5 %`;
  return uncalibrated(surface) ? "strength not measured: an order of magnitude" : "strength as given, taken as known";
}

/** What to know of a surface without a measured strength; empty of the others. */
export const unmeasured = (surface) =>
  uncalibrated(surface)
    ? " Not calibrated: the strength of this interface is a default, and friction may be many times higher or lower." +
      " Enter one measured friction coefficient and its load."
    : "";

/** Some sentences on a curve. */
export function summary(letter, surface, curve) {
  const last = curve.loads.length - 1;
  const range = `${title(letter, surface)}: friction coefficient ${coefficient(curve.mu[0])} at ${withUnit(curve.loads[0], "N")}, ` +
    `${coefficient(curve.mu[last])} at ${withUnit(curve.loads[last], "N")}.`;
  const failing = curve.warnings.filter(({ name }) => name !== "UNCALIBRATED");
  const said = failing.length
    ? `Assumptions fail at some of these loads: ${failing.map(short).join(", ")}.`
    : "No assumption is known to fail at these loads.";
  return `${range}${unmeasured(surface)} ${said}`;
}

/** Where a warning holds, in words. */
export function spanText({ span: [from, to] }, [lightest, heaviest]) {
  if (!(from <= to)) return "somewhere between these loads";
  if (from === lightest && to === heaviest) return "at all these loads";
  if (from === lightest) return `below ${withUnit(to, "N")}`;
  if (to === heaviest) return `above ${withUnit(from, "N")}`;
  return `from ${withUnit(from, "N")} to ${withUnit(to, "N")}`;
}

/** What is not known of a body, and what follows from that. */
export function missing({ name, burgers_vector, hardness }) {
  const found = [];
  if (burgers_vector === null)
    found.push(`No Burgers vector of ${name} is known: set the Burgers vector and the range of adhesion of yours.`);
  if (hardness === null) found.push(`No hardness of ${name} is known: without one, yield is not shown.`);
  return found;
}
