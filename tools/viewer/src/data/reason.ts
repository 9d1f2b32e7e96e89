// What a failure's message says in numbers: where, and which riser, ledge, slope, opening or headroom. The program
// words them (engine/walkspace/barrier_text.cpp and engine/expect); nothing here is needed to show the message itself.

import type { Failure, Point } from '../format';
import { fieldOf, type LogLine } from './log';

export interface Measure {
  /** riser, ledge, slope, opening or headroom. */
  kind: string;
  measured: number;
  /** What the body manages or needs; a ledge has none. */
  allowed: number | null;
  unit: 'm' | '°';
}

export interface Reason {
  /** On what is in the way. */
  at: Point | null;
  /** The object in the way; empty if unknown. */
  object: string;
  measure: Measure | null;
  tick: number | null;
}

const number = '(-?\\d+(?:\\.\\d+)?)';
// Not the digits that an id ends with: "tree-009, -4.44, -0.71, 58.00".
const place = new RegExp(`(?<![\\w./-])${number}, ${number}, ${number}(?!\\w)`);
const measures: [kind: string, unit: Measure['unit'], pattern: RegExp][] = [
  ['riser', 'm', new RegExp(`riser of ${number} m.*?(?:steps ${number} m|$)`)],
  ['ledge', 'm', new RegExp(`ledge of ${number} m`)],
  ['slope', '°', new RegExp(`slope of ${number} degrees.*?(?:walks up ${number}|$)`)],
  ['headroom', 'm', new RegExp(`headroom of ${number} m.*?(?:needs ${number} m|$)`)],
  ['opening', 'm', new RegExp(`opening .*?is ${number} m wide, the body needs ${number} m`)],
];

/** The first that the text names, as placeIn: of barriers one behind the other, the one that stopped the visitor. */
export function measureIn(text: string): Measure | null {
  let first: Measure | null = null;
  let least = Infinity;
  for (const [kind, unit, pattern] of measures) {
    const match = pattern.exec(text);
    if (match && match.index < least) {
      least = match.index;
      first = { kind, unit, measured: Number(match[1]), allowed: match[2] === undefined ? null : Number(match[2]) };
    }
  }
  return first;
}

/** Where a fall began. Older runs wrote it without spaces. */
function ledgeIn(text: string): Point | null {
  const match = new RegExp(`it last stood at ${number}, ?${number}, ?${number}(?!\\w)`).exec(text);
  return match ? [Number(match[1]), Number(match[2]), Number(match[3])] : null;
}

export function placeIn(text: string): Point | null {
  const match = place.exec(text);
  return match ? [Number(match[1]), Number(match[2]), Number(match[3])] : null;
}

/** The last event before the failure that names an obstacle. */
function obstacleBefore(log: readonly LogLine[], tick: number): LogLine | undefined {
  return log.findLast((line) => line.tick <= tick && /^avatar\.(blocked|stuck)$/.test(line.kind));
}

export function reasonOf(failure: Failure, log: readonly LogLine[], ids: ReadonlySet<string>): Reason {
  const tick = failure.scene?.tick ?? null;
  const isAboutMotion = /^(blocked|stuck|timeout|unreachable|enclosed|reaches|near|fell|grounded)/.test(failure.code);
  const event = tick !== null && isAboutMotion ? obstacleBefore(log, tick) : undefined;
  const why = event ? (fieldOf(event, 'why') ?? '') : '';
  const by = event ? (fieldOf(event, 'by') ?? '') : '';
  const named = namedIn(failure.message, ids) ?? (by !== '' && by !== '-' ? by : (namedIn(why, ids) ?? ''));
  return {
    at: failure.scene?.contact ?? ledgeIn(failure.message) ?? placeIn(failure.message) ?? placeIn(why),
    object: named,
    measure: measureIn(failure.message) ?? measureIn(why),
    tick,
  };
}

/** The longest id of an object that the text contains as a word. */
export function namedIn(text: string, ids: ReadonlySet<string>): string | null {
  const found = text.split(/[\s,;:'"()]+/).filter((word) => ids.has(word));
  return found.sort((a, b) => b.length - a.length)[0] ?? null;
}

/** "what came, expected what" in two parts, where the message has them. */
export function expectedAndActual(message: string): { expected: string; actual: string } | null {
  const match = /^(.*?),? expected (.+)$/.exec(message) ?? null;
  if (match && match[1] !== '' && match[1] !== 'not') return { actual: match[1]!, expected: match[2]! };
  const swapped = /^expected (.+?), (?:but )?(.+)$/.exec(message);
  return swapped ? { expected: swapped[1]!, actual: swapped[2]! } : null;
}
