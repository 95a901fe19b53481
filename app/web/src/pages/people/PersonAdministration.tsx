import {Button, NativeSelect, NumberInput, TagsInput, TextInput} from '@mantine/core';
import {useState} from 'react';
import {Confirm} from '../../parts/Confirm';
import {Loaded} from '../../parts/Loaded';
import {Panel} from '../../parts/Panel';
import {levelChoices, roles, roleWord} from '../../parts/PersonFacts';
import {Problem} from '../../parts/Problem';
import {State, type StateName} from '../../parts/State';
import {useResource, useSignedIn} from '../../parts/api';
import {formatCount, formatWhen} from '../../parts/format';
import {useAction} from '../../parts/use_action';
import type {ChangePerson, ExperienceRow, Level, MembershipRow, PersonDetail, PersonRow} from '../../wire/types';
import styles from './administration.module.css';
import {LinkDialog} from './LinkDialog';
import {useCurriculumChoices, useGroupNames} from './use_choices';

interface Props {
  personId: string;
  /** The rest of the page shows the same person. */
  onChanged: (person: PersonRow) => void;
}

/** What only an administrator sees of a person: the account, groups, experience and curriculum. */
export function PersonAdministration({personId, onChanged}: Props) {
  const resource = useResource(`person ${personId}`, (api) => api.person(personId));
  return (
    <Loaded resource={resource} what="the account">
      {(detail) => <Editable first={detail} onChanged={onChanged} />}
    </Loaded>
  );
}

/** Sends a change and takes what the server made of it. */
type Change = (part: ChangePerson, done?: () => void) => void;

function Editable({first, onChanged}: {first: PersonDetail; onChanged: Props['onChanged']}) {
  const {api} = useSignedIn();
  const [detail, setDetail] = useState(first);
  const action = useAction();
  const take = (changed: PersonDetail) => {
    setDetail(changed);
    onChanged(changed.person);
  };
  const change: Change = (part, done) => action.run(() => api.changePerson(detail.person.person_id, part), (changed) => {
    take(changed);
    done?.();
  });
  const refresh = () => action.run(() => api.person(detail.person.person_id), take);
  return (
    <section className={styles.sections} aria-label="Account and experience">
      <Account detail={detail} busy={action.busy} problem={action.problem} change={change} onLinkMade={refresh} />
      <div className="stack">
        <Experience detail={detail} busy={action.busy} change={change} />
        <Memberships memberships={detail.memberships} />
      </div>
    </section>
  );
}

function accountState(detail: PersonDetail): StateName {
  if (detail.person.disabled) return 'disabled';
  return detail.can_sign_in ? 'active' : 'invited';
}

function accountSentence(detail: PersonDetail): string {
  if (detail.person.disabled) return 'Cannot sign in. Trials and results are kept.';
  if (detail.can_sign_in) {
    const last = detail.last_sign_in_utc ?? null;
    return last === null ? 'Has a password and can sign in.' : `Signed in last: ${formatWhen(last)}.`;
  }
  if (detail.invitation_expires_utc === null) return 'Has no password and no link that works. Make a new link.';
  return new Date(detail.invitation_expires_utc) < new Date()
    ? `The link ended ${formatWhen(detail.invitation_expires_utc)}. Make a new one.`
    : `The link works until ${formatWhen(detail.invitation_expires_utc)}.`;
}

interface AccountProps {
  detail: PersonDetail;
  busy: boolean;
  problem: string;
  change: Change;
  onLinkMade: () => void;
}

function Account({detail, busy, problem, change, onLinkMade}: AccountProps) {
  const {session} = useSignedIn();
  const {person} = detail;
  const own = session.person_id === person.person_id;
  const [asking, setAsking] = useState<'disable' | 'link' | null>(null);
  return (
    <Panel title="Account" aside={<>made: {formatWhen(detail.created_utc)}</>}>
      <div className={styles.account}>
        <div className={styles.state}>
          <State state={accountState(detail)} />
          <span className="small muted num">{accountSentence(detail)}</span>
        </div>
        <Details key={JSON.stringify([person.display_name, detail.email, person.role, person.groups, detail.curriculum_id])}
          detail={detail} own={own} busy={busy} change={change} />
        <Problem sentence={problem} />
        <div className={styles.buttons}>
          <Button variant="default" disabled={person.disabled} onClick={() => setAsking('link')}>New link</Button>
          {person.disabled
            ? <Button variant="default" loading={busy} onClick={() => change({disabled: false})}>Enable</Button>
            : <Button variant="default" disabled={own} onClick={() => setAsking('disable')}>Disable</Button>}
          <span className="small faint">
            {own ? 'You cannot disable yourself.' : person.disabled ? 'Enable the account before you make a link.' : `Signs in as ${person.name}.`}
          </span>
        </div>
      </div>
      {asking === 'disable' && <Confirm title={`Disable ${person.display_name}?`} action="Disable" busy={busy} problem={problem}
        onClose={() => setAsking(null)} onConfirm={() => change({disabled: true}, () => setAsking(null))}>
        <ul className={styles.what}>
          <li>{person.display_name} is signed out at once and cannot sign in again.</li>
          <li>A link that was not used stops working.</li>
          <li>Trials, results, groups and experience stay as they are.</li>
          <li>You can enable the account again at any time.</li>
        </ul>
      </Confirm>}
      {asking === 'link' && <LinkDialog detail={detail} onClose={(made) => {
        setAsking(null);
        if (made) onLinkMade();
      }} />}
    </Panel>
  );
}

interface DetailsProps {
  detail: PersonDetail;
  own: boolean;
  busy: boolean;
  change: Change;
}

// Saved together, so that a slip is one Undo away and the audit log gets one row.
function Details({detail, own, busy, change}: DetailsProps) {
  const groups = useGroupNames();
  const curricula = useCurriculumChoices();
  const before = {
    display_name: detail.person.display_name, email: detail.email, role: detail.person.role, groups: detail.person.groups,
    curriculum_id: detail.curriculum_id,
  };
  const [now, setNow] = useState(before);
  const edit = (part: Partial<typeof before>) => setNow((known) => ({...known, ...part}));
  const changed = (Object.keys(before) as (keyof typeof before)[]).filter((key) => JSON.stringify(now[key]) !== JSON.stringify(before[key]));
  const save = () => change(Object.fromEntries(changed.map((key) => [key, now[key]])));
  const known = curricula.some(({value}) => value === (now.curriculum_id ?? ''));
  return (
    <form className={styles.fields} onSubmit={(event) => {
      event.preventDefault();
      save();
    }}>
      <TextInput label="Full name" required withAsterisk={false} maxLength={120} value={now.display_name}
        onChange={({currentTarget: {value}}) => edit({display_name: value})} />
      <TextInput label="E-mail" type="email" value={now.email} onChange={({currentTarget: {value}}) => edit({email: value})} />
      <NativeSelect label="Role" disabled={own} value={now.role} data={roles.map((role) => ({value: role, label: roleWord(role)}))}
        inputWrapperOrder={['label', 'input', 'description']} description={own ? 'Another administrator can change yours' : undefined}
        onChange={({currentTarget: {value}}) => edit({role: value as PersonRow['role']})} />
      <NativeSelect label="Curriculum" value={now.curriculum_id ?? ''}
        inputWrapperOrder={['label', 'input', 'description']}
          description={detail.curriculum_title === '' ? undefined : `Trains by ${detail.curriculum_title}`}
        data={known || now.curriculum_id === null ? curricula : [...curricula, {value: now.curriculum_id, label: detail.curriculum_title}]}
        onChange={({currentTarget: {value}}) => edit({curriculum_id: value === '' ? null : value})} />
      <TagsInput className={styles.wide} label="Groups" description="An instructor sees the people of the own groups" data={groups}
        value={now.groups} onChange={(value) => edit({groups: value})} splitChars={[',', ';', '|']} acceptValueOnBlur inputWrapperOrder={['label', 'input', 'description']} />
      <div className={styles.save}>
        <Button type="submit" loading={busy} disabled={changed.length === 0}>Save</Button>
        <Button variant="default" disabled={changed.length === 0} onClick={() => setNow(before)}>Undo</Button>
        <span className="small faint">{changed.length === 0 ? 'Nothing is changed.' : 'Joining and leaving groups is dated today.'}</span>
      </div>
    </form>
  );
}

// Dated: a level declared today leaves last year's results where they were.
function Experience({detail, busy, change}: {detail: PersonDetail; busy: boolean; change: Change}) {
  const latest = detail.experience[0];
  const [level, setLevel] = useState<Level>(latest?.level ?? 'novice');
  const [cases, setCases] = useState<number>(latest?.cases ?? 0);
  const same = latest !== undefined && latest.level === level && latest.cases === cases;
  return (
    <Panel title="Experience" aside="dated; earlier results keep their level">
      {detail.experience.length === 0
        ? <p className="small muted">No level has been declared yet.</p>
        : <History rows={detail.experience} />}
      <form className={styles.declare} onSubmit={(event) => {
        event.preventDefault();
        change({level, cases});
      }}>
        <NativeSelect label="Level from today" value={level} data={[...levelChoices]}
          onChange={({currentTarget: {value}}) => setLevel(value as Level)} />
        <NumberInput label="Procedures done" min={0} max={100_000} allowDecimal={false} allowNegative={false} value={cases}
          onChange={(value) => setCases(typeof value === 'number' ? value : 0)} />
        <Button type="submit" variant="default" loading={busy} disabled={same}>Declare</Button>
      </form>
    </Panel>
  );
}

function History({rows}: {rows: readonly ExperienceRow[]}) {
  return (
    <div className="table-scroll">
      <table className="table">
        <thead>
          <tr><th scope="col">Level</th><th scope="col" className="r">Procedures</th><th scope="col">Declared</th><th scope="col">By</th></tr>
        </thead>
        <tbody>
          {rows.map((row, index) => (
            <tr key={`${row.declared_utc} ${index}`}>
              <th scope="row">{levelChoices.find(({value}) => value === row.level)?.label}{index === 0 && <> <span className="tag">now</span></>}</th>
              <td className="r">{row.cases}</td>
              <td className="muted">{formatWhen(row.declared_utc)}</td>
              <td className="muted">{row.declared_by}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Memberships({memberships}: {memberships: readonly MembershipRow[]}) {
  return (
    <Panel title="Groups over time" aside={formatCount(memberships.filter(({to_utc}) => to_utc === null).length, 'group') + ' now'}>
      {memberships.length === 0
        ? <p className="small muted">Never in a group. Only administrators see this person.</p>
        : (
          <div className="table-scroll">
            <table className="table">
              <thead><tr><th scope="col">Group</th><th scope="col">Joined</th><th scope="col">Left</th></tr></thead>
              <tbody>
                {memberships.map((row) => (
                  <tr key={`${row.group} ${row.from_utc}`}>
                    <th scope="row">{row.group}</th>
                    <td className="muted">{formatWhen(row.from_utc)}</td>
                    <td className="muted">{row.to_utc === null ? '–' : formatWhen(row.to_utc)}</td>
                  </tr>
                ))}
              </tbody>
            </table>
          </div>
        )}
    </Panel>
  );
}
