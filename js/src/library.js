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

/** What is shown of a value that is no number. @param {unknown} value */
function shown(value) {
  if (typeof value === "string") return JSON.stringify(value);
  if (typeof value === "bigint") return `${value}n`;
  return typeof value === "object" && value !== null ? Object.prototype.toString.call(value).slice(8, -1) : String(value);
}

/**
 * A number as it is: WebAssembly would take null, "" and [] for 0.
 * @param {string} name
 * @param {unknown} value
 * @param {string} [place]
 */
export function numberOf(name, value, place = "") {
  if (typeof value !== "number") throw new TypeError(`${place}${name} = ${shown(value)}: must be a number`);
  return value;
}

/** A count, or bits. @param {string} name @param {unknown} value @param {string} what it must be */
export function wholeOf(name, value, what = "a whole number from 0") {
  if (!Number.isSafeInteger(value) || Number(value) < 0) throw new TypeError(`${name} = ${shown(value)}: must be ${what}`);
  return Number(value);
}

/**
 * A copy of numbers in a row, each of which is one.
 * @param {string} name
 * @param {number | ArrayLike<number>} values
 */
export function numbersOf(name, values) {
  if (typeof values === "number") return Float64Array.of(values);
  const isRow = typeof values === "object" && values !== null && "length" in values;
  if (!isRow) throw new TypeError(`${name} = ${shown(values)}: must be a number or an array of numbers`);
  const numbers = new Float64Array(wholeOf(`${name}.length`, values.length));
  for (let i = 0; i < numbers.length; i++) {
    const value = values[i];
    numbers[i] = typeof value === "number" ? value : numberOf(name, value, `element ${i}: `);
  }
  return numbers;
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

/** The C functions, by name without its prefix; 64-bit integers are BigInts. @typedef {Record<string, (...values: any[]) => any>} Functions */

/** One instance of the library. */
export class Library {
  /** @param {WebAssembly.Instance} instance */
  constructor(instance) {
    this.memory = /** @type {WebAssembly.Memory} */ (instance.exports.memory);
    const named = Object.entries(instance.exports).map(([name, value]) => [name.replace("asperity_", ""), value]);
    this.functions = /** @type {Functions} */ (Object.fromEntries(named));
    const abi = this.functions.abi_version();
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

  /** So many numbers of the memory. @param {number} at @param {number} count */
  numbers(at, count) {
    return new Float64Array(this.memory.buffer, at, count);
  }

  /**
   * Calls a C function. One that stops in the middle leaves the instance unusable.
   * @param {string} name without its prefix
   * @param {...(number | bigint)} values
   */
  call(name, ...values) {
    try {
      return this.functions[name](...values);
    } catch (error) {
      throw this.stopped(error);
    }
  }

  /**
   * The same for one number of a model: without an array of arguments, which costs more than such a call.
   * @param {string} name
   * @param {number} model
   * @param {number} argument
   * @param {number} out receives a slope; 0 for none
   */
  number(name, model, argument, out) {
    try {
      return this.functions[name](model, argument, out);
    } catch (error) {
      throw this.stopped(error);
    }
  }

  /** What is thrown for a call that stopped. @param {unknown} error */
  stopped(error) {
    if (!(error instanceof WebAssembly.RuntimeError)) return error;
    return new AsperityError(`${this.statusText(CONSTANTS.INTERNAL)} (${error.message})`, CONSTANTS.INTERNAL);
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
    return this.string(this.functions.status_string(status));
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
