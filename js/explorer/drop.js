// A height map as the roughness of the active surface, or a surface file in its place: chosen, or dropped.
import { momentsOfMap } from "../dist/instantiate.js";
import { $ } from "./dom.js";
import { FIELDS, parsed, shifted } from "./fields.js";
import { fill } from "./inputs.js";
import { read } from "./maps.js";
import { active } from "./state.js";
import { withUnit } from "./text.js";

/** Listens to files. */
export function listenMaps() {
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

async function useMap(file) {
  try {
    if (/\.toml$/i.test(file.name)) return useFile(file.name, await file.text());
    const { heights, columns } = read(file.name, await file.arrayBuffer());
    const step = shifted(parsed($("map-step").value) ?? NaN, -9);
    const unit = Number($("map-unit").value);
    const found = momentsOfMap(heights.map((height) => shifted(height, unit)), columns, step);
    const surface = active();
    surface.roughness = "moments";
    for (const key of ["m0", "m2"]) surface[key] = String(shifted(found[key], -FIELDS[key].power));
    surface.nominal_area = String(shifted(found.area, -FIELDS.nominal_area.power));
    $("map-result").textContent = `${file.name}: ${heights.length / columns} × ${columns} points, levelled. ${described(found)}`;
    fill();
  } catch (error) {
    $("map-result").textContent = `${error.message}`;
  }
}

function useFile(name, text) {
  Object.assign(active(), { roughness: "file", file: text, file_name: name });
  $("map-result").textContent = `${name}: all of this surface is from the file.`;
  fill();
}

function described({ m0, m2, m4, isotropy }) {
  const bandwidth = (m0 * m4) / m2 ** 2;
  return (
    `Sq ${withUnit(Math.sqrt(m0), "m")}, Sdq ${Math.sqrt(2 * m2).toPrecision(3)}, ` +
    `bandwidth ${bandwidth.toPrecision(3)}, isotropy ${isotropy.toFixed(2)}` +
    (isotropy < 0.5 ? ": it has a lay, which surface.analyse of the Python package takes into account." : ".") +
    " The slope is that of this distance of points, and grows where it is smaller: calibrate, or area and friction depend on it."
  );
}
