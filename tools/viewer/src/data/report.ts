// A report's index and, when asked for, what its walks did in detail.

import type { CampusEntry, Details, Index, WalkRow } from '../format';
import { BadReport, type Chunks } from './chunks';
import { parseLog, type LogLine } from './log';
import { Path } from './path';

/** A walk in detail, decoded. */
export interface WalkData {
  row: WalkRow;
  details: Details;
  path: Path | null;
  log: LogLine[];
}

export class Report {
  private readonly lines = new Map<number, Promise<string[]>>();

  private constructor(
    readonly index: Index,
    readonly chunks: Chunks,
  ) {}

  static async open(chunks: Chunks): Promise<Report> {
    let index: unknown;
    try {
      index = JSON.parse(await chunks.text('index', true));
    } catch (error) {
      if (error instanceof BadReport) throw error;
      throw new BadReport("This report is damaged: its index isn't JSON. Write it again.");
    }
    return new Report(checked(index), chunks);
  }

  campusOf(row: WalkRow): CampusEntry | null {
    return this.index.campuses[row.campus] ?? null;
  }

  picture(chunk: number | undefined): string | null {
    return chunk === undefined || chunk < 0 ? null : this.chunks.picture(chunk);
  }

  /** Null if the report has nothing more of it than its row. */
  async walk(row: WalkRow): Promise<WalkData | null> {
    if (row.chunk < 0) return null;
    const line = (await this.linesOf(row.chunk))[row.line];
    if (line === undefined) throw new BadReport(`This report is damaged: it lacks the details of ${row.id}.`);
    const details = JSON.parse(line) as Details;
    const recording = details.recording;
    return {
      row,
      details,
      path: recording && recording.way.tick.length > 0 ? new Path(recording.way) : null,
      log: recording ? parseLog(recording.log) : [],
    };
  }

  private linesOf(chunk: number): Promise<string[]> {
    let lines = this.lines.get(chunk);
    if (!lines) {
      lines = this.chunks.text(chunk).then((text) => text.split('\n'));
      this.lines.set(chunk, lines);
      // A few are enough to step from walk to walk.
      if (this.lines.size > 8) this.lines.delete(this.lines.keys().next().value!);
    }
    return lines;
  }
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

/** The index, if it is one; otherwise says what it is instead. */
function checked(value: unknown): Index {
  if (!isRecord(value) || value.campuswalk_report === undefined) {
    throw new BadReport("This page holds no campuswalk report: its index isn't one.");
  }
  if (value.campuswalk_report !== 1) {
    throw new BadReport('This report has another version than its viewer. Write it again with one program.');
  }
  if (!Array.isArray(value.walks) || !Array.isArray(value.campuses)) {
    throw new BadReport('This report is damaged: its index lacks walks or campuses. Write it again.');
  }
  return value as unknown as Index;
}
