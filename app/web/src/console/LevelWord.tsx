import {Icon} from '../parts/Icon';
import styles from './LevelWord.module.css';
import type {Level} from './readings';

/** Sign and word of a level; nothing while all is well. */
export function LevelWord({level, over = 'limit reached'}: {level: Level; over?: string}) {
  if (level === 'ok') return null;
  return (
    <span className={styles.word} data-level={level}>
      <Icon name={level === 'near' ? 'triangle' : 'octagon'} />
      {level === 'near' ? 'near limit' : over}
    </span>
  );
}
