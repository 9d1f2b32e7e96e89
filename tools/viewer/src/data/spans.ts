// From the log: which contacts lasted from when to when, and the events that time lines show.

import type { Failure } from '../format';
import { fieldOf, type LogLine } from './log';

type SpanKind = 'collision' | 'trigger' | 'ray';

export interface Span {
  kind: SpanKind;
  object: string;
  from: number;
  to: number;
}

const spanKinds = new Set(['collision', 'trigger', 'ray']);

export function spansOf(log: readonly LogLine[], lastTick: number): Span[] {
  const open = new Map<string, Span>();
  const spans: Span[] = [];
  for (const line of log) {
    const [kind, phase] = line.kind.split('.');
    if (!kind || !spanKinds.has(kind)) continue;
    const key = `${kind} ${line.object}`;
    if (phase === 'enter') {
      const span: Span = { kind: kind as SpanKind, object: line.object, from: line.tick, to: lastTick };
      open.set(key, span);
      spans.push(span);
    } else if (phase === 'exit') {
      const span = open.get(key);
      if (span) span.to = line.tick;
      open.delete(key);
    }
  }
  return spans;
}

export function isDuring(span: { from: number; to: number }, tick: number): boolean {
  return span.from <= tick && tick < Math.max(span.to, span.from + 1);
}

/** Between the events of crouching and standing up. */
export function isCrouching(log: readonly LogLine[], tick: number): boolean {
  const last = log.findLast((line) => line.tick <= tick && /^avatar\.(crouch|stand)$/.test(line.kind));
  return last?.kind === 'avatar.crouch';
}

/** What colours and rows events have. */
export type EventGroup = 'contact' | 'trigger' | 'gaze' | 'popup' | 'body' | 'picture' | 'failure' | 'walk';

const groups: Record<string, EventGroup> = {
  collision: 'contact',
  trigger: 'trigger',
  ray: 'gaze',
  popup: 'popup',
  avatar: 'body',
  object: 'body',
  snapshot: 'picture',
  expect: 'failure',
  walk: 'walk',
};

export function groupOf(kind: string): EventGroup {
  if (/^avatar\.(blocked|stuck|fell)$/.test(kind)) return 'contact';
  return groups[kind.split('.')[0] ?? ''] ?? 'body';
}

export interface TimedEvent {
  tick: number;
  group: EventGroup;
  text: string;
}

/** All but the repetitions of contacts that go on, and the failures, in order of time. */
export function eventsOf(log: readonly LogLine[], failures: readonly Failure[]): TimedEvent[] {
  const events: TimedEvent[] = log
    .filter((line) => !line.kind.endsWith('.stay'))
    .map((line) => ({ tick: line.tick, group: groupOf(line.kind), text: `${line.kind} ${line.object}` }));
  for (const failure of failures) {
    if (failure.scene)
      events.push({ tick: failure.scene.tick, group: 'failure', text: `${failure.code}: ${failure.message}` });
  }
  return events.sort((a, b) => a.tick - b.tick);
}

/** What an object did to the visitor, in a line or a few. */
export function deedsOf(
  object: string,
  log: readonly LogLine[],
  spans: readonly Span[],
  ticksPerSecond: number,
): string[] {
  const words: Record<SpanKind, string> = { collision: 'touched', trigger: 'entered', ray: 'looked at' };
  const at = (tick: number): string => `${(tick / ticksPerSecond).toFixed(2)} s`;
  const deeds: string[] = [];
  for (const kind of ['collision', 'trigger', 'ray'] as const) {
    const own = spans.filter((span) => span.kind === kind && span.object === object);
    const [first] = own;
    if (!first) continue;
    const total = own.reduce((sum, span) => sum + span.to - span.from, 0) / ticksPerSecond;
    const often = own.length > 1 ? ` ${own.length} times, first` : '';
    deeds.push(`${words[kind]}${often} at ${at(first.from)}, for ${total.toFixed(1)} s`);
  }
  const blocked = log.find((line) => /^avatar\.(blocked|stuck)$/.test(line.kind) && fieldOf(line, 'by') === object);
  if (blocked) deeds.push(`in the visitor's way at ${at(blocked.tick)}`);
  return deeds;
}
