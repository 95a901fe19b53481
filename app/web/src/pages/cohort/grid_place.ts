// Where the keys lead in a grid of rows and columns, as the ARIA grid pattern has it.

export interface Place {
  readonly row: number;
  readonly column: number;
}

export interface GridSize {
  readonly rows: number;
  readonly columns: number;
  /** rows that Page Up and Page Down step over */
  readonly page: number;
}

export interface Pressed {
  readonly key: string;
  readonly ctrl: boolean;
}

/** The place a key leads to; null when the key is none of the grid's. */
export function placeAfterKey(from: Place, {key, ctrl}: Pressed, size: GridSize): Place | null {
  const to = (row: number, column: number): Place => ({
    row: Math.max(0, Math.min(size.rows - 1, row)),
    column: Math.max(0, Math.min(size.columns - 1, column)),
  });
  const {row, column} = from;
  switch (key) {
    case 'ArrowUp': return to(row - 1, column);
    case 'ArrowDown': return to(row + 1, column);
    case 'ArrowLeft': return to(row, column - 1);
    case 'ArrowRight': return to(row, column + 1);
    case 'PageUp': return to(row - size.page, column);
    case 'PageDown': return to(row + size.page, column);
    case 'Home': return to(ctrl ? 0 : row, 0);
    case 'End': return to(ctrl ? size.rows - 1 : row, size.columns - 1);
    default: return null;
  }
}
