// The choice between the surfaces that are compared.
import { $, element } from "./dom.js";
import { LETTERS, page, styleOf } from "./state.js";
import { title } from "./text.js";

/** Shows the surfaces by name; `choose` is told the letter of another. */
export function tabs(choose) {
  $("tabs").replaceChildren(
    ...[...page.surfaces].map(([letter, surface]) => {
      const choice = element("input", { type: "radio", name: "surface", value: letter, checked: letter === page.active });
      choice.addEventListener("change", () => {
        choose(letter);
        document.querySelector(`[name="surface"][value="${letter}"]`).focus();
      });
      const name = element("span", {}, title(letter, surface));
      name.style.color = styleOf(letter).color;
      return element("label", {}, choice, name);
    }),
  );
  $("add").disabled = page.surfaces.size === LETTERS.length;
  $("remove").disabled = page.surfaces.size === 1;
}
