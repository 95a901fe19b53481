import {moveItem, removeItem, setValue} from '../yaml/edit';
import type {Path} from '../yaml/source';
import {useForm} from './form_desk';
import styles from './form.module.css';

interface Props {
  list: Path;
  index: number;
  count: number;
  what: string;
  whenEmpty?: 'drop' | 'keep';
  onDuplicate?: () => void;
  /** Goes with the last item. */
  whole?: Path;
}

/** Up, down, copy, away: what one can do with an item of a list. */
export function ListTools({list, index, count, what, whenEmpty = 'drop', onDuplicate, whole}: Props) {
  const form = useForm();
  const move = (to: number) => form.edit((source) => moveItem(source, list, index, to));
  return (
    <span className={styles.tools}>
      <Tool label={`Move ${what} up`} path="M8 12.5V4M4.5 7L8 3.5 11.5 7" off={form.frozen || index === 0} onClick={() => move(index - 1)} />
      <Tool label={`Move ${what} down`} path="M8 3.5V12M4.5 9L8 12.5 11.5 9" off={form.frozen || index === count - 1} onClick={() => move(index + 1)} />
      {onDuplicate && <Tool label={`Duplicate ${what}`} path="M5.5 5.5h7v7h-7zM3.5 10.5v-7h7" off={form.frozen} onClick={onDuplicate} />}
      <Tool label={`Remove ${what}`} path="M4 4l8 8M12 4l-8 8" off={form.frozen}
        onClick={() => form.edit((source) => (whole && count === 1 ? setValue(source, whole, undefined) : removeItem(source, list, index, whenEmpty)))} />
    </span>
  );
}

function Tool({label, path, off, onClick}: {label: string; path: string; off: boolean; onClick: () => void}) {
  return (
    <button type="button" className={styles.tool} aria-label={label} title={label} disabled={off} onClick={onClick}>
      <svg className="icon" viewBox="0 0 16 16" aria-hidden="true"><path d={path} /></svg>
    </button>
  );
}
