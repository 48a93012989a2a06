// The active surface as code, at the load that is read.
import { $, copy, element } from "./dom.js";
import { LANGUAGES, snippet } from "./snippets.js";
import { active, page, readLoad } from "./state.js";

let [language] = Object.keys(LANGUAGES);

/** Shows it, in the language that was copied last. */
export function code() {
  const computed = page.shown.some(({ letter }) => letter === page.active);
  $("code").textContent = computed ? snippet(page.library, language, active(), Number(readLoad().toPrecision(3))) : "";
}

/** Makes a button for each language, which copies at once. */
export function buildCode() {
  for (const name of Object.keys(LANGUAGES)) {
    const button = element("button", { type: "button", ariaLabel: `Copy as ${name}` }, name);
    button.addEventListener("click", () => {
      language = name;
      code();
      copy($("code").textContent, "code-copied");
    });
    $("copy-as").append(button, " ");
  }
}
