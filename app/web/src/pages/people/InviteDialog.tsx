import {Button, NativeSelect, NumberInput, TagsInput, TextInput} from '@mantine/core';
import {useId, useState, type FormEvent} from 'react';
import {Dialog} from '../../parts/Dialog';
import {OneTimeLink} from '../../parts/OneTimeLink';
import {levelChoices, roles, roleWord} from '../../parts/PersonFacts';
import {Problem} from '../../parts/Problem';
import {useSignedIn} from '../../parts/api';
import {suggestedName} from '../../parts/sign_in_name';
import {useAction} from '../../parts/use_action';
import type {Invitation, InvitePerson} from '../../wire/types';
import styles from '../people.module.css';
import {useCurriculumChoices, useGroupNames} from './use_choices';

/** Adds a person and shows the link by which they set their password. invited: at least one was added. */
export function InviteDialog({onClose}: {onClose: (invited: boolean) => void}) {
  const [invitation, setInvitation] = useState<Invitation | null>(null);
  const [count, setCount] = useState(0);
  const close = () => onClose(count > 0);
  const take = (made: Invitation) => {
    setInvitation(made);
    setCount((before) => before + 1);
  };
  if (invitation === null) return <Form key={count} onCancel={close} onInvited={take} />;
  return (
    <Dialog key={invitation.person_id} title={`${invitation.display_name} is invited`} onClose={close} actions={(
      <>
        <Button variant="default" onClick={close}>Done</Button>
        <Button variant="default" onClick={() => setInvitation(null)}>Invite another</Button>
      </>
    )}>
      <OneTimeLink invitation={invitation} />
    </Dialog>
  );
}

const empty: InvitePerson = {
  name: '', display_name: '', email: '', role: 'trainee', level: 'novice', cases: 0, groups: [], curriculum_id: null,
};

function Form({onCancel, onInvited}: {onCancel: () => void; onInvited: (invitation: Invitation) => void}) {
  const {api} = useSignedIn();
  const action = useAction();
  const groups = useGroupNames();
  const curricula = useCurriculumChoices();
  const [person, setPerson] = useState(empty);
  const [ownName, setOwnName] = useState(false);
  const change = (part: Partial<InvitePerson>) => setPerson((before) => ({...before, ...part}));
  const submit = (event: FormEvent) => {
    event.preventDefault();
    const trimmed = {...person, name: person.name.trim(), display_name: person.display_name.trim(), email: person.email.trim()};
    action.run(() => api.invitePerson(trimmed), onInvited);
  };
  const trains = person.role === 'trainee';
  const form = useId();
  return (
    <Dialog title="Invite a person" onClose={onCancel} actions={(
      <>
        <Button type="submit" form={form} loading={action.busy}>Make the link</Button>
        <Button variant="default" onClick={onCancel}>Cancel</Button>
      </>
    )}>
      <form id={form} className={styles.form} onSubmit={submit}>
        <div className={styles.fields}>
          <TextInput label="Full name" required withAsterisk={false} autoFocus autoComplete="off" maxLength={120} value={person.display_name}
            onChange={({currentTarget: {value}}) => change({display_name: value, ...(ownName ? {} : {name: suggestedName(value)})})} />
          <TextInput label="Sign-in name" required withAsterisk={false} autoComplete="off" maxLength={64} value={person.name}
            onChange={({currentTarget: {value}}) => {
              setOwnName(value !== '');
              change({name: value});
            }} />
          <NativeSelect label="Role" value={person.role} data={roles.map((role) => ({value: role, label: roleWord(role)}))}
            onChange={({currentTarget: {value}}) => {
              const role = value as InvitePerson['role'];
              change({role, level: role === 'trainee' ? 'novice' : null, cases: 0});
            }} />
          <TextInput label="E-mail, if you want it on record" type="email" autoComplete="off" value={person.email}
            onChange={({currentTarget: {value}}) => change({email: value})} />
          <NativeSelect label="Level today" value={person.level ?? ''} onChange={({currentTarget: {value}}) => change({
            level: value === '' ? null : value as NonNullable<InvitePerson['level']>, ...(value === '' ? {cases: 0} : {})})}
            data={[{value: '', label: 'Not declared'}, ...levelChoices]} />
          <NumberInput label="Procedures done" min={0} max={100_000} allowDecimal={false} allowNegative={false} disabled={person.level === null}
            value={person.cases} onChange={(value) => change({cases: typeof value === 'number' ? value : 0})} />
          <TagsInput className={styles.wide} label="Groups" description="Enter or a comma ends a name; a new name makes a new group" data={groups}
            value={person.groups} onChange={(value) => change({groups: value})} splitChars={[',', ';', '|']} acceptValueOnBlur comboboxProps={{withinPortal: false}} />
          {trains && (
            <NativeSelect className={styles.wide} label="Curriculum" value={person.curriculum_id ?? ''} data={curricula}
              onChange={({currentTarget: {value}}) => change({curriculum_id: value === '' ? null : value})} />
          )}
        </div>
        <Problem sentence={action.problem} />
      </form>
    </Dialog>
  );
}
