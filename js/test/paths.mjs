// Where the tests find and leave things.
import { mkdirSync } from "node:fs";
import { resolve } from "node:path";
import { fileURLToPath } from "node:url";

export const root = fileURLToPath(new URL("../..", import.meta.url));
export const target = resolve(root, process.env.CARGO_TARGET_DIR ?? "target");
/** Where tests may write. */
export const scratch = resolve(target, "js-tests");
mkdirSync(scratch, { recursive: true });
const release = resolve(target, "release");
/** What links a program with the native library. */
export const LINK = ["-L", release, `-Wl,-rpath,${release}`, "-lasperity", "-lm"];
