// Which rows of a long grid are worth drawing. The first rows, who need help, are taller than the
// rest; everything else follows from two heights and a number.

export interface Rows {
  readonly count: number;
  /** so many rows at the top have the first height */
  readonly tall: number;
  readonly tall_px: number;
  readonly usual_px: number;
}

export interface RowRange {
  readonly first: number;
  /** one past the last */
  readonly end: number;
}

export function topOf(rows: Rows, index: number): number {
  const tall = Math.min(index, rows.tall);
  return tall * rows.tall_px + (index - tall) * rows.usual_px;
}

export function heightOf(rows: Rows, index: number): number {
  return index < rows.tall ? rows.tall_px : rows.usual_px;
}

export function totalHeight(rows: Rows): number {
  return topOf(rows, rows.count);
}

/** The row that holds this distance from the top of the first row. */
export function rowAt(rows: Rows, y: number): number {
  const tallEnd = rows.tall * rows.tall_px;
  const index = y < tallEnd ? Math.floor(y / rows.tall_px) : rows.tall + Math.floor((y - tallEnd) / rows.usual_px);
  return Math.max(0, Math.min(rows.count - 1, index));
}

/** The rows seen between two distances and some beyond, in whole blocks, so that a little scrolling draws nothing anew. */
export function rowsWithin(rows: Rows, from: number, until: number, beyond: number): RowRange {
  if (rows.count === 0) return {first: 0, end: 0};
  const block = Math.max(1, beyond);
  const first = Math.floor(Math.max(0, rowAt(rows, from) - beyond) / block) * block;
  const end = Math.ceil((rowAt(rows, until) + 1 + beyond) / block) * block;
  return {first, end: Math.min(rows.count, end)};
}
