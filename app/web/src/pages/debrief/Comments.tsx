import {Button, Textarea, TextInput} from '@mantine/core';
import {useState, type FormEvent} from 'react';
import {EmptyState} from '../../parts/EmptyState';
import {Panel} from '../../parts/Panel';
import {Problem} from '../../parts/Problem';
import {useSignedIn} from '../../parts/api';
import {formatClock, formatWhen} from '../../parts/format';
import {useAction} from '../../parts/use_action';
import type {Comment, Debrief} from '../../wire/types';
import {commentProblem, lastMoment, readTrialTime} from './judgement';
import styles from './judgement.module.css';

interface Props {
  debrief: Debrief;
  onChange: (debrief: Debrief) => void;
}

/** What instructors wrote about a trial; whoever may judge it writes here too. */
export function Comments({debrief, onChange}: Props) {
  const {trial, comments} = debrief;
  const {api} = useSignedIn();
  const {busy, problem, run} = useAction();
  if (comments.length === 0 && !debrief.may_judge) return null;
  const takeBack = (comment: Comment) => run(async () => {
    await api.withdrawComment(trial.trial_id, comment.id);
    return api.trial(trial.trial_id);
  }, onChange);
  return (
    <Panel title="Comments" aside={String(comments.length)}>
      <div className={debrief.may_judge ? styles.comments : undefined}>
        <div>
          {comments.length === 0
            ? <EmptyState title="No comment yet">{debrief.person_name} reads here what you write.</EmptyState>
            : (
              <ul className={styles.list} aria-label="Comments">
                {comments.map((comment) => (
                  <li key={comment.id}>
                    <div className={`xs faint num ${styles.by}`}>
                      <span className="strong">{comment.time_s === null ? 'The whole trial' : `At ${formatClock(comment.time_s)}`}</span>
                      <span>{comment.author}, {formatWhen(comment.written_utc)}</span>
                      {comment.own && (
                        <Button variant="subtle" size="compact-xs" disabled={busy} onClick={() => takeBack(comment)}
                          aria-label={`Take back: ${comment.text}`}>
                          Take back
                        </Button>
                      )}
                    </div>
                    <p className={styles.words}>{comment.text}</p>
                  </li>
                ))}
              </ul>
            )}
          <Problem sentence={problem} />
        </div>
        {debrief.may_judge && <Write debrief={debrief} onChange={onChange} />}
      </div>
    </Panel>
  );
}

function Write({debrief, onChange}: Props) {
  const {trial, events} = debrief;
  const {api} = useSignedIn();
  const {busy, problem, run} = useAction();
  const [text, setText] = useState('');
  const [time, setTime] = useState('');
  const [tried, setTried] = useState(false);
  const wrongText = commentProblem(text);
  const at = readTrialTime(time, lastMoment(trial.time_s, events));
  const write = (event: FormEvent) => {
    event.preventDefault();
    setTried(true);
    if (wrongText !== '' || 'problem' in at) return;
    run(async () => {
      await api.comment(trial.trial_id, {text: text.trim(), time_s: at.time_s});
      // written: the words must not be sent again when only the reading fails
      setText('');
      setTime('');
      setTried(false);
      return api.trial(trial.trial_id);
    }, onChange);
  };
  return (
    <form className={styles.write} onSubmit={write} noValidate>
      <Textarea label="Comment" autosize minRows={3} maxRows={10} value={text} error={tried && wrongText !== '' ? wrongText : undefined}
        onChange={(event) => setText(event.currentTarget.value)} />
      <TextInput label="At, minutes:seconds" description="Empty: about the whole trial" placeholder="1:23" className={styles.time}
        value={time} error={tried && 'problem' in at ? at.problem : undefined}
        onChange={(event) => setTime(event.currentTarget.value)} />
      <div><Button type="submit" variant="default" loading={busy}>Write comment</Button></div>
      <Problem sentence={problem} />
    </form>
  );
}
