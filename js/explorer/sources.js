// Where the numbers of materials, pairs and interfaces are from, with links to what is published.
import { $, element } from "./dom.js";
import { withUnit } from "./text.js";

/** What of a reference has an address for good: a digital object identifier, a number of arXiv. */
const ADDRESS = /\b(?:doi (10\.\d+\/[^\s,;:]+)|arXiv (\d{4}\.\d+))/g;

/** A reference in parts, those that have an address with it. */
export function partsOf(reference) {
  const parts = [];
  let from = 0;
  for (const { 0: text, 1: doi, 2: arxiv, index } of reference.matchAll(ADDRESS)) {
    parts.push({ text: reference.slice(from, index) });
    parts.push({ text, href: doi ? `https://doi.org/${doi}` : `https://arxiv.org/abs/${arxiv}` });
    from = index + text.length;
  }
  return [...parts, { text: reference.slice(from) }].filter(({ text }) => text);
}

/** All interfaces, those of two bodies first. */
export function interfacesFor(library, { first, second }) {
  const names = [`${first}/${second}`, `${second}/${first}`];
  const isOf = ({ name }) => names.some((pair) => name === pair || name.startsWith(`${pair} `));
  return Object.values(library.INTERFACES).sort((one, other) => isOf(other) - isOf(one));
}

/** What was measured of an interface. */
export function measuredText({ shear_strength, pressure_coefficient, friction_coefficient, load }) {
  const found = [];
  if (shear_strength !== null) found.push(`τ₀ ${withUnit(shear_strength, "Pa")}`);
  if (pressure_coefficient !== null) found.push(`κ ${pressure_coefficient}`);
  if (friction_coefficient !== null) found.push(`μ ${friction_coefficient}${load === null ? "" : ` from ${withUnit(load, "N")}`}`);
  return found.join(", ");
}

/** Shows the sources of a surface's numbers, and the interfaces. */
export function sources(library, surface) {
  const { MATERIALS, PAIRS } = library;
  const { first, second } = surface;
  const bodies = [...new Set([first, second])].map((name) => MATERIALS[name]);
  const pair = PAIRS[`${first}/${second}`] ?? PAIRS[`${second}/${first}`];
  const entry = ({ name, reference }) => element("p", {}, `${name}: `, ...linked(reference), ".");
  $("sources").replaceChildren(...[...bodies, ...(pair ? [pair] : [])].map(entry));
  $("interfaces").replaceChildren(...interfacesFor(library, surface).map(interfaceEntry));
}

const interfaceEntry = (one) =>
  element("p", {}, element("strong", {}, one.name),
    `: ${measuredText(one)}; ${one.conditions}. Source (${one.source}): `, ...linked(one.reference), ".");

const linked = (reference) =>
  partsOf(reference).map(({ text, href }) => (href ? element("a", { href, target: "_blank", rel: "noreferrer" }, text) : text));
