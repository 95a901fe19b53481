import {Icon} from '../parts/Icon';
import styles from './shell.module.css';

export function DemoBanner() {
  return (
    <aside className={styles.demo} aria-label="Demo">
      <Icon name="info" />
      <p><strong>Demo.</strong> Example people and published data; simulated operators are labelled. Use no real names here.</p>
    </aside>
  );
}
