// The filter of the list: words that must all apply. `s:failed` an outcome, `p:name` a project, `@tag` a tag,
// `c:name` a campus, `f:text` a part of the file, anything else a part of the id or message; quotes keep spaces, and
// a leading `!` or `-` excludes.

import type { WalkRow } from '../format';

interface Filter {
  matches(row: SearchableRow): boolean;
  isEmpty: boolean;
}

/** What a filter looks at, in lower case, computed once for each row. */
export interface SearchableRow {
  status: string;
  project: string;
  tags: string[];
  campus: string;
  file: string;
  text: string;
}

/** What people call how a walk ended: an xfail that failed has passed. */
export function statusOf(row: Pick<WalkRow, 'outcome' | 'expected_to_fail'>): string {
  return row.outcome === 'passed' && row.expected_to_fail ? 'xfail' : row.outcome;
}

export function searchable(row: WalkRow, campus: string): SearchableRow {
  return {
    status: statusOf(row),
    project: row.project.toLowerCase(),
    tags: row.tags.map((tag) => tag.toLowerCase()),
    campus: campus.toLowerCase(),
    file: row.file.toLowerCase(),
    text: `${row.id} ${row.name} ${row.code ?? ''} ${row.message ?? ''} ${row.status_reason ?? ''}`.toLowerCase(),
  };
}

type Test = (row: SearchableRow) => boolean;

export function parseFilter(query: string): Filter {
  const tests = words(query.toLowerCase()).map(testOf);
  return { matches: (row) => tests.every((test) => test(row)), isEmpty: tests.length === 0 };
}

/** The query with the word in it, or without if it was there. */
export function toggled(query: string, word: string): string {
  const all = words(query);
  const rest = all.filter((each) => each !== word);
  return (rest.length < all.length ? rest : [...all, word]).map(quoted).join(' ');
}

export function has(query: string, word: string): boolean {
  return words(query).includes(word);
}

/** A word that spaces don't tear apart. */
export function quoted(word: string): string {
  return /\s/.test(word) ? `"${word}"` : word;
}

function words(query: string): string[] {
  const found = query.matchAll(/([!-]?(?:[a-z]:|@)?)"([^"]*)"?|\S+/gi);
  return [...found]
    .map(([whole, prefix, inside]) => (inside === undefined ? whole : (prefix ?? '') + inside))
    .filter((word) => word !== '');
}

function testOf(word: string): Test {
  if (/^[!-]./.test(word)) {
    const test = testOf(word.slice(1));
    return (row) => !test(row);
  }
  if (word.startsWith('@') && word.length > 1) {
    const tag = word.slice(1);
    return (row) => row.tags.includes(tag);
  }
  const value = word.slice(2);
  switch (word.slice(0, 2)) {
    case 's:':
      return statusTest(value);
    case 'p:':
      return (row) => row.project.includes(value);
    case 'c:':
      return (row) => row.campus.includes(value);
    case 'f:':
      return (row) => row.file.includes(value);
    default:
      return (row) => row.text.includes(word);
  }
}

/** A beginning is enough: `s:fail`. */
function statusTest(value: string): Test {
  return (row) => row.status.startsWith(value);
}
