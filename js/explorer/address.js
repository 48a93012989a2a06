// What is set, kept in the address, so that a link shows it again.
import { $ } from "./dom.js";
import { ROUGHNESS, start } from "./fields.js";
import { LETTERS, page } from "./state.js";

const LOADS = ["lightest", "heaviest"];
const CHECKED = ["logarithmic", "band"];

/** The fields of the page that are no surface's. */
export const COMMON = [...LOADS, ...CHECKED];

/** Writes it into the address. */
export function keep() {
  const set = {
    surfaces: [...page.surfaces],
    active: page.active,
    set: Object.fromEntries(LOADS.map((id) => [id, $(id).value])),
    checked: Object.fromEntries(CHECKED.map((id) => [id, $(id).checked])),
  };
  try {
    history.replaceState(null, "", `#${encodeURIComponent(JSON.stringify(set))}`);
  } catch {
    // Some browsers keep the address of a file as it is.
  }
}

/** Takes what an address keeps; one that is not of this page changes nothing. */
export function restore() {
  let kept;
  try {
    kept = JSON.parse(decodeURIComponent(location.hash.slice(1)));
  } catch {
    return;
  }
  const surfaces = (Array.isArray(kept?.surfaces) ? kept.surfaces : []).filter(isSurface);
  if (!surfaces.length) return;
  page.surfaces = new Map(surfaces.map(([letter, one]) => [letter, surfaceOf(one)]));
  page.active = page.surfaces.has(kept.active) ? kept.active : surfaces[0][0];
  for (const id of LOADS) if (Object.hasOwn(kept.set ?? {}, id)) $(id).value = kept.set[id];
  for (const id of CHECKED) if (typeof kept.checked?.[id] === "boolean") $(id).checked = kept.checked[id];
}

function isSurface(entry) {
  const { MATERIALS } = page.library;
  const [letter, one] = Array.isArray(entry) ? entry : [];
  const known = [one?.first, one?.second].every((name) => Object.hasOwn(MATERIALS, name)) && Object.hasOwn(ROUGHNESS, one?.roughness);
  return LETTERS.includes(letter) && known;
}

/** A surface with what is kept of its fields. */
function surfaceOf(kept) {
  const fresh = start(page.library);
  return Object.fromEntries(Object.entries(fresh).map(([key, value]) => [key, typeof kept[key] === "string" ? kept[key] : value]));
}
