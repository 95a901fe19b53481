// The fields of the form. Each one shows a place of the text and changes only that place.
import {Checkbox, NativeSelect, Textarea, TextInput} from '@mantine/core';
import {useId, useState, type ReactNode} from 'react';
import {Icon} from '../../parts/Icon';
import {sentenceOf} from '../text/problem_words';
import {replacePair, setValue, setWords} from '../yaml/edit';
import {nodeAt, type Path, type Value} from '../yaml/source';
import {writeNumber} from '../yaml/write';
import {pathId, useForm, useMarks, useValue, wordsOf} from './form_desk';
import type {FormMark} from './form_marks';
import styles from './form.module.css';

interface FieldProps {
  path: Path;
  label: string;
  /** In a row: the label is for screen readers, and the row shows the sentences. */
  inRow?: boolean;
  /** The keys of the map in the order of the format: where a missing one is put. */
  order?: readonly string[];
  description?: ReactNode;
}

/** The sentence of a problem, its line, and its repair. */
export function Sentences({marks, id}: {marks: readonly FormMark[]; id?: string}) {
  const form = useForm();
  if (marks.length === 0) return null;
  return (
    <span className={styles.sentences} id={id}>
      {marks.map((one) => {
        const {problem} = one.mark;
        return (
          <span key={`${one.line} ${problem.message}`} className={`${styles.sentence} tone-${problem.severity === 'error' ? 'bad' : 'warn'}`}>
            <Icon name={problem.severity === 'error' ? 'octagon' : 'triangle'} />
            <span>
              {sentenceOf(problem.message)}{' '}
              <button type="button" className={styles.link} onClick={() => form.goTo(one.path)}>Line {one.line}</button>
              {problem.repair && !form.frozen && (
                <button type="button" className={styles.repair} onClick={() => form.repair(one)}>{problem.repair.title}</button>
              )}
            </span>
          </span>
        );
      })}
    </span>
  );
}

function useField({path, inRow = false, label}: FieldProps) {
  const form = useForm();
  const marks = useMarks(path);
  const isBad = marks.some((one) => one.mark.problem.severity === 'error');
  const shown = inRow ? isBad : marks.length > 0 && <Sentences marks={marks} />;
  return {
    form, value: useValue(path), marks,
    props: {
      ...(inRow ? {'aria-label': label} : {label}),
      'disabled': form.frozen, 'error': shown, 'data-path': pathId(path), 'onFocus': () => form.show(path),
    },
  };
}

// What is being typed and does not yet say what the text says: "1.", or a space at the end.
function useDraft(shown: string) {
  const [draft, setDraft] = useState<{text: string; of: string} | null>(null);
  return {
    text: draft?.of === shown ? draft.text : shown,
    keep: (text: string, of: string) => setDraft({text, of}),
    forget: () => setDraft(null),
  };
}

interface TextProps extends FieldProps {
  placeholder?: string;
  /** Leaving it empty takes this place out of the text. */
  emptyRemoves?: Path;
  readOnly?: boolean;
}

export function TextField({placeholder, emptyRemoves, readOnly = false, order, description, ...field}: TextProps) {
  const {form, value, props} = useField(field);
  const shown = value === undefined || value === null ? '' : String(value);
  const draft = useDraft(shown);
  const change = (text: string) => {
    const next = text.replace(/\s+/g, ' ').trim();
    draft.keep(text, next);
    form.edit((source) => (next === '' && emptyRemoves
      ? setValue(source, emptyRemoves, undefined) : setValue(source, field.path, next, order)), 'typing');
  };
  return (
    <TextInput {...props} value={draft.text} placeholder={placeholder} readOnly={readOnly} description={description}
      onChange={(event) => change(event.currentTarget.value)} onBlur={draft.forget} />
  );
}

/** A text in English of several lines. */
export function LongTextField({order, description, ...field}: FieldProps) {
  const place = [...field.path, 'en'];
  const {form, value, props} = useField({...field, path: field.path});
  const text = typeof value === 'object' && value !== null && !Array.isArray(value) ? value.en : undefined;
  const shown = typeof text === 'string' ? text : '';
  const draft = useDraft(shown);
  const change = (typed: string) => {
    const next = typed.replace(/[^\S\n]+/g, ' ').replace(/ ?\n ?/g, '\n').trim();
    draft.keep(typed, next);
    form.edit((source) => {
      if (next === '') return setValue(source, field.path, undefined);
      const node = nodeAt(source, place) as {type?: string} | null;
      // a text that outgrows its line becomes a folded block
      const whole = next.length > 60 && node?.type?.startsWith('BLOCK') !== true;
      return whole ? setValue(source, field.path, {...(value as {[key: string]: Value} | undefined), en: next}, order) : setValue(source, place, next, order);
    }, 'typing');
  };
  return (
    <Textarea {...props} value={draft.text} autosize minRows={2} maxRows={8} description={description}
      onChange={(event) => change(event.currentTarget.value)} onBlur={draft.forget} />
  );
}

interface NumberProps extends FieldProps {
  unit?: string | undefined;
  /** May be left out of the text; shown while it is. */
  optional?: string;
}

export function NumberField({unit = '', optional, order, description, ...field}: NumberProps) {
  const {form, value, props} = useField(field);
  const shown = typeof value === 'number' ? writeNumber(value) : value === undefined || value === null ? '' : String(value);
  const draft = useDraft(shown);
  const parsed = parseNumber(draft.text);
  const change = (text: string) => {
    const next = parseNumber(text);
    if (next !== null) {
      draft.keep(text, writeNumber(next));
      form.edit((source) => setValue(source, field.path, next, order), 'typing');
    } else if (text.trim() === '' && optional !== undefined) {
      draft.forget();
      form.edit((source) => setValue(source, field.path, undefined), 'typing');
    } else {
      draft.keep(text, shown);
    }
  };
  const wrong = parsed === null && draft.text !== shown;
  return (
    <TextInput {...props} error={wrong ? (field.inRow ? true : 'Write a number, such as 2.5.') : props.error} value={draft.text} inputMode="decimal"
      autoComplete="off" placeholder={optional} description={description} classNames={{input: styles.number}}
      aria-label={field.inRow ? `${field.label}${unit === '' ? '' : `, ${unit}`}` : undefined}
      rightSection={unit === '' ? undefined : <span className="xs faint">{unit}</span>} rightSectionPointerEvents="none"
      rightSectionWidth={unit === '' ? undefined : 14 + unit.length * 8}
      onChange={(event) => change(event.currentTarget.value)} onBlur={draft.forget} />
  );
}

function parseNumber(text: string): number | null {
  const tidy = text.trim().replace(',', '.').replace('\u2212', '-');
  return /^-?(\d+\.?\d*|\.\d+)$/.test(tidy) ? Number(tidy) : null;
}

export interface Option {
  value: string;
  label: string;
}

interface ChoiceProps extends FieldProps {
  options: readonly Option[];
  /** What leaving it out of the text means. */
  absent?: string;
  onChoose?: (value: string) => void;
}

export function ChoiceField({options, absent, onChoose, order, description, ...field}: ChoiceProps) {
  const {form, value, props} = useField(field);
  const current = value === undefined || value === null ? '' : String(value);
  const known = options.some((option) => option.value === current);
  const data = [
    ...(absent !== undefined || current === '' ? [{value: '', label: absent ?? 'Choose'}] : []),
    ...options,
    ...(known || current === '' ? [] : [{value: current, label: `${current} (unknown)`}]),
  ];
  const choose = (next: string) => {
    if (onChoose) onChoose(next);
    else form.edit((source) => setValue(source, field.path, next === '' ? undefined : next, order));
  };
  return <NativeSelect {...props} value={current} data={data} description={description} onChange={(event) => choose(event.currentTarget.value)} />;
}

export function SwitchField({order, usual, ...field}: FieldProps & {usual: boolean}) {
  const {form, value, props} = useField(field);
  const on = typeof value === 'boolean' ? value : usual;
  return (
    <Checkbox {...props} label={field.label} size="sm" checked={on}
      onChange={(event) => { const {checked} = event.currentTarget; form.edit((source) => setValue(source, field.path, checked, order)); }} />
  );
}

/** Several words out of a known set. */
export function WordsField({options, order, ...field}: FieldProps & {options: readonly Option[]}) {
  const {form, value, marks} = useField(field);
  const chosen = wordsOf(value);
  const unknown = chosen.filter((word) => !options.some((option) => option.value === word)).map((word) => ({value: word, label: `${word} (unknown)`}));
  const describedBy = useId();
  const toggle = (word: string, on: boolean) =>
    form.edit((source) => setWords(source, field.path, on ? [...chosen, word] : chosen.filter((one) => one !== word), order));
  return (
    <fieldset className={styles.words} aria-describedby={marks.length > 0 ? describedBy : undefined}>
      <legend className={styles.label}>{field.label}</legend>
      {[...options, ...unknown].map((option, index) => (
        <Checkbox key={option.value} size="xs" label={option.label} checked={chosen.includes(option.value)} disabled={form.frozen}
          data-path={index === 0 ? pathId(field.path) : undefined}
          onFocus={() => form.show(field.path)} onChange={(event) => toggle(option.value, event.currentTarget.checked)} />
      ))}
      <Sentences marks={marks} id={describedBy} />
    </fieldset>
  );
}

/** Two keys of which one stands there: a value of one's own, or a benchmark. */
export function switchKey(form: ReturnType<typeof useForm>, map: Path, from: string, to: string, value: Value): void {
  form.edit((source) => (nodeAt(source, [...map, from]) === null
    ? setValue(source, [...map, to], value) : replacePair(source, map, from, to, value)));
}

/** Under a row: what is wrong with any of its fields. */
export function RowProblems({path}: {path: Path}) {
  const marks = useMarks(path);
  return marks.length === 0 ? null : <div className={styles.rowProblems}><Sentences marks={marks} /></div>;
}
