// Runs the program of the page.
import { element } from "./dom.js";
import { failed, unpacked } from "./packed.js";

unpacked("program").then((bytes) => document.head.append(element("script", { textContent: new TextDecoder().decode(bytes) }))).catch(failed);
