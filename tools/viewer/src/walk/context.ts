// What the views of one walk share.

import type { CampusEntry, Failure } from '../format';
import type { Report, WalkData } from '../data/report';
import { obstacleOf, type Obstacle } from '../data/obstacle';
import { eventsOf, spansOf, type Span, type TimedEvent } from '../data/spans';
import type { Campuses } from '../scene/campuses';
import type { Store } from '../store';

export interface WalkContext {
  report: Report;
  store: Store;
  campuses: Campuses;
  data: WalkData;
  campus: CampusEntry | null;
  /** Ids of the campus' objects to their indexes. */
  objects: ReadonlyMap<string, number>;
  failures: { failure: Failure; obstacle: Obstacle }[];
  spans: Span[];
  events: TimedEvent[];
  ticksPerSecond: number;
  lastTick: number;
  /** The same walk of the run that this one is compared with, and where the two part. */
  other: { data: WalkData; name: string; partsAt: number | null } | null;
}

export function contextOf(
  report: Report,
  store: Store,
  campuses: Campuses,
  data: WalkData,
  other: WalkContext['other'],
): WalkContext {
  const { result, recording } = data.details;
  const campus = report.campusOf(data.row);
  const objects = new Map((campus?.objects ?? []).map((object, index) => [object.id, index]));
  const lastTick = Math.max(recording?.ticks ?? 0, result.ticks, data.path?.lastTick ?? 0);
  return {
    report,
    store,
    campuses,
    data,
    campus,
    objects,
    other,
    lastTick,
    failures: result.failures.map((failure) => ({ failure, obstacle: obstacleOf(failure) })),
    spans: spansOf(data.log, lastTick),
    events: eventsOf(data.log, result.failures),
    ticksPerSecond: recording?.ticks_per_second ?? result.ticks_per_second,
  };
}
