// The page: its parts are made, and begin with the surface that the address keeps.
import { instantiate } from "../dist/instantiate.js";
import { decoded } from "./base85.js";
import { COMMON, restore } from "./address.js";
import { Chart } from "./chart.js";
import { buildCode, code } from "./code.js";
import { $ } from "./dom.js";
import { listenMaps } from "./drop.js";
import { start } from "./fields.js";
import { buildInputs, fill } from "./inputs.js";
import { readValues } from "./readings.js";
import { page } from "./state.js";
import { listenTable } from "./table.js";
import { schedule } from "./update.js";

/** The library, which lies in the page as text. */
async function unpacked() {
  return new Response(new Blob([decoded($("library").textContent)]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

/** Reads the values at another load: of the slider, or under the pointer. */
function readAt(part) {
  page.readAt = part;
  readValues();
  code();
}

function pointed(load) {
  const { loads } = page.shown[0].curve;
  const part = Math.log(load / loads[0]) / Math.log(loads.at(-1) / loads[0]);
  $("read").value = 1000 * part;
  readAt(part);
}

async function begin() {
  page.library = await instantiate(await unpacked());
  page.surfaces.set("A", start(page.library));
  page.chart = new Chart($("chart"), pointed);
  buildInputs();
  buildCode();
  listenTable();
  listenMaps();
  restore();
  $("controls").addEventListener("submit", (event) => event.preventDefault());
  for (const id of COMMON) $(id).addEventListener("input", schedule);
  $("read").addEventListener("input", () => readAt($("read").value / 1000));
  $("version").textContent = page.library.version;
  $("table-section").open = matchMedia("(min-width: 901px)").matches;
  fill();
}

begin().catch((error) => {
  $("error").hidden = false;
  $("error").textContent = `The page needs a browser of 2023 or later: ${error.message}`;
});
