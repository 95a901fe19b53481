import {Button} from '@mantine/core';
import styles from './pager.module.css';

interface Props {
  page: number;    // 0-based
  size: number;
  total: number;
  what: string;    // "people"
  onPage: (page: number) => void;
}

/** Which part of a long list is shown, and the way to the rest. */
export function Pager({page, size, total, what, onPage}: Props) {
  if (total <= size) return null;
  const last = Math.ceil(total / size) - 1;
  return (
    <nav className={styles.pager} aria-label={`Pages of ${what}`}>
      <span className="small muted num" role="status">
        {page * size + 1} to {Math.min(total, (page + 1) * size)} of {total} {what}
      </span>
      <Button variant="default" disabled={page === 0} onClick={() => onPage(page - 1)}>Previous</Button>
      <Button variant="default" disabled={page >= last} onClick={() => onPage(page + 1)}>Next</Button>
    </nav>
  );
}
