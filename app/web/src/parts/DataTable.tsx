import type {Table} from '../wire/types';

// "237.3 s", "−6.22", "12 %", "≤ 288 s": what lines up at the right
const looksNumeric = /^[≤≥<>=±+\s]*[−-]?\d[\d.,:]*(\s?\S{1,5}){0,2}$/u;

/** Columns where every filled cell is a number stand at the right. */
export function numericColumns(table: Table): boolean[] {
  return table.columns.map((_, column) => {
    const cells = table.rows.map((row) => row[column] ?? '').filter((cell) => cell !== '' && cell !== '–');
    return cells.length > 0 && cells.every((cell) => looksNumeric.test(cell));
  });
}

/** A table from the server as it is, with its caption for screen readers. */
export function DataTable({table, caption}: {table: Table; caption: string}) {
  const numeric = numericColumns(table);
  const side = (column: number) => (numeric[column] ? 'r' : undefined);
  return (
    <div className="table-scroll" role="region" aria-label={caption} tabIndex={0}>
      <table className="table">
        <caption className="visually-hidden">{caption}</caption>
        <thead>
          <tr>{table.columns.map((name, column) => <th key={name} scope="col" className={side(column)}>{name}</th>)}</tr>
        </thead>
        <tbody>
          {table.rows.map((row, index) => (
            <tr key={index}>{row.map((cell, column) => <td key={column} className={side(column)}>{cell}</td>)}</tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
