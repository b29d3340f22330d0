// Requests to the program. All addresses are relative: the page never leaves its own prefix.

/** The program answered with a sentence that says what is wrong. */
export class Refused extends Error {
  constructor(status, sentence) {
    super(sentence);
    this.status = status;
  }
}

/** The program did not answer. */
export class Unreachable extends Error {
  constructor() {
    super("The program does not answer.");
  }
}

/** Emits "lost" when the program stops answering and "found" when it answers again. */
export class Api extends EventTarget {
  lost = false;

  async #ask(path, options) {
    let answer;
    try {
      answer = await fetch(path, { cache: "no-store", ...options });
      // The body is read here: a program that dies in the middle of it is gone as well.
      answer = { status: answer.status, ok: answer.ok, body: await answer.arrayBuffer() };
    } catch {
      this.#turn(true);
      throw new Unreachable();
    }
    this.#turn(false);
    if (answer.ok) return answer.body;
    let sentence = `The program refused (${answer.status}).`;
    try {
      sentence = JSON.parse(new TextDecoder().decode(answer.body)).error ?? sentence;
    } catch {
      // Not JSON: the number says enough.
    }
    throw new Refused(answer.status, sentence);
  }

  #turn(lost) {
    if (lost === this.lost) return;
    this.lost = lost;
    this.dispatchEvent(new Event(lost ? "lost" : "found"));
  }

  async get(path) {
    return JSON.parse(new TextDecoder().decode(await this.#ask(path, {})));
  }

  async post(path, body) {
    const headers = { "Content-Type": "application/json" };
    const answer = await this.#ask(path, { method: "POST", headers, body: JSON.stringify(body) });
    return JSON.parse(new TextDecoder().decode(answer));
  }

  /** The arrays of a mesh by name. */
  async mesh(path) {
    return readMesh(await this.#ask(path, {}));
  }
}

/** Header length, header as JSON, arrays; all little-endian, as typed arrays are here. */
export function readMesh(buffer) {
  const length = new DataView(buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  const arrays = {};
  for (const { name, type, components, count, offset } of header.arrays) {
    const Kind = type === "uint32" ? Uint32Array : Float32Array;
    arrays[name] = new Kind(buffer, 4 + length + offset, components * count);
  }
  return arrays;
}
