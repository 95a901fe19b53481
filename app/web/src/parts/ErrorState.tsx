import {Button} from '@mantine/core';
import {Icon} from './Icon';
import styles from './notices.module.css';

interface Props {
  problem: Error;
  onRetry?: (() => void) | undefined;
}

/** What went wrong, in the server's sentence, and the way on. */
export function ErrorState({problem, onRetry}: Props) {
  return (
    <section className={`panel ${styles.notice}`} role="alert">
      <h1 className="state tone-bad"><Icon name="octagon" />This did not work</h1>
      <p>{problem.message}</p>
      {onRetry && <Button variant="default" onClick={onRetry}>Try again</Button>}
    </section>
  );
}
