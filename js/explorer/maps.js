// Height maps from files: comma-separated text and NumPy's .npy.

/** The heights of a file, row after row. @returns {{ heights: Float64Array, columns: number }} */
export const read = (name, buffer) => (isNpy(buffer) ? npy(buffer) : text(new TextDecoder().decode(buffer), name));

const isNpy = (buffer) => {
  const [first, ...rest] = new Uint8Array(buffer, 0, Math.min(6, buffer.byteLength));
  return first === 0x93 && String.fromCharCode(...rest) === "NUMPY";
};

/**
 * Numbers between commas or blanks, or between semicolons or tabs, where a comma is then a decimal one; a row on a line.
 * Lines that begin with # say nothing.
 */
function text(content, name) {
  const heights = [];
  let columns = 0;
  content.split(/\r?\n/).forEach((line, i) => {
    if (!line.trim() || line.startsWith("#")) return;
    const apart = /[;\t]/.test(line);
    const row = line.split(apart ? /[;\t]/ : /[,\s]+/).map((word) => word.trim()).filter((word) => word !== "");
    const values = row.map((word) => Number(apart ? word.replace(",", ".") : word));
    const bad = values.findIndex(Number.isNaN);
    if (bad >= 0) throw new RangeError(`${name}, line ${i + 1}: "${row[bad]}" is no number`);
    columns ||= values.length;
    if (values.length !== columns)
      throw new RangeError(`${name}, line ${i + 1}: has ${values.length} numbers, the rows before it have ${columns}`);
    for (const value of values) heights.push(value);
  });
  if (!heights.length) throw new RangeError(`${name}: has no numbers`);
  return { heights: Float64Array.from(heights), columns };
}

const ARRAYS = {
  f8: ["getFloat64", 8], f4: ["getFloat32", 4], i1: ["getInt8", 1], i2: ["getInt16", 2], i4: ["getInt32", 4],
  u1: ["getUint8", 1], u2: ["getUint16", 2], u4: ["getUint32", 4], i8: ["getBigInt64", 8], u8: ["getBigUint64", 8],
};

/** NumPy's format, versions 1 to 3, of two dimensions. */
function npy(buffer) {
  const view = new DataView(buffer);
  const start = view.getUint8(6) === 1 ? 10 : 12;
  const length = start === 10 ? view.getUint16(8, true) : view.getUint32(8, true);
  const header = new TextDecoder().decode(new Uint8Array(buffer, start, length));
  const [, order, kind] = /'descr':\s*'([<>|=])(\w+)'/.exec(header) ?? [];
  const shape = /'shape':\s*\(([^)]*)\)/.exec(header)?.[1].split(",").filter((part) => part.trim()).map(Number);
  const fortran = /'fortran_order':\s*True/.test(header);
  if (!ARRAYS[kind] || !shape) throw new RangeError(`.npy: heights of type '${kind ?? "?"}' are not read; save them as float64`);
  if (shape.length !== 2) throw new RangeError(`.npy: has shape (${shape.join(", ")}): must be 2-D, rows and columns`);
  const [rows, columns] = shape;
  const [get, size] = ARRAYS[kind];
  if (buffer.byteLength < start + length + rows * columns * size) throw new RangeError(".npy: the file ends too early");
  const heights = new Float64Array(rows * columns);
  for (let i = 0; i < heights.length; i++) {
    const at = fortran ? (i % rows) * columns + Math.floor(i / rows) : i;
    heights[at] = Number(view[get](start + length + i * size, order !== ">"));
  }
  return { heights, columns };
}
