// The active surface as code, at the load that is read.
import { $, copy, element } from "./dom.js";
import { LANGUAGES, snippet } from "./snippets.js";
import { active, page, readLoad } from "./state.js";

/** Shows it. */
export function code() {
  const computed = page.shown.some(({ letter }) => letter === page.active);
  $("code").textContent = computed ? snippet(page.library, $("language").value, active(), Number(readLoad().toPrecision(3))) : "";
}

/** Makes the choice of languages, and copies on request. */
export function buildCode() {
  $("language").append(...Object.keys(LANGUAGES).map((name) => element("option", { value: name }, name)));
  $("language").addEventListener("change", code);
  $("copy-code").addEventListener("click", () => copy($("code").textContent, "code-copied"));
}
