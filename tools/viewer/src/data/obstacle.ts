// What a failure is about: where, which object, and what was measured.

import type { Failure, Point, Reason } from '../format';

export interface Measure {
  /** riser, ledge, slope, opening or headroom. */
  kind: string;
  measured: number;
  /** What the body manages or needs; a ledge has none. */
  allowed: number | null;
  unit: 'm' | '°';
}

/** What is in the way, as the views show it. */
export interface Obstacle {
  /** On what is in the way. */
  at: Point | null;
  /** The object in the way; empty if unknown. */
  object: string;
  measure: Measure | null;
  tick: number | null;
}

const measuredKinds: readonly string[] = ['riser', 'ledge', 'slope', 'headroom', 'opening'];

/** The first that was measured: of barriers one behind the other, the one that stopped the visitor. */
export function measureOf(reason: Reason): Measure | null {
  const inDegrees = reason.measured_deg !== undefined;
  const measured = reason.measured_deg ?? reason.measured;
  if (measuredKinds.includes(reason.kind) && measured !== undefined)
    return {
      kind: reason.kind,
      measured,
      allowed: reason.allowed_deg ?? reason.allowed ?? null,
      unit: inDegrees ? '°' : 'm',
    };
  for (const part of reason.parts ?? []) {
    const measure = measureOf(part);
    if (measure) return measure;
  }
  return null;
}

function placeOf(reason: Reason): Point | null {
  return reason.look_at ?? reason.at ?? firstOf(reason, placeOf);
}

function objectOf(reason: Reason): string {
  return reason.object ?? firstOf(reason, (part) => objectOf(part) || null) ?? '';
}

function firstOf<Value>(reason: Reason, of: (part: Reason) => Value | null): Value | null {
  for (const part of reason.parts ?? []) {
    const value = of(part);
    if (value !== null) return value;
  }
  return null;
}

export function obstacleOf({ scene, reason, object }: Failure): Obstacle {
  return {
    at: scene?.contact ?? (reason ? placeOf(reason) : null),
    object: (reason ? objectOf(reason) : '') || (object ?? ''),
    measure: reason ? measureOf(reason) : null,
    tick: scene?.tick ?? null,
  };
}
