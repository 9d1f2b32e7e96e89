// Lines of the text log: TICK SECONDS KIND OBJECT name=value… (engine/events/event_text.cpp writes them).

export interface LogLine {
  tick: number;
  seconds: number;
  kind: string;
  object: string;
  fields: { name: string; value: string }[];
  /** As it was written. */
  text: string;
}

/** Null if it isn't a line of a log. */
export function parseLogLine(text: string): LogLine | null {
  const head = /^(\d+)\s+(\d+(?:\.\d+)?)\s+(\S+)\s*/.exec(text);
  if (!head) return null;
  const reader = new Reader(text, head[0].length);
  const object = reader.word();
  const fields: LogLine['fields'] = [];
  for (reader.skipSpaces(); !reader.atEnd(); reader.skipSpaces()) {
    const name = reader.until('=');
    fields.push({ name, value: reader.word() });
  }
  return { tick: Number(head[1]), seconds: Number(head[2]), kind: head[3] ?? '', object, fields, text };
}

export function parseLog(lines: readonly string[]): LogLine[] {
  return lines.map(parseLogLine).filter((line) => line !== null);
}

export function fieldOf(line: LogLine, name: string): string | undefined {
  return line.fields.find((field) => field.name === name)?.value;
}

class Reader {
  constructor(
    private readonly text: string,
    private at: number,
  ) {}

  atEnd(): boolean {
    return this.at >= this.text.length;
  }
  isQuote(): boolean {
    return this.text[this.at] === '"';
  }
  skipSpaces(): void {
    while (this.text[this.at] === ' ') ++this.at;
  }
  until(end: string): string {
    const found = this.text.indexOf(end, this.at);
    const stop = found < 0 ? this.text.length : found;
    const part = this.text.slice(this.at, stop);
    this.at = stop + 1;
    return part;
  }
  word(): string {
    return this.isQuote() ? this.quoted() : this.plain();
  }

  private plain(): string {
    const part = this.until(' ');
    --this.at;
    return part;
  }

  /** \" \\ \n, and \xHH for each byte of a character that would control the display. */
  private quoted(): string {
    const encoder = new TextEncoder();
    const bytes: number[] = [];
    for (++this.at; !this.atEnd() && !this.isQuote(); ) {
      const escape = /\\(?:x([0-9a-f]{2})|(.))/y;
      escape.lastIndex = this.at;
      const match = escape.exec(this.text);
      if (match) {
        bytes.push(...(match[1] ? [parseInt(match[1], 16)] : encoder.encode(match[2] === 'n' ? '\n' : match[2])));
        this.at += match[0].length;
      } else {
        const character = String.fromCodePoint(this.text.codePointAt(this.at) ?? 0);
        bytes.push(...encoder.encode(character));
        this.at += character.length;
      }
    }
    ++this.at;
    return new TextDecoder().decode(new Uint8Array(bytes));
  }
}
