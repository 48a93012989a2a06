// The fields of a surface: they show the active one, and write to it.
import { $, element, labelled } from "./dom.js";
import { FIELDS, ROUGHNESS, UNMEASURED, fieldsOfPair, parsed, rougher, shifted } from "./fields.js";
import { sources } from "./sources.js";
import { LETTERS, active, page } from "./state.js";
import { tabs } from "./tabs.js";
import { missing } from "./text.js";
import { forget, schedule } from "./update.js";

/** A number with its slider, or a choice; both write to the active surface. */
function field(key) {
  const { label, unit, slider, choices } = FIELDS[key];
  const input = choices ? element("select", { id: key }, ...choices.map((one) => element("option", { value: one }, one)))
    : element("input", { id: key, inputMode: "decimal" });
  input.setAttribute("aria-describedby", "error");
  input.addEventListener("input", () => set(key, input.value));
  const parts = labelled(key, label, unit, input);
  if (slider) parts.push(sliderOf(key, input));
  return element("div", { className: "field" }, ...parts);
}

function sliderOf(key, input) {
  const { label, slider } = FIELDS[key];
  const [low, high] = slider;
  const range = element("input", { type: "range", id: `${key}-slider`, min: 0, max: 1000, step: 1 });
  range.setAttribute("aria-label", `${label}, slider`);
  range.addEventListener("input", () => {
    input.value = String(Number((low * (high / low) ** (range.value / 1000)).toPrecision(3)));
    set(key, input.value);
  });
  return range;
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

/** Writes the active surface into the fields, and has its curve computed. */
export function fill() {
  const surface = active();
  $("fields-roughness").replaceChildren(...ROUGHNESS[surface.roughness].fields.map(field));
  for (const key of Object.keys(FIELDS)) {
    if ($(key)) $(key).value = surface[key];
    moveSlider(key);
  }
  for (const key of ["first", "second", "contact_law", "roughness"]) $(key).value = surface[key];
  $("work_of_adhesion").disabled = $("work_of_adhesion-slider").disabled = surface.contact_law === "elastic-plastic";
  $("specimens").checked = surface.specimens !== "";
  $("file-note").textContent = surface.roughness === "file" ? `All is from ${surface.file_name || "a file, which you drop below"}.` : "";
  $("rougher").disabled = page.surfaces.size === LETTERS.length || surface.roughness === "file";
  notePair();
  tabs(choose);
  schedule();
}

function choose(letter) {
  page.active = letter;
  fill();
}

function notePair() {
  const { MATERIALS, PAIRS } = page.library;
  const { first, second } = active();
  const pair = PAIRS[`${first}/${second}`] ?? PAIRS[`${second}/${first}`];
  const bodies = [...new Set([first, second])].map((name) => MATERIALS[name]);
  $("pair-note").textContent = [adhesion(pair), ...bodies.flatMap(missing)].join(" ");
  sources(page.library, active());
}

function adhesion(pair) {
  if (!pair) return "No work of adhesion is listed for this pair: set the one of yours.";
  const { work_of_adhesion: one, work_of_adhesion_range: several } = pair;
  const values = several ? several.map((work) => shifted(work, 3)).join(" to ") : shifted(one, 3);
  return `Work of adhesion of this pair: ${values} mJ/m²${several ? "" : ", without a range"}; it depends on what covers the surfaces.`;
}

/** Makes what does not change with the surface, and listens to it. */
export function buildInputs() {
  const options = (values) => values.map(([value, label]) => element("option", { value }, label));
  for (const id of ["first", "second"]) {
    $(id).append(...options(Object.keys(page.library.MATERIALS).map((name) => [name, name])));
    $(id).addEventListener("change", () => usePair(id));
  }
  $("roughness").append(...options(Object.entries(ROUGHNESS).map(([value, { label }]) => [value, label])));
  for (const id of ["contact_law", "roughness"])
    $(id).addEventListener("change", () => {
      active()[id] = $(id).value;
      fill();
    });
  $("fields-adhesion").append(field("work_of_adhesion"));
  $("fields-materials").append(...["E1", "nu1", "E2", "nu2", "hardness", "adhesion_range", "burgers_vector", "slip_stress_1"].map(field));
  $("fields-strength").append(...["calibration_friction_coefficient", "calibration_load"].map(field));
  $("fields-pressure").append(field("pressure_coefficient"));
  $("fields-area").append(field("nominal_area"));
  $("add").addEventListener("click", () => add((surface) => surface));
  $("rougher").addEventListener("click", () => add(rougher));
  $("specimens").addEventListener("change", () => set("specimens", $("specimens").checked ? "1" : ""));
  $("remove").addEventListener("click", remove);
}

function usePair(id) {
  const surface = active();
  surface[id] = $(id).value;
  const told = fieldsOfPair(page.library, surface.first, surface.second);
  // A pair without a work of adhesion keeps the one that is set.
  if (!told.work_of_adhesion) delete told.work_of_adhesion;
  // What was measured was another pair.
  Object.assign(surface, told, UNMEASURED, { pressure_coefficient: "", measured_on: "" });
  fill();
}

/** Adds a surface made from the active one. */
function add(made) {
  const letter = LETTERS.find((one) => !page.surfaces.has(one));
  page.surfaces = new Map([...page.surfaces, [letter, made({ ...active() })]].sort());
  choose(letter);
}

function remove() {
  forget(page.active);
  page.surfaces.delete(page.active);
  choose([...page.surfaces.keys()][0]);
}
