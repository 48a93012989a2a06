// From what is set to what is shown: once for each frame in which something changed.
import { keep } from "./address.js";
import { description } from "./chart.js";
import { code } from "./code.js";
import { curveOf, findSpans } from "./curves.js";
import { $ } from "./dom.js";
import { fieldOf, parsed, textOf } from "./fields.js";
import { bandNote, derived, readValues, warnings } from "./readings.js";
import { active, page, styleOf } from "./state.js";
import { table } from "./table.js";
import { plain, summary } from "./text.js";

/** So long nothing must change before a screen reader is told the summary. */
const QUIET_MS = 500;
/** So long nothing must change before it is found where warnings hold, which would slow a slider that is dragged. */
const PAUSE_MS = 120;

/** Curves that were computed, by letter: with what they were computed from. */
const computed = new Map();
let scheduled = false;
let told;
let paused;

/** Has the page updated with the next frame. */
export function schedule() {
  clearTimeout(paused);
  if (scheduled) return;
  scheduled = true;
  requestAnimationFrame(() => {
    scheduled = false;
    update();
  });
}

/** Computes and shows all. */
function update() {
  let loads;
  try {
    loads = loadRange();
  } catch (error) {
    tell([{ letter: "", message: error.message }]);
    return;
  }
  tell(compute(loads));
  draw();
  $("chart").setAttribute("aria-label", `Friction coefficient against load: ${description(page.shown)}. The values are in the table below.`);
  readValues();
  derived();
  bandNote();
  table();
  code();
  paused = setTimeout(ground, PAUSE_MS, loads);
  clearTimeout(told);
  told = setTimeout(announce, QUIET_MS);
  keep();
}

const draw = () =>
  page.chart.show(page.shown, { active: page.active, logarithmic: $("logarithmic").checked, band: $("band").checked });

/** Tells where warnings hold: on the chart and in words. */
function ground(loads) {
  for (const { curve } of page.shown) findSpans(curve);
  draw();
  warnings(loads);
}

/** The curves of all surfaces; what the library refuses comes back. */
function compute(loads) {
  const errors = [];
  page.shown = [];
  for (const [letter, surface] of page.surfaces) {
    try {
      page.shown.push({ letter, surface, style: styleOf(letter), curve: curve(letter, surface, loads) });
    } catch (error) {
      errors.push({ letter, message: error.message.replace(/^line \d+: /, "") });
    }
  }
  return errors;
}

const announce = () =>
  ($("summary").textContent = page.shown.map(({ letter, surface, curve }) => summary(letter, surface, curve)).join(" "));

function loadRange() {
  const [lightest, heaviest] = ["lightest", "heaviest"].map((id) => parsed($(id).value));
  if (!(lightest > 0 && heaviest > lightest && Number.isFinite(heaviest)))
    throw new RangeError("Loads: the lightest must be above 0 N, the heaviest above the lightest");
  return [lightest, heaviest];
}

/** The curve of a surface, computed anew only if something of it has changed. */
function curve(letter, surface, loads) {
  const from = JSON.stringify([surface, loads]);
  const old = computed.get(letter);
  if (old?.from === from) return old.curve;
  forget(letter);
  const found = curveOf(page.library, textOf(page.library, surface), loads);
  computed.set(letter, { from, curve: found });
  return found;
}

/** Frees the curve of a surface. */
export function forget(letter) {
  computed.get(letter)?.curve.model.free();
  computed.delete(letter);
}

function tell(errors) {
  const text = errors.map(({ letter, message }) => (letter && page.surfaces.size > 1 ? `${letter}: ${message}` : message)).join("\n");
  if ($("error").textContent !== plain(text)) $("error").textContent = plain(text);
  $("error").hidden = !errors.length;
  document.querySelectorAll("[aria-invalid]").forEach((input) => input.removeAttribute("aria-invalid"));
  for (const { letter, message } of errors) {
    if (letter !== page.active) continue;
    const key = fieldOf(message, active());
    if (key && $(key)) $(key).setAttribute("aria-invalid", "true");
  }
}
