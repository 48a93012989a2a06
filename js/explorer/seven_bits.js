// Bytes as text that may stand in a script of a page: seven bits to a letter of one byte, eight bytes for seven.

/** What may not stand there: NUL, the carriage return, which becomes a line feed, and "<", which would begin a tag. */
const OTHERS = [0, 13, 60];
/** In place of one of them and what follows it there is one letter of two bytes, from here on. */
const PAIRS = 0x100;

/** The text of bytes. Its first letter is 1 if its last seven bits are none of them. */
export function encoded(bytes) {
  const parts = [];
  let [bits, held] = [0, 0];
  for (const byte of bytes) {
    [bits, held] = [((bits & 127) << 8) | byte, held + 8];
    for (; held >= 7; held -= 7) parts.push((bits >> (held - 7)) & 127);
  }
  if (held) parts.push((bits << (7 - held)) & 127);
  const more = OTHERS.includes(parts.at(-1)) ? 1 : 0;
  if (more) parts.push(1);
  const letters = [String(more)];
  for (let i = 0; i < parts.length; i++) {
    const other = OTHERS.indexOf(parts[i]);
    letters.push(String.fromCharCode(other < 0 ? parts[i] : PAIRS + 128 * other + parts[++i]));
  }
  return letters.join("");
}

/** The bytes of such a text. */
export function decoded(text) {
  const parts = [];
  for (let i = 1; i < text.length; i++) {
    const code = text.charCodeAt(i);
    if (code < 128) parts.push(code);
    else parts.push(OTHERS[(code - PAIRS) >> 7], code & 127);
  }
  // The letter that was added may have been taken by a pair: then there is one part more all the same.
  const bytes = new Uint8Array(Math.floor(((parts.length - Number(text[0])) * 7) / 8));
  let [bits, held, at] = [0, 0, 0];
  for (const part of parts) {
    [bits, held] = [((bits & 255) << 7) | part, held + 7];
    if (held >= 8 && at < bytes.length) bytes[at++] = (bits >> (held -= 8)) & 255;
  }
  return bytes;
}
