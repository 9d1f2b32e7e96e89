// The list's order: a group for each file, with its projects and repetitions; files with failures first, failures first
// in each.

import type { Outcome, WalkRow } from '../format';
import { kept } from './kept';

export interface Group {
  file: string;
  /** Indexes of walks. */
  walks: number[];
  failed: number;
}

const rank: Record<Outcome, number> = { failed: 0, broken: 1, bad_input: 2, interrupted: 3, passed: 4, skipped: 5 };

export function isBad(outcome: Outcome): boolean {
  return rank[outcome] < rank.passed;
}

export function grouped(rows: readonly WalkRow[], selected: readonly number[]): Group[] {
  const groups = new Map<string, Group>();
  for (const index of selected) {
    const row = rows[index]!;
    const group = kept(groups, row.file, () => ({ file: row.file, walks: [], failed: 0 }));
    group.walks.push(index);
    group.failed += isBad(row.outcome) ? 1 : 0;
  }
  // Sorting is stable: otherwise the order of the run stays.
  const worst = (group: Group): number => Math.min(...group.walks.map((index) => rank[rows[index]!.outcome]));
  const ranks = new Map([...groups.values()].map((group) => [group, worst(group)]));
  for (const group of groups.values()) {
    if (group.walks.length > 1) group.walks.sort((a, b) => rank[rows[a]!.outcome] - rank[rows[b]!.outcome]);
  }
  return [...groups.values()].sort((a, b) => Math.min(ranks.get(a)!, 4) - Math.min(ranks.get(b)!, 4));
}

const noWalks = { passed: 0, xfail: 0, failed: 0, skipped: 0, bad_input: 0, broken: 0, interrupted: 0 };

export type Counts = Record<keyof typeof noWalks | 'total' | 'seconds' | 'distance', number>;

export function counted(rows: readonly WalkRow[], selected: readonly number[]): Counts {
  const counts: Counts = { ...noWalks, total: selected.length, seconds: 0, distance: 0 };
  for (const index of selected) {
    const row = rows[index]!;
    ++counts[row.outcome === 'passed' && row.expected_to_fail ? 'xfail' : row.outcome];
    counts.seconds += row.seconds;
    counts.distance += Number.isFinite(row.distance) ? row.distance : 0;
  }
  return counts;
}
