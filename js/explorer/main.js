// The page: what is set, what follows from it, and what is shown of that.
import { instantiate, momentsOfMap } from "../dist/instantiate.js";
import { Chart, STYLES, description } from "./chart.js";
import { banded, curveOf } from "./curves.js";
import { FIELDS, ROUGHNESS, fieldOf, fieldsOfPair, paramsOf, parsed, shifted, start } from "./fields.js";
import { read } from "./maps.js";
import { LANGUAGES, snippet } from "./snippets.js";
import { coefficient, missing, percent, short, spansText, summary, title, withUnit } from "./text.js";

const LETTERS = ["A", "B", "C", "D"];
/** Standard deviations to start from, in per cent; the names are the library's. */
const SPREAD = {
  composite_modulus: ["E*, composite modulus", 5],
  work_of_adhesion: ["w, work of adhesion", 30],
  height_std: ["σ, spread of summit heights", 10],
  summit_radius: ["R, summit radius", 20],
  asperity_count: ["N, number of summits", 20],
  burgers_vector: ["b, Burgers vector", 0],
  slip_stress_1: ["τ₁, strength of small contacts", 30],
};
/** The table shows one of so many points of the curves; copied, it has all. */
const ROW_EVERY = 12;
/** So long nothing must change before a screen reader is told the summary. */
const QUIET_MS = 500;

const $ = (id) => document.getElementById(id);

/** What is set: surfaces by letter, the one that the fields show. */
const state = { surfaces: new Map(), active: "A" };
/** Curves that were computed, by letter: with what they were computed from. */
const computed = new Map();
let library;
let chart;
let shown = [];
/** The standard deviations of the curves that are shown. */
let deviations;
let readAt = 0.5;
let told;

const active = () => state.surfaces.get(state.active);

function element(name, attributes = {}, ...children) {
  const found = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key in found && key !== "list") found[key] = value;
    else found.setAttribute(key, value);
  }
  found.append(...children);
  return found;
}

// --- fields

/** A label that tells the unit to who listens, the field, and the unit for who looks. */
function labelled(id, label, unit, input) {
  const heard = element("span", { className: "hidden" }, unit && ` in ${unit}`);
  const seen = element("span", { className: "unit" }, unit);
  seen.setAttribute("aria-hidden", "true");
  return [element("label", { htmlFor: id }, label, heard), input, seen];
}

/** A number with its slider; both write to the active surface. */
function field(key) {
  const { label, unit, slider } = FIELDS[key];
  const input = element("input", { id: key, inputMode: "decimal" });
  input.setAttribute("aria-describedby", "error");
  const parts = labelled(key, label, unit, input);
  input.addEventListener("input", () => set(key, input.value));
  if (slider) {
    const range = element("input", { type: "range", id: `${key}-slider`, min: 0, max: 1000, step: 1 });
    range.setAttribute("aria-label", `${label}, slider`);
    range.addEventListener("input", () => {
      const [low, high] = slider;
      input.value = String(Number((low * (high / low) ** (range.value / 1000)).toPrecision(3)));
      set(key, input.value);
    });
    parts.push(range);
  }
  return element("div", { className: "field" }, ...parts);
}

function set(key, value) {
  active()[key] = value;
  moveSlider(key);
  schedule();
}

function moveSlider(key) {
  const range = $(`${key}-slider`);
  if (!range) return;
  const value = parsed(active()[key]);
  const [low, high] = FIELDS[key].slider;
  if (value > 0 && Number.isFinite(value)) range.value = (1000 * Math.log(value / low)) / Math.log(high / low);
  range.setAttribute("aria-valuetext", `${active()[key]} ${FIELDS[key].unit}`);
}

/** Writes the active surface into the fields. */
function fill() {
  const surface = active();
  $("fields-roughness").replaceChildren(...ROUGHNESS[surface.roughness].fields.map(field));
  for (const key of Object.keys(FIELDS)) {
    if ($(key)) $(key).value = surface[key];
    moveSlider(key);
  }
  for (const key of ["first", "second", "contact_law", "roughness"]) $(key).value = surface[key];
  $("work_of_adhesion").disabled = $("work_of_adhesion-slider").disabled = surface.contact_law !== "maugis";
  notePair();
  tabs();
}

function notePair() {
  const { MATERIALS, PAIRS } = library;
  const { first, second } = active();
  const pair = PAIRS[`${first}/${second}`] ?? PAIRS[`${second}/${first}`];
  const bodies = [...new Set([first, second])].map((name) => MATERIALS[name]);
  $("pair-note").textContent = [adhesion(pair), ...bodies.flatMap(missing)].join(" ");
  const sources = bodies.map(({ name, reference }) => `${name}: ${reference}.`);
  if (pair) sources.push(`${pair.name}: ${pair.reference}.`);
  $("sources").replaceChildren(...sources.map((text) => element("p", {}, text)));
}

function adhesion(pair) {
  if (!pair) return "No work of adhesion is listed for this pair: set the one of yours.";
  const { work_of_adhesion: one, work_of_adhesion_range: several } = pair;
  const values = several ? range(several, -3, "mJ/m²") : `${shifted(one, 3)} mJ/m², without a range`;
  return `Work of adhesion of this pair: ${values}; it depends on what covers the surfaces.`;
}

const range = ([low, high], power, unit) => `${shifted(low, -power)} to ${shifted(high, -power)} ${unit}`;

function tabs() {
  $("tabs").replaceChildren(
    ...[...state.surfaces].map(([letter, surface]) => {
      const choice = element("input", { type: "radio", name: "surface", value: letter, checked: letter === state.active });
      choice.addEventListener("change", () => {
        state.active = letter;
        fill();
        schedule();
        document.querySelector(`[name="surface"][value="${letter}"]`).focus();
      });
      const name = element("span", {}, title(letter, surface));
      name.style.color = STYLES[LETTERS.indexOf(letter)].color;
      return element("label", {}, choice, name);
    }),
  );
  $("add").disabled = state.surfaces.size === LETTERS.length;
  $("remove").disabled = state.surfaces.size === 1;
}

// --- from what is set to what is shown

let scheduled = false;
function schedule() {
  if (scheduled) return;
  scheduled = true;
  requestAnimationFrame(() => {
    scheduled = false;
    update();
  });
}

function spread() {
  const found = {};
  for (const [name, [label]] of Object.entries(SPREAD)) {
    const value = parsed($(`spread-${name}`).value) ?? 0;
    if (!(value >= 0 && value <= 1000)) throw new RangeError(`${label}: a standard deviation must be from 0 to 1000 %`);
    found[name] = value / 100;
  }
  return found;
}

function loadRange() {
  const [lightest, heaviest] = ["lightest", "heaviest"].map((id) => parsed($(id).value));
  if (!(lightest > 0 && heaviest > lightest && Number.isFinite(heaviest)))
    throw new RangeError("Loads: the lightest must be above 0 N, the heaviest above the lightest");
  return [lightest, heaviest];
}

function update() {
  const errors = [];
  let loads;
  try {
    [loads, deviations] = [loadRange(), spread()];
  } catch (error) {
    tell([{ letter: "", message: error.message }]);
    return;
  }
  shown = [];
  for (const [letter, surface] of state.surfaces) {
    try {
      shown.push({ letter, surface, style: STYLES[LETTERS.indexOf(letter)], curve: curve(letter, surface, loads, deviations) });
    } catch (error) {
      errors.push({ letter, message: error.message });
    }
  }
  tell(errors);
  const options = { active: state.active, logarithmic: $("logarithmic").checked, band: $("band").checked };
  chart.show(shown, options);
  $("chart").setAttribute("aria-label", `Friction coefficient against load: ${description(shown)}. The values are in the table below.`);
  readValues();
  derived();
  warnings(loads);
  table();
  code();
  clearTimeout(told);
  told = setTimeout(() => ($("summary").textContent = shown.map(({ letter, surface, curve }) => summary(letter, surface, curve)).join(" ")), QUIET_MS);
  try {
    history.replaceState(null, "", `#${encodeURIComponent(JSON.stringify(saved()))}`);
  } catch {
    // Some browsers keep the address of a file as it is.
  }
}

/** The curve of a surface, computed anew only if something of it has changed. */
function curve(letter, surface, loads, deviations) {
  const from = JSON.stringify([surface, loads, deviations]);
  const old = computed.get(letter);
  if (old?.from === from) return old.curve;
  if (old) {
    computed.delete(letter);
    old.curve.model.free();
  }
  const found = curveOf(library, paramsOf(surface), loads, deviations);
  computed.set(letter, { from, curve: found });
  return found;
}

function tell(errors) {
  const text = errors.map(({ letter, message }) => (letter && state.surfaces.size > 1 ? `${letter}: ${message}` : message)).join("\n");
  if ($("error").textContent !== text) $("error").textContent = text;
  $("error").hidden = !errors.length;
  document.querySelectorAll("[aria-invalid]").forEach((input) => input.removeAttribute("aria-invalid"));
  for (const { letter, message } of errors) {
    if (letter !== state.active) continue;
    const key = fieldOf(message, active());
    if (key && $(key)) $(key).setAttribute("aria-invalid", "true");
  }
}

// --- what is shown

function readLoad() {
  const { loads } = shown[0].curve;
  const [lightest, heaviest] = [loads[0], loads.at(-1)];
  return lightest * (heaviest / lightest) ** readAt;
}

function readValues() {
  if (!shown.length) {
    $("read-load").textContent = "";
    $("values").replaceChildren();
    return;
  }
  const load = readLoad();
  $("read-load").textContent = withUnit(load, "N", 3);
  $("read").setAttribute("aria-valuetext", shown.map(({ letter, curve }) => `${withUnit(load, "N")}: ${letter} ${coefficient(curve.model.frictionAtLoad(load))}`).join(", "));
  chart.mark(load);
  const columns = shown.map(({ surface, curve: { model } }) => {
    const { mu, low, high } = banded(model, load, deviations);
    const exact = model.stateAtLoad(load);
    return {
      "Friction coefficient μ": coefficient(mu),
      "95 % between": `${coefficient(low)} and ${coefficient(high)}`,
      "Friction force": withUnit(exact.friction_force, "N"),
      "Summits in contact": count(exact.contacting),
      "Real area of nominal": percent(exact.real_area / shifted(parsed(surface.nominal_area), FIELDS.nominal_area.power)),
      "Mean contact radius": withUnit(exact.mean_contact_radius, "m"),
      "Mean pressure on summits": withUnit(exact.mean_asperity_pressure, "Pa"),
      "Stiffness before slip": withUnit(exact.tangential_stiffness, "N/m"),
      "Contacts mostly": regime(exact),
      "Does not hold": library.warningsOf(exact.warnings).map(short).join(", ") || "nothing known",
    };
  });
  const names = shown.map(({ letter, surface, style }) => {
    const name = element("th", { scope: "col" }, title(letter, surface));
    name.style.color = style.color;
    return name;
  });
  const rows = Object.keys(columns[0]).map((quantity) =>
    element("tr", {}, element("th", { scope: "row" }, quantity), ...columns.map((column) => element("td", {}, column[quantity]))),
  );
  $("values").replaceChildren(
    element("thead", {}, element("tr", {}, element("th", { scope: "col" }, `At ${withUnit(load, "N")}`), ...names)),
    element("tbody", {}, ...rows),
  );
}

const head = (names) =>
  element("thead", {}, element("tr", {}, ...names.map((name) => element("th", { scope: "col" }, name))));

const count = (contacts) => (contacts < 100 ? contacts.toPrecision(3) : Math.round(contacts).toLocaleString("en"));

/** How most contacts slip. */
function regime(exact) {
  const ways = [
    [exact.fraction_below_slip_radius_1, "slip as a whole"],
    [exact.fraction_between_slip_radii, "slip by one dislocation"],
    [exact.fraction_above_slip_radius_2, "slip by many dislocations"],
  ];
  const [part, way] = ways.sort(([one], [other]) => other - one)[0];
  return `${way} (${percent(part)})`;
}

/** What the model makes of the active surface. */
function derived() {
  const found = shown.find(({ letter }) => letter === state.active);
  if (!found) return $("derived").replaceChildren();
  const { params } = found.curve.model;
  const constants = found.curve.model.summary();
  const psi = found.curve.states[0].plasticity_index;
  $("derived").textContent =
    `In the model: σ ${withUnit(params.height_std, "m")}, R ${withUnit(params.summit_radius, "m")}, ${count(params.asperity_count)} summits; ` +
    `pull-off ${constants.pull_off_load < -1e-15 ? `at ${withUnit(constants.pull_off_load, "N")}` : "below 1 fN"}, Maugis' λ ${constants.lambda.toPrecision(3)}` +
    (psi ? `, plasticity index ${psi.toPrecision(3)}.` : ".");
}

/** Each warning once, with the surfaces and loads at which it holds. */
function warnings(loads) {
  const places = new Map();
  for (const { letter, surface, curve } of shown)
    for (const warning of curve.warnings)
      places.set(warning.text, [...(places.get(warning.text) ?? []), `${title(letter, surface)} ${spansText(warning, loads)}`]);
  const lines = [...places].map(([text, where]) =>
    element("p", { className: "warning" }, element("strong", {}, `${where.join("; ")}: `), `${text}.`),
  );
  $("warnings").replaceChildren(...lines);
}

/** The columns of the table for one surface. */
const columnsOf = ({ letter, surface }) => [
  `μ ${title(letter, surface)}`, `${letter} low`, `${letter} high`, `${letter} contacts`, `${letter} does not hold`,
];

/** Some loads of the curves, with every surface: each so many points one. */
function tableRows(every) {
  const rows = [["Load [N]", ...shown.flatMap(columnsOf)]];
  if (!shown.length) return rows;
  const { loads } = shown[0].curve;
  for (let i = 0; i < loads.length; i += every)
    rows.push([
      loads[i],
      ...shown.flatMap(({ curve }) => [
        curve.mu[i], curve.low[i], curve.high[i], curve.states[i].contacting,
        library.warningsOf(curve.states[i].warnings).map(short).join("; "),
      ]),
    ]);
  return rows;
}

function table() {
  const [names, ...rows] = tableRows(ROW_EVERY);
  const cell = (value, i) => {
    if (typeof value === "string") return element("td", { className: "words" }, value || "–");
    if (i === 0) return element("th", { scope: "row" }, withUnit(value, "N"));
    return element("td", {}, (i - 1) % 5 === 3 ? count(value) : coefficient(value));
  };
  $("table").replaceChildren(head(names), element("tbody", {}, ...rows.map((row) => element("tr", {}, ...row.map(cell)))));
}

function code() {
  if (!shown.length || !shown.some(({ letter }) => letter === state.active)) {
    $("code").textContent = "";
    return;
  }
  $("code").textContent = snippet($("language").value, active(), Number(readLoad().toPrecision(3)));
}

/** Copies a text; where the clipboard is refused, as in some pages from files, the old way. */
async function copy(text, status) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const area = element("textarea", { value: text });
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
  $(status).textContent = "Copied.";
  setTimeout(() => ($(status).textContent = ""), 3000);
}

// --- height maps

async function useMap(file) {
  try {
    const { heights, columns } = read(file.name, await file.arrayBuffer());
    const step = shifted(parsed($("map-step").value) ?? NaN, -9);
    const unit = Number($("map-unit").value);
    const found = momentsOfMap(heights.map((height) => shifted(height, unit)), columns, step);
    const surface = active();
    surface.roughness = "moments";
    for (const key of ["m0", "m2", "m4"]) surface[key] = String(shifted(found[key], -FIELDS[key].power));
    surface.nominal_area = String(shifted(found.area, -FIELDS.nominal_area.power));
    const alpha = (found.m0 * found.m4) / found.m2 ** 2;
    $("map-result").textContent =
      `${file.name}: ${heights.length / columns} × ${columns} points, levelled. Sq ${withUnit(Math.sqrt(found.m0), "m")}, ` +
      `Sdq ${Math.sqrt(2 * found.m2).toPrecision(3)}, bandwidth ${alpha.toPrecision(3)}, isotropy ${found.isotropy.toFixed(2)}` +
      (found.isotropy < 0.5 ? ": it has a direction, for which the model does not hold." : ".") +
      " Slopes and curvatures are those of this distance of points: filter the map to the size of the contacts.";
    fill();
    schedule();
  } catch (error) {
    $("map-result").textContent = `${error.message}`;
  }
}

// --- what is kept in the address

const KEPT = ["lightest", "heaviest"];
const CHECKED = ["logarithmic", "band"];

function saved() {
  return {
    surfaces: [...state.surfaces],
    active: state.active,
    set: Object.fromEntries([...KEPT, ...Object.keys(SPREAD).map((name) => `spread-${name}`)].map((id) => [id, $(id).value])),
    checked: Object.fromEntries(CHECKED.map((id) => [id, $(id).checked])),
  };
}

/** Takes what an address keeps; one that is not of this page changes nothing. */
function restore() {
  let kept;
  try {
    kept = JSON.parse(decodeURIComponent(location.hash.slice(1)));
  } catch {
    return;
  }
  const known = (list, word) => Object.hasOwn(list, word);
  const surfaces = (Array.isArray(kept?.surfaces) ? kept.surfaces : []).filter(
    ([letter, one]) =>
      LETTERS.includes(letter) && known(library.MATERIALS, one.first) && known(library.MATERIALS, one.second) && known(ROUGHNESS, one.roughness),
  );
  if (!surfaces.length) return;
  const fields = Object.keys(start(library));
  state.surfaces = new Map(
    surfaces.map(([letter, one]) => [letter, { ...start(library), ...Object.fromEntries(fields.filter((key) => typeof one[key] === "string").map((key) => [key, one[key]])) }]),
  );
  state.active = state.surfaces.has(kept.active) ? kept.active : surfaces[0][0];
  for (const [id, value] of Object.entries(kept.set ?? {})) if (id in saved().set) $(id).value = value;
  for (const id of CHECKED) if (typeof kept.checked?.[id] === "boolean") $(id).checked = kept.checked[id];
}

// --- once

function build() {
  for (const id of ["first", "second"]) $(id).append(...Object.keys(library.MATERIALS).map((name) => element("option", { value: name }, name)));
  $("roughness").append(...Object.entries(ROUGHNESS).map(([value, { label }]) => element("option", { value }, label)));
  $("language").append(...Object.keys(LANGUAGES).map((name) => element("option", { value: name }, name)));
  $("fields-adhesion").append(field("work_of_adhesion"));
  $("fields-materials").append(...["E1", "nu1", "E2", "nu2", "hardness", "adhesion_range", "burgers_vector", "slip_stress_1"].map(field));
  $("fields-shape").append(...["skew", "kurtosis"].map(field));
  $("fields-area").append(field("nominal_area"));
  for (const [name, [label, part]] of Object.entries(SPREAD)) {
    const id = `spread-${name}`;
    const input = element("input", { id, inputMode: "decimal", value: String(part) });
    input.addEventListener("input", schedule);
    $("spread").append(element("div", { className: "field" }, ...labelled(id, label, "%", input)));
  }
}

function listen() {
  $("controls").addEventListener("submit", (event) => event.preventDefault());
  for (const id of ["first", "second"])
    $(id).addEventListener("change", () => {
      const surface = active();
      surface[id] = $(id).value;
      const told = fieldsOfPair(library, surface.first, surface.second);
      // A pair without a work of adhesion keeps the one that is set.
      if (!told.work_of_adhesion) delete told.work_of_adhesion;
      Object.assign(surface, told);
      fill();
      schedule();
    });
  for (const id of ["contact_law", "roughness"])
    $(id).addEventListener("change", () => {
      active()[id] = $(id).value;
      fill();
      schedule();
    });
  for (const id of [...KEPT, ...CHECKED]) $(id).addEventListener("input", schedule);
  $("read").addEventListener("input", () => {
    readAt = $("read").value / 1000;
    readValues();
    code();
  });
  $("language").addEventListener("change", code);
  $("copy-code").addEventListener("click", () => copy($("code").textContent, "code-copied"));
  $("copy-table").addEventListener("click", () => copy(tableRows(1).map((row) => row.join(",")).join("\n"), "table-copied"));
  $("add").addEventListener("click", () => {
    const letter = LETTERS.find((one) => !state.surfaces.has(one));
    state.surfaces.set(letter, { ...active() });
    state.surfaces = new Map([...state.surfaces].sort());
    state.active = letter;
    fill();
    schedule();
  });
  $("remove").addEventListener("click", () => {
    computed.get(state.active)?.curve.model.free();
    computed.delete(state.active);
    state.surfaces.delete(state.active);
    state.active = [...state.surfaces.keys()][0];
    fill();
    schedule();
  });
  $("map").addEventListener("change", () => $("map").files[0] && useMap($("map").files[0]));
  const over = (is) => (event) => {
    event.preventDefault();
    $("drop").classList.toggle("over", is);
  };
  $("drop").addEventListener("dragover", over(true));
  $("drop").addEventListener("dragleave", over(false));
  $("drop").addEventListener("drop", (event) => {
    over(false)(event);
    if (event.dataTransfer.files[0]) useMap(event.dataTransfer.files[0]);
  });
}

/** The library, which lies in the page as text. */
async function unpacked() {
  const bytes = Uint8Array.from(atob($("library").textContent), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

async function begin() {
  library = await instantiate(await unpacked());
  state.surfaces.set("A", start(library));
  build();
  restore();
  $("version").textContent = library.version;
  chart = new Chart($("chart"), (load) => {
    const { loads } = shown[0].curve;
    readAt = Math.log(load / loads[0]) / Math.log(loads.at(-1) / loads[0]);
    $("read").value = 1000 * readAt;
    readValues();
  });
  listen();
  $("table-section").open = matchMedia("(min-width: 901px)").matches;
  fill();
  update();
}

begin().catch((error) => {
  $("error").hidden = false;
  $("error").textContent = `The page needs a browser of 2023 or later: ${error.message}`;
});
