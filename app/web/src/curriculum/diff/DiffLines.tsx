import type {CurriculumDiff} from '../../wire/types';
import styles from './diff.module.css';

type Line = CurriculumDiff['lines'][number];

export interface SideBySide {
  left: Line | null;
  right: Line | null;
}

/** Removed lines beside the added ones that take their place. */
export function sideBySide(lines: readonly Line[]): SideBySide[] {
  const rows: SideBySide[] = [];
  let open = 0;  // the first row of this change that has room at the right
  lines.forEach((line, index) => {
    const before = lines[index - 1]?.kind;
    if (line.kind === 'same' || line.kind === 'gap') rows.push({left: line, right: line});
    else if (line.kind === 'removed') {
      if (before !== 'removed') open = rows.length;
      rows.push({left: line, right: null});
    } else {
      if (before !== 'removed' && before !== 'added') open = rows.length;
      const row = rows[open];
      if (row && row.right === null) row.right = line;
      else rows.push({left: null, right: line});
      ++open;
    }
  });
  return rows;
}

/** Two texts side by side; a sign and a word mark what is gone and what is new. */
export function DiffLines({lines, from, to}: {lines: readonly Line[]; from: string; to: string}) {
  return (
    <div className={styles.scroll} role="region" aria-label="The two texts side by side" tabIndex={0}>
      <table className={styles.lines}>
        <thead><tr><th scope="col" colSpan={2}>{from}</th><th scope="col" colSpan={2}>{to}</th></tr></thead>
        <tbody>
          {sideBySide(lines).map(({left, right}, index) => (left?.kind === 'gap'
            ? <tr key={index}><td colSpan={4} className={styles.gap}>{left.text === '' ? 'Unchanged lines are left out' : left.text}</td></tr>
            : (
              <tr key={index}>
                <td className={styles.number}>{left && left.before > 0 ? left.before : ''}</td>
                <td className={left?.kind === 'removed' ? styles.removed : ''}>{left?.kind === 'removed' && <Sign word="Removed" sign={'\u2212'} />}{left?.text}</td>
                <td className={styles.number}>{right && right.after > 0 ? right.after : ''}</td>
                <td className={right?.kind === 'added' ? styles.added : ''}>{right?.kind === 'added' && <Sign word="Added" sign="+" />}{right?.text}</td>
              </tr>
            )))}
        </tbody>
      </table>
    </div>
  );
}

function Sign({word, sign}: {word: string; sign: string}) {
  return <><span className={styles.sign} aria-hidden="true">{sign}</span><span className="visually-hidden">{word}: </span></>;
}
