// The library as a WebAssembly instance: its memory, calls that give a status, and what it says in words.
//
// The instance exports the C interface and imports nothing. A block of memory, which is never given back, holds what
// goes in and out of one call; arrays of loads pass through it in parts, so it need not grow.
import { CONSTANTS, LAYOUTS } from "./header.js";

const PAGE = 65536;
/** Loads that are evaluated in one call. */
export const CHUNK = 2048;
/** Where things lie in the block: structs and strings first, then three arrays of `CHUNK` numbers. */
const STRUCT = 0;
const OUT = 1024;
const TEXT = 2048;
const TEXT_END = 12 * 1024;
const ARRAYS = 16 * 1024;
const BLOCK = ARRAYS + 3 * 8 * CHUNK;

/**
 * Loads as numbers in a row.
 * @param {number | ArrayLike<number>} load
 */
export function numbersOf(load) {
  const loads = typeof load === "number" ? [load] : load;
  if (typeof loads !== "object" || loads === null || typeof loads.length !== "number")
    throw new TypeError(`load = ${String(load)}: must be a number or an array of numbers`);
  return loads;
}

/** What the library refuses, in its own words. */
export class AsperityError extends Error {
  /**
   * @param {string} message names the quantity, its value and what is allowed
   * @param {number} status of the C interface
   */
  constructor(message, status) {
    super(message);
    this.name = "AsperityError";
    /** Why, one of `Status`. */
    this.status = status;
  }
}

/** The C functions, by name; 64-bit integers are BigInts. @typedef {Record<string, (...values: any[]) => any>} Functions */

/** One instance of the library. */
export class Library {
  /** @param {WebAssembly.Instance} instance */
  constructor(instance) {
    this.memory = /** @type {WebAssembly.Memory} */ (instance.exports.memory);
    this.functions = /** @type {Functions} */ (/** @type {unknown} */ (instance.exports));
    const abi = this.functions.asperity_abi_version();
    if (abi !== CONSTANTS.ABI_VERSION)
      throw new Error(`asperity.wasm has ABI version ${abi}, this package needs ${CONSTANTS.ABI_VERSION}: build both anew`);
    this.block = this.memory.grow(Math.ceil(BLOCK / PAGE)) * PAGE;
    /** Where texts lie that are longer than the block has room for. */
    this.long = { at: 0, length: 0 };
    /** Frees models that are no longer reachable. @type {FinalizationRegistry<number>} */
    this.models = new FinalizationRegistry((pointer) => this.call("free", pointer));
    /** @type {DataView} */
    this.view = new DataView(this.memory.buffer);
  }

  /** Addresses of the block's parts. */
  get struct() {
    return this.block + STRUCT;
  }
  get out() {
    return this.block + OUT;
  }
  /** @param {0 | 1 | 2} index */
  array(index) {
    return this.block + ARRAYS + index * 8 * CHUNK;
  }

  /** The memory as it is now: the buffer is another one after it has grown. */
  data() {
    if (this.view.buffer !== this.memory.buffer) this.view = new DataView(this.memory.buffer);
    return this.view;
  }

  /**
   * Calls a C function. One that stops in the middle leaves the instance unusable.
   * @param {string} name without its prefix
   * @param {...(number | bigint)} values
   */
  call(name, ...values) {
    try {
      return this.functions[`asperity_${name}`](...values);
    } catch (error) {
      if (!(error instanceof WebAssembly.RuntimeError)) throw error;
      throw new AsperityError(`${this.statusText(CONSTANTS.INTERNAL)} (${error.message})`, CONSTANTS.INTERNAL);
    }
  }

  /**
   * Calls a C function that gives a status, and throws the library's message if that is not success.
   * @param {string} name
   * @param {...(number | bigint)} values
   */
  run(name, ...values) {
    this.check(this.call(name, ...values));
  }

  /** @param {number} status */
  check(status) {
    if (status !== CONSTANTS.OK) throw new AsperityError(this.lastError(), status);
  }

  lastError() {
    return this.written((buffer, length) => this.call("last_error", buffer, length));
  }

  /** A text that a C function writes into a buffer, and whose length it returns. @param {(buffer: number, length: number) => number} write */
  written(write) {
    const length = write(0, 0) + 1;
    const text = this.room(length);
    write(text, length);
    return this.string(text);
  }

  /** A place for a text of so many bytes, for one call. @param {number} length */
  room(length) {
    if (length <= TEXT_END - TEXT) return this.block + TEXT;
    if (length > this.long.length) {
      const pages = Math.ceil(length / PAGE);
      this.long = { at: this.memory.grow(pages) * PAGE, length: pages * PAGE };
    }
    return this.long.at;
  }

  /** Lays bytes into the memory, for one call. @param {Uint8Array} bytes */
  bytes(bytes) {
    const at = this.room(bytes.length);
    new Uint8Array(this.memory.buffer).set(bytes, at);
    return at;
  }

  /** @param {number} status */
  statusText(status) {
    return this.string(this.functions.asperity_status_string(status));
  }

  /** @param {number} pointer of a string that ends in NUL */
  string(pointer) {
    const bytes = new Uint8Array(this.memory.buffer, pointer);
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }

  /**
   * Lays a name into the block, for one call that may also write a text. The library reads no more of it than this.
   * @param {string} name
   */
  text(name) {
    new Uint8Array(this.memory.buffer).set(new TextEncoder().encode(`${name.slice(0, 64)}\0`), this.out);
    return this.out;
  }

  /**
   * Sets parameters by their names in the struct that lies at `struct`.
   * @param {string[]} names
   * @param {number[]} values
   */
  setValues(names, values) {
    const encoded = names.map((name) => new TextEncoder().encode(name.slice(0, 64)));
    const length = encoded.reduce((sum, name) => sum + name.length + 1, 0);
    if (TEXT + length > TEXT_END || names.length > CHUNK / 2) throw new RangeError(`${names.length} parameters: too many`);
    let at = this.block + TEXT;
    // In the last array: the first two may hold a table of heights.
    const listed = this.array(2);
    const numbers = listed + 4 * CHUNK;
    const data = this.data();
    const bytes = new Uint8Array(data.buffer);
    encoded.forEach((name, i) => {
      data.setUint32(listed + 4 * i, at, true);
      data.setFloat64(numbers + 8 * i, values[i], true);
      bytes.set(name, at);
      bytes[at + name.length] = 0;
      at += name.length + 1;
    });
    this.run("params_set_values", this.struct, names.length, listed, numbers);
  }

  /**
   * Writes one field of a struct.
   * @param {number} address of the struct
   * @param {string} struct
   * @param {string} field
   * @param {number} value
   */
  write(address, struct, field, value) {
    const found = LAYOUTS[struct].fields.find(({ name }) => name === field);
    if (!found) throw new Error(`${struct} has no field ${field}`);
    const at = address + found.offset;
    if (found.type === "double") this.data().setFloat64(at, value, true);
    else if (found.type === "uint64_t") this.data().setBigUint64(at, BigInt(value), true);
    else if (found.type === "int32_t") this.data().setInt32(at, value, true);
    else this.data().setUint32(at, value, true);
  }

  /**
   * Reads all numbers of a struct but its size.
   * @param {number} address
   * @param {string} struct
   * @returns {any}
   */
  read(address, struct) {
    const data = this.data();
    /** @type {Record<string, number | number[]>} */
    const found = {};
    for (const { name, type, offset, count } of LAYOUTS[struct].fields) {
      const at = address + offset;
      if (name === "struct_size" || type === "pointer") continue;
      if (count) found[name] = Array.from({ length: count }, (_, i) => data.getFloat64(at + 8 * i, true));
      else if (type === "double") found[name] = data.getFloat64(at, true);
      else if (type === "uint64_t") found[name] = Number(data.getBigUint64(at, true));
      else if (type === "int32_t") found[name] = data.getInt32(at, true);
      else found[name] = data.getUint32(at, true);
    }
    return found;
  }

  /**
   * Calls a function that fills a struct, its last argument.
   * @param {string} struct
   * @param {string} name
   * @param {...(number | bigint)} values
   */
  fill(struct, name, ...values) {
    this.write(this.out, struct, "struct_size", LAYOUTS[struct].size);
    this.run(name, ...values, this.out);
    return this.read(this.out, struct);
  }
}
