import {Icon} from './Icon';
import styles from './notices.module.css';

/** A refusal beside what was refused. The place is there before the sentence, so that it is read out. */
export function Problem({sentence}: {sentence: string}) {
  return (
    <div role="alert">
      {sentence !== '' && <p className={`tone-bad ${styles.problem}`}><Icon name="octagon" />{sentence}</p>}
    </div>
  );
}
