// The page: its parts are made, and begin with the surface that the address keeps.
import { instantiate } from "../dist/instantiate.js";
import { COMMON, restore } from "./address.js";
import { Chart } from "./chart.js";
import { buildCode, code } from "./code.js";
import { $ } from "./dom.js";
import { listenMaps } from "./drop.js";
import { start } from "./fields.js";
import { buildInputs, fill } from "./inputs.js";
import { failed, unpacked } from "./packed.js";
import { readValues } from "./readings.js";
import { page } from "./state.js";
import { listenTable } from "./table.js";
import { schedule } from "./update.js";

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
  page.library = await instantiate(await unpacked("library"));
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

begin().catch(failed);
