// What lies in the page packed: its program and the library.
import { decoded } from "./seven_bits.js";
import { $ } from "./dom.js";

/** The bytes of a part of the page. */
export const unpacked = (id) =>
  new Response(new Blob([decoded($(id).textContent)]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();

/** Says that the page does not work here. */
export function failed(error) {
  $("error").hidden = false;
  $("error").textContent = `The page needs a browser of 2023 or later: ${error.message}`;
}
