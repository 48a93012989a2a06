// Values at the load that is read, what the model makes of a surface, and which of its assumptions fail.
import { $, element, head } from "./dom.js";
import { page, readLoad } from "./state.js";
import { bandOf, coefficient, count, percent, plain, rests, short, spanText, strength, title, withUnit } from "./text.js";

/** Shows the values at the load that is read. */
export function readValues() {
  if (!page.shown.length) {
    $("read-load").textContent = "";
    $("values").replaceChildren();
    return;
  }
  const load = readLoad();
  $("read-load").textContent = withUnit(load, "N", 3);
  const heard = page.shown.map(({ letter, curve }) => `${letter} ${coefficient(curve.model.frictionAtLoad(load))}`);
  $("read").setAttribute("aria-valuetext", `${withUnit(load, "N")}: ${heard.join(", ")}`);
  page.chart.mark(load);
  const columns = page.shown.map((one) => columnOf(one, load));
  const rows = Object.keys(columns[0]).map((quantity) =>
    element("tr", {}, element("th", { scope: "row" }, quantity), ...columns.map((column) => element("td", {}, column[quantity]))),
  );
  $("values").replaceChildren(head([`At ${withUnit(load, "N")}`, ...names()]), element("tbody", {}, ...rows));
}

/** The surfaces by name, in their colours. */
const names = () =>
  page.shown.map(({ letter, surface, style }) => {
    const name = element("span", {}, title(letter, surface));
    name.style.color = style.color;
    return name;
  });

/** The values of one surface, by quantity. */
function columnOf({ surface, curve: { model, band } }, load) {
  const { mu, low, high } = band(load);
  const exact = model.stateAtLoad(load);
  return {
    "Friction coefficient μ": coefficient(mu),
    Band: bandOf(surface, { low, high }),
    "Friction force": withUnit(exact.friction_force, "N"),
    "Asperities in contact": count(exact.contacting),
    "Real area / nominal area": percent(exact.real_area / model.params.nominal_area),
    "Mean contact radius": withUnit(exact.mean_contact_radius, "m"),
    "Mean pressure on asperities": withUnit(exact.mean_asperity_pressure, "Pa"),
    "Stiffness before slip": withUnit(exact.tangential_stiffness, "N/m"),
    "Strength of the interface": strength(surface),
    "Assumptions that fail": page.library.warningsOf(exact.warnings).map(short).join(", ") || "none known",
  };
}

/** What the model makes of the active surface. */
export function derived() {
  const found = page.shown.find(({ letter }) => letter === page.active);
  if (!found) return $("derived").replaceChildren();
  const { params } = found.curve.model;
  const constants = found.curve.model.summary();
  const psi = found.curve.states[0].plasticity_index;
  $("derived").textContent =
    `In the model: ${count(params.asperity_count)} asperities of radius ${withUnit(params.summit_radius, "m")}, standard deviation of heights ` +
    withUnit(params.height_std, "m") + (psi ? `; plasticity index ${psi.toPrecision(3)}` : "") +
    (constants.pull_off_load < -1e-15 ? `; pull-off of the mean surface at ${withUnit(constants.pull_off_load, "N")}.` : ".");
}

/** What each band rests on. */
export function bandNote() {
  const notes = page.shown.map(({ letter, surface }) => `${title(letter, surface)}: ${rests(surface)}`);
  $("band-note").textContent = notes.length ? `${notes.join("; ")}.` : "";
}

/** Each warning once, with the surfaces and loads at which it holds. */
export function warnings(loads) {
  const places = new Map();
  for (const { letter, surface, curve } of page.shown)
    for (const warning of curve.warnings)
      places.set(warning.text, [...(places.get(warning.text) ?? []), `${title(letter, surface)} ${spanText(warning, loads)}`]);
  const lines = [...places].map(([text, where]) =>
    element("p", { className: "warning" }, element("strong", {}, `${where.join("; ")}: `), `${plain(text)}.`),
  );
  $("warnings").replaceChildren(...lines);
}
