// Bytes as text that may stand in a page: five letters for four bytes, a sixteenth shorter than base64.

/** The letters from "$" on; "y" stands for "<", which would begin a tag. */
const FIRST = 36;
const TAG = 60;
const INSTEAD = 121;

/** The text of bytes: the number of zeros that fill the last four, then the letters. */
export function encoded(bytes) {
  const zeros = (4 - (bytes.length % 4)) % 4;
  const view = new DataView(Uint8Array.from([...bytes, ...new Array(zeros).fill(0)]).buffer);
  const letters = [String(zeros)];
  for (let at = 0; at < view.byteLength; at += 4) {
    let value = view.getUint32(at);
    const five = [];
    for (let i = 0; i < 5; i++, value = Math.floor(value / 85)) five.unshift(FIRST + (value % 85));
    letters.push(String.fromCharCode(...five.map((code) => (code === TAG ? INSTEAD : code))));
  }
  return letters.join("");
}

/** The bytes of such a text. */
export function decoded(text) {
  const view = new DataView(new ArrayBuffer(((text.length - 1) / 5) * 4));
  for (let at = 1, to = 0; at < text.length; at += 5, to += 4) {
    let value = 0;
    for (let i = 0; i < 5; i++) {
      const code = text.charCodeAt(at + i);
      value = value * 85 + (code === INSTEAD ? TAG : code) - FIRST;
    }
    view.setUint32(to, value);
  }
  return new Uint8Array(view.buffer, 0, view.byteLength - Number(text[0]));
}
