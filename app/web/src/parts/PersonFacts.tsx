import type {Level, PersonRow, Role} from '../wire/types';

const kinds: Readonly<Record<PersonRow['kind'], string>> = {
  live: '', simulated: 'Simulated operator', published: 'Published data',
};

/** The label that says a person is none: a simulated operator or a row of a paper. */
export function KindTag({kind}: {kind: PersonRow['kind']}) {
  return kind === 'live' ? null : <span className="tag">{kinds[kind]}</span>;
}

export function levelWord(level: PersonRow['level']): string {
  return level === null ? 'not set' : level;
}

const roleWords: Readonly<Record<Role, string>> = {
  trainee: 'Trainee', instructor: 'Instructor', administrator: 'Administrator', researcher: 'Researcher',
};

export const roles = Object.keys(roleWords) as Role[];

export function roleWord(role: Role): string {
  return roleWords[role];
}

export const levelChoices: readonly {value: Level; label: string}[] = [
  {value: 'novice', label: 'Novice'}, {value: 'intermediate', label: 'Intermediate'}, {value: 'expert', label: 'Expert'},
];
