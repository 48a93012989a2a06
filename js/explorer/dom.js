// Elements of the page: found, made, copied from.

export const $ = (id) => document.getElementById(id);

/** An element with properties, or attributes where it has no such property. */
export function element(name, attributes = {}, ...children) {
  const found = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key in found && key !== "list") found[key] = value;
    else found.setAttribute(key, value);
  }
  found.append(...children);
  return found;
}

/** The head of a table. */
export const head = (names) =>
  element("thead", {}, element("tr", {}, ...names.map((name) => element("th", { scope: "col" }, name))));

/** A label that tells the unit to who listens, the field, and the unit for who looks. */
export function labelled(id, label, unit, input) {
  const heard = element("span", { className: "hidden" }, unit && ` in ${unit}`);
  const seen = element("span", { className: "unit" }, unit);
  seen.setAttribute("aria-hidden", "true");
  return [element("label", { htmlFor: id }, label, heard), input, seen];
}

/** Copies a text; where the clipboard is refused, as in some pages from files, the old way. */
export async function copy(text, status) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const area = element("textarea", { value: text });
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
  $(status).textContent = "Copied.";
  setTimeout(() => ($(status).textContent = ""), 3000);
}
